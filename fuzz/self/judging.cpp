#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <graze/oracle/rounding.hpp>
#include <self/backend_operations.hpp>
#include <self/interval_operations.hpp>
#include <trial/number.hpp>

namespace graze::fuzz::self {

namespace {

/// Doubles from x to y, x <= y; infinity is the one after the largest.
std::uint64_t doubles_between(double x, double y) {
  const auto place = [](double t) {
    const auto bits = std::bit_cast<std::int64_t>(t);
    return bits < 0 ? INT64_MIN - bits : bits;
  };
  return static_cast<std::uint64_t>(place(y)) - static_cast<std::uint64_t>(place(x));
}

std::string spelled(double t) { return std::isfinite(t) ? hex(t) : fmt::format("{}", t); }

bool is_interval(const bounds& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return x.lo <= x.hi && x.lo < infinity && x.hi > -infinity;
}

std::string question(const interval_operation& operation, const interval_operands& o) {
  std::string text = operation.name + "(";
  for (unsigned i = 0; i < o.count; ++i)
    text.append(i != 0 ? ", " : "").append(text_of(o.boxes[i]));
  return text + (o.has_n ? fmt::format(", {})", o.n) : ")");
}

} // namespace

std::string text_of(const bounds& x) {
  if (x.lo != x.lo && x.hi != x.hi)
    return "[empty]";
  return fmt::format("[{}, {}]", spelled(x.lo), spelled(x.hi));
}

void compare(const std::string& operation, const bounds& right, const bounds& got,
             observations& out) {
  const auto report = [&](flaw kind, const std::string& more = "") {
    out.push_back({kind, fmt::format("{}= {}, not {}{}", operation.empty() ? "" : operation + " ",
                                     text_of(got), text_of(right), more)});
  };
  const bool is_empty = got.lo != got.lo && got.hi != got.hi;
  if (is_empty && right.is_empty())
    return;
  if (is_empty || (right.is_empty() && is_interval(got)))
    return report(flaw::wrong_empty);
  if (!is_interval(got) || !right.within(got))
    return report(flaw::unsound);
  if (got.lo == right.lo && got.hi == right.hi)
    return;
  report(flaw::loose, fmt::format(": {} and {} ulps wide of it", doubles_between(got.lo, right.lo),
                                  doubles_between(right.hi, got.hi)));
}

void compare_operation(int n, double x, double y, double got, observations& out) {
  const double right = backend_operation<oracle::mpfr>(n, x, y);
  if (right != right ? got != got : got == right && std::signbit(got) == std::signbit(right))
    return;
  const bool is_down = n % 2 == 0;
  const flaw kind = got == right ? flaw::difference
                    : is_down    ? (got < right ? flaw::loose : flaw::unsound)
                                 : (got > right ? flaw::loose : flaw::unsound);
  out.push_back(
      {kind, fmt::format("{}({}, {}) = {}, not {}", backend_operations[static_cast<unsigned>(n)],
                         spelled(x), spelled(y), spelled(got), spelled(right))});
}

namespace {
/// Each operand is {NaN, NaN} or a set.
bool well_formed(const interval_operands& o) {
  return std::all_of(o.boxes.begin(), o.boxes.begin() + o.count, [](const bounds& x) {
    return (x.lo != x.lo && x.hi != x.hi) || !checking::is_empty(x.lo, x.hi);
  });
}
} // namespace

subject subject_of(std::string name, std::string summary, std::vector<interval_operation> list) {
  subject s{std::move(name), std::move(summary), {}};
  for (interval_operation& each : list) {
    std::string part_name = each.name;
    s.parts.push_back(
        {std::move(part_name),
         [operation = std::move(each)](std::uint64_t seed, std::uint64_t index, observations& out) {
           const interval_operands o = operation.generate(seed, index);
           const std::size_t before = out.size();
           if (!operation.of_numbers && !well_formed(o)) { // of nothing that is under test
             out.push_back(
                 {flaw::meaning, question(operation, o) + " is asked of bounds that are none"});
             return;
           }
           operation.judge(o, operation.value(o), out);
           if (operation.local) {
             const decoration right = operation.right_local(o), got = operation.local(o);
             if (right != got)
               out.push_back(
                   {flaw::decoration, fmt::format("is decorated {}, not {}", static_cast<int>(got),
                                                  static_cast<int>(right))});
           }
           for (std::size_t i = before; i < out.size(); ++i)
             out[i].what = question(operation, o) + " " + out[i].what;
         }});
  }
  return s;
}

} // namespace graze::fuzz::self
