// api FILE: runs every statement of statements.hpp over every type, and compares with the judge's
// file. Exit code 0 if none is unsound and each is tightest.
// api --sweep: every statement over graze::interval<> and over Boost's class with policies<> gives
// the same, on 20,000 random pairs.
// In C++17, over the rounding policy alone; with GRAZE_API_VENDORED too, and over a copy of Boost
// in the namespace `elsewhere`. With GRAZE_API_BOOST: Boost's own rounding instead; exit code 0 if
// some are unsound (the set can fail).
#include "operands.hpp"
#if defined(GRAZE_API_VENDORED)
#include <elsewhere/numeric/interval.hpp>
#include <elsewhere/numeric/interval/io.hpp>
#include <elsewhere/numeric/interval/limits.hpp>
#define GRAZE_BOOST_NAMESPACE elsewhere
#else
#include <boost/numeric/interval.hpp>
#include <boost/numeric/interval/io.hpp>
#include <boost/numeric/interval/limits.hpp>
#endif
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#if !defined(GRAZE_API_BOOST)
#if __cplusplus > 201703L
#include <graze/interval.hpp>
#else
#include <graze/boost_functions.hpp>
#endif
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#endif
#if defined(GRAZE_API_VENDORED)
#define boost elsewhere
#endif

namespace {

using graze::api::ends;
namespace il = boost::numeric::interval_lib;
using boost::numeric::interval;

constexpr long big = (1L << 53) + 1;
__extension__ using int128 = __int128;

enum class kind { set, number, truth, ours, c_remainder };

template <class I, class F> I onto(I x, F assign) {
  assign(x);
  return x;
}
template <class I> I parts(const I& x, const I& y) {
  bool more = false;
  const I first = il::division_part1(x, y, more);
  return hull(first, il::division_part2(x, y, more));
}
template <class I> I joined(const std::pair<I, I>& halves) {
  return hull(halves.first, halves.second);
}
template <class I> std::string printed(const I& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}
/// Do the decimals of "[a,b]" enclose x? Rounding to the long double next to them keeps the order.
template <class I> bool encloses(const std::string& text, const I& x) {
  char* rest = nullptr;
  const long double lower = std::strtold(text.c_str() + 1, &rest);
  const long double upper = std::strtold(rest + 1, &rest);
  return lower <= x.lower() && x.upper() <= upper;
}

template <class P> ends to_ends(const interval<double, P>& x) { return {x.lower(), x.upper()}; }
ends to_ends(double x) { return {x, x}; }
ends to_ends(bool x) { return {x ? 1.0 : 0.0, x ? 1.0 : 0.0}; }
bool is_empty(const ends& x) { return !(x.lower <= x.upper); }
bool same(const ends& x, const ends& y) {
  return is_empty(x) ? is_empty(y) : x.lower == y.lower && x.upper == y.upper;
}

// Each statement as a function template.
#define GRAZE_STATEMENT(kind, name, code, judge)                                                   \
  template <class I> ends name([[maybe_unused]] const I& x, [[maybe_unused]] const I& y) {         \
    return to_ends(code);                                                                          \
  }
namespace statement {
#include "statements.hpp"
}
#undef GRAZE_STATEMENT

/// visit(kind, name, function) for each statement that I has.
template <class I, bool ours, class F> void for_each_statement(F visit) {
#define GRAZE_STATEMENT(kind_, name, code, judge)                                                  \
  if constexpr (ours || kind::kind_ != kind::ours)                                                 \
    visit(kind::kind_, #name, &statement::name<I>);                                                \
  else                                                                                             \
    visit(kind::kind_, #name, static_cast<ends (*)(const I&, const I&)>(nullptr));
#include "statements.hpp"
#undef GRAZE_STATEMENT
}

struct totals {
  std::size_t runs = 0, unsound = 0, loose = 0;
};

/// What holds no real number is empty to the types under test; Boost's would keep [inf, inf].
template <class I> I to_interval(const ends& x) {
  return is_empty(x) ? I::empty() : I(x.lower, x.upper);
}

template <class I, bool ours = true, bool c_remainder = true>
void judge(totals& t, const char* type, const graze::api::expectations& e) {
  const std::size_t count = e.operands.size();
  std::size_t index = 0;
  for_each_statement<I, ours>([&](kind k, const char* name, ends (*run)(const I&, const I&)) {
    const ends* expected = &e.expected.at(count * index++ + count - 1) - (count - 1);
    if (run == nullptr || (k == kind::c_remainder && !c_remainder))
      return;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [x, y] = e.operands[i];
      if ((k == kind::number || k == kind::truth) && (is_empty(x) || is_empty(y)))
        continue;
      const ends r = run(to_interval<I>(x), to_interval<I>(y)), right = expected[i];
      ++t.runs;
      if (same(r, right))
        continue;
      const bool holds = is_empty(right) || (r.lower <= right.lower && right.upper <= r.upper);
      const bool sound = holds && k != kind::number && k != kind::truth;
      ++(sound ? t.loose : t.unsound);
      if (t.loose + t.unsound <= 20)
        std::printf("%s, %s: %s\n  x = [%a, %a], y = [%a, %a]\n  [%a, %a], MPFR [%a, %a]\n", type,
                    name, sound ? "not tightest" : "UNSOUND", x.lower, x.upper, y.lower, y.upper,
                    r.lower, r.upper, right.lower, right.upper);
    }
  });
  if (count * index != e.expected.size())
    std::printf("%s: the file is of other statements\n", type), ++t.unsound;
}

#if !defined(GRAZE_API_BOOST)

namespace rounding = graze::rounding;

template <class B>
using swapped = interval<double, il::policies<graze::boost_rounding<B>, il::checking_base<double>>>;

void judge_all(totals& t, const graze::api::expectations& e) {
  using rounding::held, rounding::nearest, rounding::split, rounding::switching, rounding::upward;
  judge<swapped<nearest>>(t, "boost_rounding<nearest>", e);
  judge<swapped<upward>>(t, "boost_rounding<upward>", e);
  {
    [[maybe_unused]] const upward::scope scope;
    judge<typename il::unprotect<swapped<upward>>::type, true, false>(t, "unprotect<upward>", e);
  }
#if defined(GRAZE_API_EVERY_TYPE)
  judge<swapped<split>>(t, "boost_rounding<split>", e);
  judge<swapped<switching>>(t, "boost_rounding<switching>", e);
#endif
#if __cplusplus > 201703L
  judge<graze::interval<>>(t, "interval<>", e);
  judge<graze::interval<upward>>(t, "interval<upward>", e);
  judge<interval<double, graze::policies<>>>(t, "policies<nearest>", e);
  {
    [[maybe_unused]] const upward::scope scope;
    judge<graze::unprotected<upward>>(t, "unprotected<upward>", e);
  }
#if defined(GRAZE_API_EVERY_TYPE)
  judge<interval<double, il::policies<graze::boost_rounding<>, graze::checking>>>(
      t, "boost_rounding<nearest>, graze::checking", e);
  judge<interval<double, graze::policies<upward>>>(t, "policies<upward>", e);
  judge<interval<double, graze::policies<split>>>(t, "policies<split>", e);
  judge<interval<double, graze::policies<switching>>>(t, "policies<switching>", e);
  [[maybe_unused]] const split::scope scope;
  judge<graze::unprotected<split>>(t, "unprotected<split>", e);
#endif
#endif
}

#if __cplusplus > 201703L

/// Bounds of any exponent, a zero or infinity now and then, some flat, a few empty.
ends random_ends(std::mt19937_64& bits) {
  const auto number = [&]() -> double {
    if (bits() % 16 == 0)
      return bits() % 2 == 0 ? 0 : std::numeric_limits<double>::infinity();
    const int range = bits() % 2 == 0 ? 8 : 1060;
    const double size = std::ldexp(1 + std::ldexp(static_cast<double>(bits() >> 12), -52),
                                   static_cast<int>(bits() % (2 * range)) - range);
    return (bits() & 1) != 0 ? size : -size;
  };
  double a = number(), b = bits() % 8 == 0 ? a : number();
  if (a > b && bits() % 32 != 0)
    std::swap(a, b);
  const graze::interval<> x(a, b);
  return {x.lower(), x.upper()};
}

int sweep() {
  using I = graze::interval<>;
  using J = interval<double, graze::policies<>>;
  std::vector<ends (*)(const I&, const I&)> of_i;
  for_each_statement<I, true>([&](kind, const char*, auto run) { of_i.push_back(run); });
  std::mt19937_64 bits(1);
  std::vector<graze::api::pair_of_operands> pairs(20000);
  for (auto& [x, y] : pairs)
    x = random_ends(bits), y = random_ends(bits);
  std::size_t index = 0, runs = 0, different = 0;
  // a sum of the empty [inf, inf] may stay so, where one instruction adds: AVX-512
  const auto no_number = [](const ends& x) {
    return is_empty(x) || (x.lower == x.upper && std::isinf(x.lower));
  };
  const auto is_set = [](kind k) { return k != kind::number && k != kind::truth; };
  for_each_statement<J, true>([&](kind k, const char* name, auto run) {
    const auto other = of_i[index++];
    for (const auto& [x, y] : pairs) {
      const ends a = other(to_interval<I>(x), to_interval<I>(y));
      const ends b = run(to_interval<J>(x), to_interval<J>(y));
      ++runs;
      if (!same(a, b) && !(is_set(k) && no_number(a) && no_number(b)) && ++different <= 20)
        std::printf("%s, x = [%a, %a], y = [%a, %a]: [%a, %a] and [%a, %a]\n", name, x.lower,
                    x.upper, y.lower, y.upper, a.lower, a.upper, b.lower, b.upper);
    }
  });
  std::printf("%zu statements, %zu runs: %zu different\n", index, runs, different);
  return different == 0 ? 0 : 1;
}

#endif
#endif

} // namespace

int main(int argc, char** argv) {
#if !defined(GRAZE_API_BOOST) && __cplusplus > 201703L
  if (argc == 2 && std::strcmp(argv[1], "--sweep") == 0)
    return sweep();
#endif
  graze::api::expectations e;
  if (argc != 2 || !graze::api::read(argv[1], e) || e.operands.empty()) {
    std::fprintf(stderr, "usage: api FILE | --sweep\n");
    return 2;
  }
  totals t;
#if defined(GRAZE_API_BOOST)
  using rounding = il::save_state<il::rounded_transc_opp<double>>;
  judge<interval<double, il::policies<rounding, il::checking_base<double>>>, false>(
      t, "Boost's rounding", e);
  std::printf("%zu runs: %zu unsound, %zu not tightest\n", t.runs, t.unsound, t.loose);
  return t.unsound > 0 && t.loose > 0 ? 0 : 1;
#else
  judge_all(t, e);
  std::printf("%zu runs: %zu unsound, %zu not tightest\n", t.runs, t.unsound, t.loose);
  return t.runs > 0 && t.unsound == 0 && t.loose == 0 ? 0 : 1;
#endif
}
