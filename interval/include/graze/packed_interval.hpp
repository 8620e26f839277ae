#pragma once
/// [a, b] stored as the pair (-a, b), of which a sum is one instruction that rounds upward: the
/// type behind graze::interval<B> where B rounds two numbers at once. x86-64 only.
///
/// Members, meanings and conversions are those of Boost's class, but for one: lower() and upper()
/// are values, not references into the object. `const double& l = std::max(x.lower(), y.lower())`
/// would dangle. Code written for Boost's class may do so (its own `intersect` does), and thus
/// policies<B> keeps Boost's layout, and outward_policies<B> has this one.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <boost/numeric/interval/utility.hpp>
#include <graze/policies.hpp>
#include <graze/rounding/packed.hpp>
#include <type_traits>

namespace graze {

/// Policies whose backend has `pair_operations`.
template <class P>
concept PackedPolicies =
    Policies<P> && requires { typename P::rounding::backend::pair_operations; };

template <rounding::Backend B> struct outward_policies : policies<B> {
  using stored = rounding::packed::pair;
};
template <class P>
concept OutwardPolicies = PackedPolicies<P> && requires { typename P::stored; };

} // namespace graze

template <graze::OutwardPolicies P> class boost::numeric::interval<double, P> {
  using pair = graze::rounding::packed::pair;
  using checking = graze::checking;

public:
  using base_type = double;
  using traits_type = P;

  double lower() const { return -outward[0]; }
  double upper() const { return outward[1]; }

  interval() : outward{-0.0, 0.0} {}
  /// The number alone; NaN gives the empty set.
  interval(const double& v) : outward{-v, v} {}
  /// The tightest interval of doubles that holds v.
  template <class Number>
    requires graze::detail::is_number<Number>
  interval(const Number& v) : interval(from(v, v)) {}
  /// Bounds in the wrong order and NaN give the empty set.
  interval(const double& l, const double& u) : interval(l, u, true) {
    if (!(l <= u))
      set_empty();
  }
  template <class Lower, class Upper>
  interval(const Lower& l, const Upper& u) : interval(l <= u ? from(l, u) : empty()) {}
  template <class Q> interval(const interval<double, Q>& x) : interval(convert(x)) {}
  template <class Number, class Q> interval(const interval<Number, Q>& x) : interval(convert(x)) {}
  // the rest is assigned by way of these
  interval(const interval&) = default;
  interval& operator=(const interval&) = default;

  void assign(const double& l, const double& u) { *this = interval(l, u); }

  static interval empty() { return {checking::empty_lower(), checking::empty_upper(), true}; }
  static interval whole() { return {checking::neg_inf(), checking::pos_inf(), true}; }
  /// Of the two numbers; a NaN is ignored.
  static interval hull(const double& x, const double& y) {
    if (x != x || y != y)
      return x != x ? interval(y) : interval(x);
    return x <= y ? interval(x, y, true) : interval(y, x, true);
  }

  interval& operator+=(const double& y) { return *this = *this + interval(y); }
  interval& operator-=(const double& y) { return *this = *this - interval(y); }
  interval& operator*=(const double& y) { return *this = *this * interval(y); }
  interval& operator/=(const double& y) { return *this = *this / interval(y); }
  interval& operator+=(const interval& y) { return *this = *this + y; }
  interval& operator-=(const interval& y) { return *this = *this - y; }
  interval& operator*=(const interval& y) { return *this = *this * y; }
  interval& operator/=(const interval& y) { return *this = *this / y; }

  // Boost's class has these for its own functions: bounds are taken as they are.
  interval(const double& l, const double& u, bool) : outward{-l, u} {}
  void set_empty() { *this = empty(); }
  void set_whole() { *this = whole(); }
  void set(const double& l, const double& u) { *this = interval(l, u, true); }

  /// (-lower, upper)
  pair as_pair() const { return outward; }
  static interval from_pair(pair outward) {
    interval r;
    r.outward = outward;
    return r;
  }

private:
  template <class Lower, class Upper> static interval from(const Lower& l, const Upper& u) {
    if (l != l || u != u)
      return empty();
    [[maybe_unused]] const typename P::rounding rnd;
    return {P::rounding::conv_down(l), P::rounding::conv_up(u), true};
  }
  template <class Number, class Q> static interval convert(const interval<Number, Q>& x) {
    return Q::checking::is_empty(x.lower(), x.upper()) ? empty() : from(x.lower(), x.upper());
  }

  pair outward;
};

namespace boost::numeric {

// Boost's own give references to bounds.
template <graze::OutwardPolicies P> double lower(const interval<double, P>& x) { return x.lower(); }
template <graze::OutwardPolicies P> double upper(const interval<double, P>& x) { return x.upper(); }

/// The common members. Boost's own keeps references to bounds.
template <graze::OutwardPolicies P>
interval<double, P> intersect(const interval<double, P>& x, const interval<double, P>& y) {
  using common = interval<double, P>;
  if (empty(x) || empty(y))
    return common::empty();
  return {std::max(x.lower(), y.lower()), std::min(x.upper(), y.upper())};
}

} // namespace boost::numeric
