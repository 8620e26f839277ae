#pragma once
/// Forward differentiation: a value and its partial derivatives, over any number type.
#include <graze/needs_cxx20.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <graze/octree/formula.hpp>

namespace graze::octree {

/// f and its partial derivatives at the same point or, over intervals, enclosures of both on the
/// same box. Three partials give the gradient; one gives the derivative along a ray, at half the
/// price. Arithmetic with a plain N treats it as a constant.
template <class N, std::size_t Partials = 3> struct dual {
  N value;
  std::array<N, Partials> partial;

  /// The variable with index `axis`: value x, partial derivative 1 by itself.
  static dual variable(const N& x, std::size_t axis) {
    dual r{x, {}};
    for (std::size_t i = 0; i < Partials; ++i)
      r.partial[i] = constants<N>::exact(i == axis ? 1 : 0);
    return r;
  }

  friend dual operator-(const dual& a) {
    return a.map(-a.value, [](const N& p) { return -p; });
  }
  friend dual operator+(const dual& a, const dual& b) {
    return zip(a, b, a.value + b.value, [](const N& p, const N& q) { return p + q; });
  }
  friend dual operator-(const dual& a, const dual& b) {
    return zip(a, b, a.value - b.value, [](const N& p, const N& q) { return p - q; });
  }
  friend dual operator*(const dual& a, const dual& b) {
    return zip(a, b, a.value * b.value,
               [&](const N& p, const N& q) { return p * b.value + a.value * q; });
  }
  friend dual operator/(const dual& a, const dual& b) {
    const N ratio = a.value / b.value;
    return zip(a, b, ratio, [&](const N& p, const N& q) { return (p - ratio * q) / b.value; });
  }
  friend dual operator+(const dual& a, const N& c) { return {a.value + c, a.partial}; }
  friend dual operator-(const dual& a, const N& c) { return {a.value - c, a.partial}; }
  friend dual operator+(const N& c, const dual& a) { return {c + a.value, a.partial}; }
  friend dual operator-(const N& c, const dual& a) { return c + (-a); }
  friend dual operator*(const dual& a, const N& c) {
    return a.map(a.value * c, [&](const N& p) { return p * c; });
  }
  friend dual operator*(const N& c, const dual& a) { return a * c; }

  /// (value, partials each multiplied by what `change` makes of them)
  template <class F> [[nodiscard]] dual map(const N& new_value, F change) const {
    dual r{new_value, {}};
    for (std::size_t i = 0; i < Partials; ++i)
      r.partial[i] = change(partial[i]);
    return r;
  }

private:
  template <class F> static dual zip(const dual& a, const dual& b, const N& value, F combine) {
    dual r{value, {}};
    for (std::size_t i = 0; i < Partials; ++i)
      r.partial[i] = combine(a.partial[i], b.partial[i]);
    return r;
  }
};

/// A constant of a formula over duals is a plain N: its partials are not worth carrying.
template <class N, std::size_t P> struct constants<dual<N, P>> : constants<N> {};

template <class N, std::size_t P> dual<N, P> sqr(const dual<N, P>& x) {
  const N slope = x.value + x.value;
  return x.map(sqr(x.value), [&](const N& p) { return slope * p; });
}

template <class N, std::size_t P> dual<N, P> cube_minus_identity(const dual<N, P>& x) {
  const N square = sqr(x.value);
  const N slope = square + square + square - constants<N>::exact(1);
  return x.map(cube_minus_identity(x.value), [&](const N& p) { return slope * p; });
}

/// Domain: x.value > 0 (over intervals, where 0 is in x.value the partials are unbounded).
template <class N, std::size_t P> dual<N, P> sqrt(const dual<N, P>& x) {
  using std::sqrt;
  const N root = sqrt(x.value);
  return x.map(root, [&](const N& p) { return p / (root + root); });
}

namespace detail {
template <class Policies>
bool certainly_less(const boost::numeric::interval<double, Policies>& a,
                    const boost::numeric::interval<double, Policies>& b) {
  return a.upper() < b.lower();
}
template <class N> bool certainly_less(const N& a, const N& b) { return a < b; }

/// Over the lanes of a register.
template <class P> struct lesser_lanes {
  using part = batch::part<P>;
  /// The hull. Empty where either is: of a slope that is not known nothing is known.
  static GRAZE_BATCH_INLINE part either(const part& a, const part& b) {
    const auto is_empty =
        P::either_nan(a.lo, a.lo); // an empty b comes through as the second operand
    return {P::select(is_empty, a.lo, P::min_or_second(a.lo, b.lo)),
            P::select(is_empty, a.hi, P::max_or_second(a.hi, b.hi))};
  }
  /// What `lesser` makes of a partial derivative.
  static GRAZE_BATCH_INLINE part partial(const part& a, const part& b, const part& of_a,
                                         const part& of_b) {
    const auto only_a = P::less(a.hi, b.lo), only_b = P::less(b.hi, a.lo);
    const part both = either(of_a, of_b);
    return {P::select(only_a, of_a.lo, P::select(only_b, of_b.lo, both.lo)),
            P::select(only_a, of_a.hi, P::select(only_b, of_b.hi, both.hi))};
  }
};

template <class Policies>
boost::numeric::interval<double, Policies>
either(const boost::numeric::interval<double, Policies>& a,
       const boost::numeric::interval<double, Policies>& b) {
  return lanewise<boost::numeric::interval<double, Policies>>::template apply<
      &lesser_lanes<batch::portable>::either>(a, b);
}
template <class N> N either(const N& a, const N&) { return a; }
} // namespace detail

/// The lesser of two: with its own gradient where one of them is less on the whole box; else with
/// the hull of both, which holds Clarke's generalized gradient, so that the mean value theorem
/// (Lebourg) and monotonicity hold across the crease.
template <class N, std::size_t P> dual<N, P> lesser(const dual<N, P>& a, const dual<N, P>& b) {
  if (detail::certainly_less(a.value, b.value))
    return a;
  if (detail::certainly_less(b.value, a.value))
    return b;
  dual<N, P> r{lesser(a.value, b.value), {}};
  for (std::size_t i = 0; i < P; ++i)
    r.partial[i] = detail::either(a.partial[i], b.partial[i]);
  return r;
}

} // namespace graze::octree
