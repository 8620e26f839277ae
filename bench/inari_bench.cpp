// inari, whose loops over the arrays are its own.
#include "inari_library.hpp"
#include "measure.hpp"

namespace graze::bench {

namespace {
using numbers = std::vector<inari_number>;

numbers numbers_of(const std::vector<ends>& from) {
  numbers to;
  for (const ends& e : from)
    to.push_back(inari_library::get().make(e.lower, e.upper));
  return to;
}

/// function(n, x, y, r).
template <class Function>
void measure_arrays(const std::string& name, operands kind, Function function) {
  const auto time = [=](benchmark::State& state) {
    const numbers x = numbers_of(make(kind, 1)), y = numbers_of(make(kind, 2));
    numbers r(size);
    for ([[maybe_unused]] auto pass : state) {
      function(size, x.data(), y.data(), r.data());
      benchmark::ClobberMemory();
    }
  };
  const auto answers = [=](const std::vector<ends>& a, const std::vector<ends>& b,
                           const std::vector<ends>&) {
    const numbers x = numbers_of(a), y = numbers_of(b);
    numbers r(a.size());
    function(a.size(), x.data(), y.data(), r.data());
    std::vector<enclosure> all;
    for (const inari_number& v : r)
      all.push_back({inari_library::get().lower(v), inari_library::get().upper(v)});
    return all;
  };
  enlist(name, kind, "inari", false, time, answers);
}
} // namespace

std::string measure_inari() {
  const inari_library& library = inari_library::get();
  if (!library.missing().empty())
    return "; inari (" + library.missing() + ")";
  const auto unary = [&](const std::string& name, operands kind, const char* function) {
    measure_arrays(name, kind,
                   [f = library.find_unary(function)](std::size_t n, const inari_number* x,
                                                      const inari_number*,
                                                      inari_number* r) { f(n, x, r); });
  };
  const auto binary = [&](const std::string& name, operands kind, const char* function) {
    measure_arrays(name, kind, library.find_binary(function));
  };
  for (const char* name : {"add", "sub", "mul", "div"})
    binary(name + std::string("/mixed"), operands::mixed, name);
  unary("sqr/mixed", operands::mixed, "sqr");
  unary("sqrt/positive", operands::positive, "sqrt");
  unary("log/positive", operands::positive, "log");
  for (const bool is_narrow : {true, false}) {
    const std::string set = is_narrow ? "/narrow" : "/mixed";
    const operands any = is_narrow ? operands::narrow : operands::mixed;
    const operands unit = is_narrow ? operands::unit_narrow : operands::unit;
    const operands positive = is_narrow ? operands::positive_narrow : operands::positive;
    for (const char* name : {"exp", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh"})
      unary(name + set, any, name);
    unary("log" + set, is_narrow ? positive : operands::mixed_of_logarithm, "log");
    unary("asin" + set, unit, "asin");
    unary("acos" + set, unit, "acos");
    unary("pown(x,4)" + set, any, "fourth_power");
    binary("atan2" + set, any, "atan2");
    binary("pow" + set, positive, "pow");
  }
  return "";
}

} // namespace graze::bench
