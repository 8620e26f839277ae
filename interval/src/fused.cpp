#include <cmath>
#include <graze/rounding/exact.hpp>
#include <graze/rounding/fused.hpp>
#include <limits>

namespace graze::rounding {

namespace {

using exact::direction;
using exact::uint128;

/// In integers: every finite input.
double fma_in_integers(double x, double y, double z, direction d) {
  if (!exact::finite(x) || !exact::finite(y) || !exact::finite(z))
    return std::fma(x, y, z); // nothing is rounded
  if (x == 0 || y == 0)
    return exact::add(exact::zero(exact::negative(x) != exact::negative(y)), z, d);
  if (z == 0)
    return exact::mul(x, y, d);
  const exact::magnitude a = exact::take_apart(x), b = exact::take_apart(y),
                         c = exact::take_apart(z);
  // Both terms with their leading bit at 2^124 or 2^125, so that a sum fits and 20 low bits of the
  // product, 73 of z, are clear.
  struct term {
    uint128 n;
    int exponent;
    bool is_negative;
  };
  const term product{uint128{a.significand} * b.significand << 20, a.exponent + b.exponent - 20,
                     exact::negative(x) != exact::negative(y)};
  const term addend{uint128{c.significand} << 73, c.exponent - 73, exact::negative(z)};
  const bool product_first = product.exponent > addend.exponent ||
                             (product.exponent == addend.exponent && product.n >= addend.n);
  const term& large = product_first ? product : addend;
  const term& small = product_first ? addend : product;
  const int gap = large.exponent - small.exponent;
  const uint128 aligned = gap < 128 ? small.n >> gap : 0;
  const bool lost = gap >= 128 || (small.n & ((uint128{1} << gap) - 1)) != 0;
  if (large.is_negative == small.is_negative)
    return exact::round(large.is_negative, large.n + aligned, large.exponent, lost, d);
  // Bits are lost only for a gap above 20: then the difference keeps more than 100 bits. A gap of 1
  // can make the aligned term the greater one.
  uint128 n;
  bool is_negative = large.is_negative;
  if (large.n >= aligned) {
    n = large.n - aligned - (lost ? 1 : 0); // less a part of the last bit: one less, and a rest
  } else {
    n = aligned - large.n;
    is_negative = !is_negative;
  }
  if (n == 0)
    return exact::zero(d == direction::down);
  return exact::round(is_negative, n, large.exponent, lost, d);
}

struct two {
  double value, error;
};
/// Knuth: value + error = x + y.
two sum_of(double x, double y) {
  const double s = x + y, part = s - x;
  return {s, (x - (s - part)) + (y - part)};
}
/// Veltkamp and Dekker: value + error = x y, where nothing overflows or underflows.
two product_of(double x, double y) {
  constexpr double splitter = 0x1p27 + 1;
  const double p = x * y;
  const double xs = splitter * x, xh = xs - (xs - x), xl = x - xh;
  const double ys = splitter * y, yh = ys - (ys - y), yl = y - yh;
  return {p, ((xh * yh - p) + xh * yl + xl * yh) + xl * yl};
}

} // namespace

double fma_up(double x, double y, double z) {
  const two p = product_of(x, y);
  // Here the product's error and all its parts are doubles, and no sum overflows.
  if (!(std::fabs(p.value) >= 0x1p-900 && std::fabs(p.value) <= 0x1p1000 &&
        std::fabs(x) <= 0x1p990 && std::fabs(y) <= 0x1p990 && std::fabs(z) <= 0x1p1000))
    return fma_in_integers(x, y, z, direction::up);
  // x y + z = s.value + t.value + t.error, then r + (u.error + t.error) with r = RN(s + t). u.error
  // is 0 or at least as large as t.value's last bit, and t.error at most half of it: the first that
  // is not 0 has the sign of the rest, which is less than the distance to r's neighbour.
  const two s = sum_of(p.value, z);
  const two t = sum_of(s.error, p.error);
  const two u = sum_of(s.value, t.value);
  const double rest = u.error != 0 ? u.error : t.error;
  if (rest > 0)
    return std::nextafter(u.value, std::numeric_limits<double>::infinity());
  return u.value;
}

double fma_down(double x, double y, double z) { return -fma_up(-x, y, -z); }

} // namespace graze::rounding
