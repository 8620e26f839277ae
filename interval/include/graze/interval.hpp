#pragma once
/// Stand-in until branch interval lands: graze::unprotected<Backend>, graze::sqr.
#include <boost/numeric/interval.hpp>
#include <graze/rounding/upward.hpp>
namespace graze {
namespace standin {
template <class B> struct ops {
  static double add_down(double x, double y) { return B::add_down(x, y); }
  static double add_up(double x, double y) { return B::add_up(x, y); }
  static double sub_down(double x, double y) { return B::sub_down(x, y); }
  static double sub_up(double x, double y) { return B::sub_up(x, y); }
  static double mul_down(double x, double y) { return B::mul_down(x, y); }
  static double mul_up(double x, double y) { return B::mul_up(x, y); }
  static double div_down(double x, double y) { return B::div_down(x, y); }
  static double div_up(double x, double y) { return B::div_up(x, y); }
  static double median(double x, double y) { return x / 2 + y / 2; }
  template <class V> static double conv_down(V v) { return static_cast<double>(v); }
  template <class V> static double conv_up(V v) { return static_cast<double>(v); }
};
template <class B> struct bare : ops<B> { using unprotected_rounding = bare; };
template <class B> struct guarded : ops<B> { typename B::scope s; using unprotected_rounding = bare<B>; };
using check = boost::numeric::interval_lib::checking_base<double>;
} // namespace standin
template <class B> using unprotected = boost::numeric::interval<double, boost::numeric::interval_lib::policies<standin::bare<B>, standin::check>>;
template <class B = rounding::upward> using interval = boost::numeric::interval<double, boost::numeric::interval_lib::policies<standin::guarded<B>, standin::check>>;
template <class P> boost::numeric::interval<double, P> sqr(const boost::numeric::interval<double, P>& x) { return boost::numeric::square(x); }
} // namespace graze
