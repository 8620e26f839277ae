// Boost.Interval: default policies, and what its documentation advises for speed. Functions over
// the C library's: its rounded_transc_opp, rounded_transc_std (called in the mode of the bound) and
// rounded_transc_exact (not rounded at all), all unsound (see docs/numerics.md).
#include <boost/numeric/interval.hpp>

#include "measure.hpp"

namespace graze::bench {

namespace {
namespace lib = boost::numeric::interval_lib;
template <class I> struct library {
  using number = I;
  static I constant(double lower, double upper) { return I(std::min(lower, upper), upper); }
  static void assign(I& x, const ends& e) { x = I(e.lower, e.upper); }
  static enclosure enclosed(const I& x) { return {x.lower(), x.upper()}; }
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
template <class Rounding>
using of_rounding =
    boost::numeric::interval<double, lib::policies<Rounding, lib::checking_base<double>>>;
struct with_functions : library<of_rounding<lib::save_state<lib::rounded_transc_opp<double>>>> {
  static constexpr const char* name = "Boost";
  struct scope {
    scope() {}
  };
};
struct with_standard : library<of_rounding<lib::save_state<lib::rounded_transc_std<double>>>> {
  static constexpr const char* name = "Boost std";
  struct scope {
    scope() {}
  };
};
/// Rounds nothing, arithmetic neither.
struct not_rounding : library<of_rounding<lib::save_state_nothing<
                          lib::rounded_transc_exact<double, lib::rounded_arith_exact<double>>>>> {
  static constexpr const char* name = "Boost not rounded";
  struct scope {
    scope() {}
  };
};

template <class L> void measure_boost_functions() {
  measure_functions<L>();
  GRAZE_MEASURE_BOTH("pown(x,4)", pow(x, 4));
}
} // namespace

void measure_boost() {
  measure_arithmetic<by_default>();
  measure_arithmetic<without_protection>();
  measure_boost_functions<with_functions>();
  measure_boost_functions<with_standard>();
  measure_arithmetic<not_rounding>();
  measure_boost_functions<not_rounding>();
}

} // namespace graze::bench
