#pragma once
/// The number types that hard expressions are evaluated with: MPFR's for the true value, plain
/// double, and each interval library's. A library L has
///   number, name, scope, has          what its functions are
///   constant(x)                       an exact number: enclosed; rounded to nearest by double
///   make(lower, upper)                an interval; its middle for double
///   lower(x), upper(x)                the answer's ends, equal for double
#include <boost/multiprecision/mpfr.hpp>
#include <boost/numeric/interval.hpp>
#include <cmath>
#include <graze/functions/exponential.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/trigonometric.hpp>
#include <graze/interval.hpp>
#if defined(GRAZE_BENCH_CGAL)
#include <CGAL/Interval_nt.h>
#endif
#if defined(GRAZE_BENCH_MPFI)
#include "../mpfi_number.hpp"
#endif
#if defined(GRAZE_BENCH_ARB)
#include "../arb_number.hpp"
#endif
#include "../inari_library.hpp"

namespace graze::bench::hard {

/// What a library can do beside + - * / and square roots; an expression says what it needs.
enum class functions { none, elementary, power };

/// 1,204 decimal digits, 4,000 bits. The true values of all expressions are evaluated a second time
/// with half of them.
template <unsigned digits>
using decimal = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits>,
                                              boost::multiprecision::et_off>;
using precise = decimal<1204>;

inline double rounded(const precise& x, mpfr_rnd_t to) {
  return mpfr_get_d(x.backend().data(), to);
}

struct no_scope {
  no_scope() {}
};

template <class T>
T sqr(const T& x)
  requires requires { x* x; } && (!requires { x.lower(); }) && (!requires { x.inf(); })
{
  return x * x;
}

template <unsigned digits> struct reference {
  using number = decimal<digits>;
  static constexpr functions has = functions::power;
  static number constant(const precise& x) { return number(x); }
  static number make(double lower, double upper) { return number((lower + upper) / 2); }
};

struct plain {
  using number = double;
  using scope = no_scope;
  static constexpr const char* name = "double";
  static constexpr functions has = functions::power;
  static double constant(const precise& x) { return rounded(x, MPFR_RNDN); }
  static double make(double lower, double upper) { return (lower + upper) / 2; }
  static double lower(double x) { return x; }
  static double upper(double x) { return x; }
};

/// Of values with a constructor from two ends.
template <class Number> struct of_ends {
  using number = Number;
  using scope = no_scope;
  static Number make(double lower, double upper) { return Number(lower, upper); }
  static Number constant(const precise& x) {
    return make(rounded(x, MPFR_RNDD), rounded(x, MPFR_RNDU));
  }
  static double lower(const Number& x) { return x.lower(); }
  static double upper(const Number& x) { return x.upper(); }
};

struct graze_intervals : of_ends<interval<>> {
  static constexpr const char* name = "interval<>";
  static constexpr functions has = functions::power;
};

namespace boost_policies {
namespace lib = boost::numeric::interval_lib;
using type =
    boost::numeric::interval<double, lib::policies<lib::save_state<lib::rounded_transc_opp<double>>,
                                                   lib::checking_base<double>>>;
inline type sqr(const type& x) { return square(x); }
} // namespace boost_policies
struct boost_intervals : of_ends<boost_policies::type> {
  static constexpr const char* name = "Boost";
  static constexpr functions has = functions::elementary;
};
using boost_policies::sqr;

#if defined(GRAZE_BENCH_CGAL)
using cgal_number = CGAL::Interval_nt<true>;
inline cgal_number sqr(const cgal_number& x) { return CGAL::square(x); }
struct cgal_intervals : of_ends<cgal_number> {
  static constexpr const char* name = "CGAL";
  static constexpr functions has = functions::none;
  static double lower(const cgal_number& x) { return x.inf(); }
  static double upper(const cgal_number& x) { return x.sup(); }
};
#endif

#if defined(GRAZE_BENCH_MPFI)
struct mpfi_intervals : of_ends<mpfi_number> {
  static constexpr const char* name = "MPFI";
  static constexpr functions has = functions::elementary;
};
#endif

#if defined(GRAZE_BENCH_ARB)
struct arb_balls : of_ends<arb_number> {
  static constexpr const char* name = "Arb";
  static constexpr functions has = functions::power;
};
#endif

/// inari's interval with operators.
struct inari_value {
  inari_number value;
  inari_value(double x) : inari_value(x, x) {}
  inari_value(double lower, double upper) : value(inari_library::get().make(lower, upper)) {}
  [[nodiscard]] double lower() const { return inari_library::get().lower(value); }
  [[nodiscard]] double upper() const { return inari_library::get().upper(value); }
};
#define GRAZE_INARI_BINARY(name, function)                                                         \
  inline inari_value name(const inari_value& x, const inari_value& y) {                            \
    static const auto f = inari_library::get().find_binary(function);                              \
    inari_value r(0);                                                                              \
    f(1, &x.value, &y.value, &r.value);                                                            \
    return r;                                                                                      \
  }
GRAZE_INARI_BINARY(operator+, "add")
GRAZE_INARI_BINARY(operator-, "sub")
GRAZE_INARI_BINARY(operator*, "mul")
GRAZE_INARI_BINARY(operator/, "div")
GRAZE_INARI_BINARY(pow, "pow")
#undef GRAZE_INARI_BINARY
#define GRAZE_INARI_UNARY(name)                                                                    \
  inline inari_value name(const inari_value& x) {                                                  \
    static const auto f = inari_library::get().find_unary(#name);                                  \
    inari_value r(0);                                                                              \
    f(1, &x.value, &r.value);                                                                      \
    return r;                                                                                      \
  }
GRAZE_INARI_UNARY(sqr)
GRAZE_INARI_UNARY(sqrt)
GRAZE_INARI_UNARY(exp)
GRAZE_INARI_UNARY(log)
GRAZE_INARI_UNARY(sin)
GRAZE_INARI_UNARY(cos)
GRAZE_INARI_UNARY(tan)
#undef GRAZE_INARI_UNARY
struct inari_intervals : of_ends<inari_value> {
  static constexpr const char* name = "inari";
  static constexpr functions has = functions::power;
};

} // namespace graze::bench::hard
