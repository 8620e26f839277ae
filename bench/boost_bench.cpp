// Boost.Interval: default policies, and what its documentation advises for speed. Functions by its
// rounded_transc_opp over the C library, which is unsound (see docs/numerics.md).
#include <boost/numeric/interval.hpp>

#include "measure.hpp"

namespace graze::bench {

namespace {
namespace lib = boost::numeric::interval_lib;
template <class I> struct library {
  using number = I;
  static I constant(double lower, double upper) { return I(std::min(lower, upper), upper); }
  static void assign(I& x, const ends& e) { x = I(e.lower, e.upper); }
};
using default_interval = boost::numeric::interval<double>;
struct by_default : library<default_interval> {
  static constexpr const char* name = "Boost";
  struct scope {
    scope() {}
  };
};
struct without_protection : library<lib::unprotect<default_interval>::type> {
  static constexpr const char* name = "Boost unprotected";
  using scope = default_interval::traits_type::rounding;
};
using functions_policies =
    lib::policies<lib::save_state<lib::rounded_transc_opp<double>>, lib::checking_base<double>>;
struct with_functions : library<boost::numeric::interval<double, functions_policies>> {
  static constexpr const char* name = "Boost";
  struct scope {
    scope() {}
  };
};
} // namespace

void measure_boost() {
  measure_arithmetic<by_default>();
  measure_arithmetic<without_protection>();
  using L = with_functions;
  measure_functions<L>();
  GRAZE_MEASURE_BOTH("pown(x,4)", pow(x, 4));
}

} // namespace graze::bench
