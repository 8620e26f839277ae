#pragma once
/// What a tape asks of duals: the rules of differentiation, each written once over the number type
/// of the value. Over intervals a slope encloses all slopes on the box; where the function is not
/// differentiable (a kink, the end of its domain) all of its one-sided slopes or, if they are not
/// bounded, no bound is given.
#include <graze/octree/dual.hpp>
#include <graze/octree_formula/operations.hpp>

namespace graze::octree::tape {

template <class N, std::size_t P> struct operations<dual<N, P>> {
  using d = dual<N, P>;
  using o = operations<N>;

  /// Constants of formulas over duals are plain (dual.hpp); this is one as an operand.
  static d number(const constant& c) {
    d r{o::number(c), {}};
    for (N& p : r.partial)
      p = o::number({0, 0, 0});
    return r;
  }
  static N unit() { return o::number({1, 1, 1}); }

  static d chain(const N& value, const N& slope, const d& x) {
    return x.map(value, [&](const N& p) { return slope * p; });
  }
  static d chain(const N& value, const N& slope_x, const d& x, const N& slope_y, const d& y) {
    d r{value, {}};
    for (std::size_t i = 0; i < P; ++i)
      r.partial[i] = slope_x * x.partial[i] + slope_y * y.partial[i];
    return r;
  }

  static d div(const d& x, const d& y) {
    const N ratio = o::div(x.value, y.value), slope = o::known(o::recip(y.value));
    return chain(ratio, slope, x, -(ratio * slope), y);
  }
  static d recip(const d& x) {
    const N value = o::recip(x.value);
    return chain(value, -sqr(value), x);
  }
  static d sqrt(const d& x) {
    const N root = o::sqrt(x.value);
    return chain(root, o::known(o::recip(root + root)), x);
  }
  static d abs(const d& x) { return chain(o::abs(x.value), o::abs_slope(x.value), x); }
  static d min(const d& x, const d& y) {
    d r{o::min(x.value, y.value), {}};
    for (std::size_t i = 0; i < P; ++i)
      r.partial[i] = o::of_lesser(x.value, y.value, x.partial[i], y.partial[i]);
    return r;
  }
  static d max(const d& x, const d& y) {
    d r{o::max(x.value, y.value), {}};
    for (std::size_t i = 0; i < P; ++i)
      r.partial[i] = o::of_lesser(y.value, x.value, x.partial[i], y.partial[i]);
    return r;
  }
  /// Within one branch its slopes; across both, where it may jump, continuity<N> gives no bound.
  static d select(const d& a, const d& if_positive, const d& if_not) {
    d r{o::select(a.value, if_positive.value, if_not.value), {}};
    for (std::size_t i = 0; i < P; ++i)
      r.partial[i] = o::select(a.value, if_positive.partial[i], if_not.partial[i]);
    return r;
  }
  static d pown(const d& x, int n) {
    const N value = o::pown(x.value, n);
    if (n == 0)
      return chain(value, o::number({0, 0, 0}), x);
    const double factor = n;
    const N below = n == 2 ? x.value : n == 3 ? N(sqr(x.value)) : o::pown(x.value, n - 1);
    return chain(value, o::known(below * o::number({factor, factor, factor})), x);
  }
  /// 1 / (n root^(n-1)): even powers of a root of either sign are not negative.
  static d rootn(const d& x, int n) {
    const N root = o::rootn(x.value, n);
    const double factor = n;
    const N power = n - 1 == 2 ? N(sqr(root)) : o::pown(root, n - 1);
    return chain(root, o::known(o::recip(power * o::number({factor, factor, factor}))), x);
  }
  static d polynomial(const polynomial_view& p, const polynomial_view& slope, const d& x) {
    return chain(o::polynomial(p, x.value), o::polynomial(slope, x.value), x);
  }
  static d pow(const d& x, const d& y) {
    const N value = o::pow(x.value, y.value);
    const N slope_x = o::known(y.value * o::pow(x.value, y.value - unit()));
    return chain(value, slope_x, x, o::known(value * o::log(x.value)), y);
  }
  /// The slopes of a length are in [-1, 1], at the origin too.
  static d hypot(const d& x, const d& y) {
    const N length = o::hypot(x.value, y.value);
    return chain(length, o::within_one(o::div(x.value, length)), x,
                 o::within_one(o::div(y.value, length)), y);
  }
  static d atan2(const d& y, const d& x) {
    const N square = sqr(x.value) + sqr(y.value);
    return chain(o::atan2(y.value, x.value), o::known(o::div(x.value, square)), y,
                 o::known(-o::div(y.value, square)), x);
  }

  static d cbrt(const d& x) {
    const N root = o::cbrt(x.value), square = sqr(root);
    return chain(root, o::known(o::recip(square + square + square)), x);
  }
  static d exp(const d& x) {
    const N value = o::exp(x.value);
    return chain(value, value, x);
  }
  static d exp2(const d& x) {
    const N value = o::exp2(x.value);
    return chain(value, value * log_of_2(), x);
  }
  static d exp10(const d& x) {
    const N value = o::exp10(x.value);
    return chain(value, value * log_of_10(), x);
  }
  static d expm1(const d& x) { return chain(o::expm1(x.value), o::exp(x.value), x); }
  static d log(const d& x) { return chain(o::log(x.value), o::known(o::recip(x.value)), x); }
  static d log2(const d& x) {
    return chain(o::log2(x.value), o::known(o::recip(x.value * log_of_2())), x);
  }
  static d log10(const d& x) {
    return chain(o::log10(x.value), o::known(o::recip(x.value * log_of_10())), x);
  }
  static d logp1(const d& x) {
    return chain(o::logp1(x.value), o::known(o::recip(unit() + x.value)), x);
  }
  static d sin(const d& x) { return chain(o::sin(x.value), o::cos(x.value), x); }
  static d cos(const d& x) { return chain(o::cos(x.value), -o::sin(x.value), x); }
  static d tan(const d& x) {
    const N value = o::tan(x.value);
    return chain(value, unit() + sqr(value), x);
  }
  static d cot(const d& x) {
    const N value = o::cot(x.value);
    return chain(value, -(unit() + sqr(value)), x);
  }
  static d sec(const d& x) {
    const N value = o::sec(x.value);
    return chain(value, o::known(value * o::tan(x.value)), x);
  }
  static d csc(const d& x) {
    const N value = o::csc(x.value);
    return chain(value, o::known(-(value * o::cot(x.value))), x);
  }
  /// 1 - t^2 = (1 - t) (1 + t), whose factors are tight.
  static N product_beside_one(const N& t) { return (unit() - t) * (unit() + t); }
  static d asin(const d& x) {
    return chain(o::asin(x.value), o::known(o::recip(o::sqrt(product_beside_one(x.value)))), x);
  }
  static d acos(const d& x) {
    return chain(o::acos(x.value), -o::known(o::recip(o::sqrt(product_beside_one(x.value)))), x);
  }
  static d atan(const d& x) { return chain(o::atan(x.value), o::recip(unit() + sqr(x.value)), x); }
  static d acot(const d& x) { return chain(o::acot(x.value), -o::recip(unit() + sqr(x.value)), x); }
  static d sinh(const d& x) { return chain(o::sinh(x.value), o::cosh(x.value), x); }
  static d cosh(const d& x) { return chain(o::cosh(x.value), o::sinh(x.value), x); }
  static d tanh(const d& x) { return chain(o::tanh(x.value), sqr(o::sech(x.value)), x); }
  static d coth(const d& x) { return chain(o::coth(x.value), o::known(-sqr(o::csch(x.value))), x); }
  static d sech(const d& x) {
    const N value = o::sech(x.value);
    return chain(value, -(value * o::tanh(x.value)), x);
  }
  static d csch(const d& x) {
    const N value = o::csch(x.value);
    return chain(value, o::known(-(value * o::coth(x.value))), x);
  }
  static d asinh(const d& x) {
    return chain(o::asinh(x.value), o::recip(o::hypot(unit(), x.value)), x);
  }
  static d acosh(const d& x) {
    return chain(o::acosh(x.value), o::known(o::recip(o::sqrt(-product_beside_one(x.value)))), x);
  }
  static d atanh(const d& x) {
    return chain(o::atanh(x.value), o::known(o::recip(product_beside_one(x.value))), x);
  }
  static d acoth(const d& x) {
    return chain(o::acoth(x.value), o::known(o::recip(product_beside_one(x.value))), x);
  }
  // Where a step function is continuous it is constant.
  static d step(const N& value, const d& x) { return chain(value, o::number({0, 0, 0}), x); }
  static d sign(const d& x) { return step(o::sign(x.value), x); }
  static d floor(const d& x) { return step(o::floor(x.value), x); }
  static d ceil(const d& x) { return step(o::ceil(x.value), x); }
  static d trunc(const d& x) { return step(o::trunc(x.value), x); }

private:
  // log 2 = 0.693147180559945309417..., log 10 = 2.302585092994045684017..., each between
  // neighbouring doubles.
  static N log_of_2() {
    return o::number({0x1.62e42fefa39efp-1, 0x1.62e42fefa39f0p-1, 0x1.62e42fefa39efp-1});
  }
  static N log_of_10() {
    return o::number({0x1.26bb1bbb55515p+1, 0x1.26bb1bbb55516p+1, 0x1.26bb1bbb55516p+1});
  }
};

} // namespace graze::octree::tape
