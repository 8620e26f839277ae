// barriers: runs every snippet in every context and compares with MPFR's bounds. Exit code 0 if
// none is unsound and each is tightest. Built by each compiler with many sets of flags. With
// GRAZE_BARRIERS_BOOST it runs Boost's default policies instead and exits with 0 if some are
// unsound: the set can fail.
#include "expected.hpp"
#include "snippets.hpp"
#include <cfenv>
#include <cstdio>
#if defined(GRAZE_BARRIERS_BOOST)
#include <boost/numeric/interval.hpp>
#else
#include <graze/interval.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#endif

namespace {

/// What a user does who needs a mode: by the C library, results and operands kept from the
/// optimizer by volatile variables.
double by_c_library(int mode, double x, double y) {
  const int found = std::fegetround();
  volatile double p = x, q = y;
  std::fesetround(mode);
  volatile double r = p + q;
  std::fesetround(found);
  return r;
}

#if defined(GRAZE_BARRIERS_BOOST)

struct boost_default {
  static constexpr const char* name = "Boost's default policies";
  using interval = boost::numeric::interval<double>;
  struct scope {
    scope() {}
  };
  static double sum_in_mode_down(double x, double y) { return by_c_library(FE_DOWNWARD, x, y); }
  static double sum_in_mode_up(double x, double y) { return by_c_library(FE_UPWARD, x, y); }
  static double other_product(double x, double y) { return x * y; }
  static double user_sum_rounded_up(double x, double y) { return by_c_library(FE_UPWARD, x, y); }
  static constexpr double constant_down() { return 0x1.3333333333333p-2; }
  static constexpr double constant_up() { return 0x1.3333333333334p-2; }
};

#else

namespace rounding = graze::rounding;

struct graze_context {
  static double sum_in_mode_down(double x, double y) {
    const rounding::hardware::mode_scope scope(rounding::hardware::mode::down);
    return rounding::hardware::add(x, y);
  }
  static double sum_in_mode_up(double x, double y) {
    const rounding::hardware::mode_scope scope(rounding::hardware::mode::up);
    return rounding::hardware::add(x, y);
  }
  static double other_product(double x, double y) {
    using other = graze::interval<rounding::switching>;
    return (other(x) * other(y)).lower();
  }
  static double user_sum_rounded_up(double x, double y) { return by_c_library(FE_UPWARD, x, y); }
  static constexpr double constant_down() { return rounding::nearest::add_down(0.1, 0.2); }
  static constexpr double constant_up() { return rounding::nearest::add_up(0.1, 0.2); }
};
struct no_scope {
  no_scope() {}
};
struct with_nearest : graze_context {
  static constexpr const char* name = "interval<nearest>";
  using interval = graze::interval<>;
  using scope = no_scope;
};
struct with_upward : graze_context {
  static constexpr const char* name = "interval<upward>";
  using interval = graze::interval<rounding::upward>;
  using scope = no_scope;
};
struct with_held_upward : graze_context {
  static constexpr const char* name = "unprotected<upward>";
  using interval = graze::unprotected<rounding::upward>;
  using scope = rounding::upward::scope;
};
struct with_held_split : graze_context {
  static constexpr const char* name = "unprotected<split>";
  using interval = graze::unprotected<rounding::split>;
  using scope = rounding::split::scope;
};

#endif

struct totals {
  std::size_t snippets = 0, unsound = 0, loose = 0;
};

template <class C>
void judge(totals& t, std::size_t i, const char* name, const char* source,
           typename C::interval (*run)()) {
  const auto r = run();
  const graze::barriers::bounds& e = graze::barriers::expected[i];
  ++t.snippets;
  const bool holds = r.lower() <= e.lower && e.upper <= r.upper();
  if (holds && r.lower() == e.lower && r.upper() == e.upper)
    return;
  holds ? ++t.loose : ++t.unsound;
  if (t.loose + t.unsound <= 20)
    std::printf("%s, %s %s: %s [%a, %a], MPFR [%a, %a]\n", C::name, name, source,
                holds ? "not tightest" : "UNSOUND", r.lower(), r.upper(), e.lower, e.upper);
}

template <class C> void run_written(totals& t) {
  graze::barriers::for_each_written<C>(
      [&](std::size_t i, auto name, auto source, auto run) { judge<C>(t, i, name, source, run); });
}
template <class C> void run_all(totals& t) {
  run_written<C>(t);
  graze::barriers::for_each_crossed<C>(
      [&](std::size_t i, auto name, auto source, auto run) { judge<C>(t, i, name, source, run); });
}

} // namespace

int main() {
  using namespace graze::barriers;
  totals t;
#if defined(GRAZE_BARRIERS_BOOST)
  run_all<boost_default>(t);
  std::printf("%zu snippets with Boost's default policies: %zu unsound\n", t.snippets, t.unsound);
  return t.unsound > 0 && t.snippets == expected_count ? 0 : 1;
#else
  run_all<with_nearest>(t);
  run_all<with_held_upward>(t);
  const bool complete = t.snippets == 2 * expected_count;
  run_written<with_upward>(t);
  run_written<with_held_split>(t);
  std::printf("%zu snippets, %zu runs in 4 contexts: %zu unsound, %zu not tightest\n",
              expected_count, t.snippets, t.unsound, t.loose);
  return t.unsound == 0 && t.loose == 0 && complete ? 0 : 1;
#endif
}
