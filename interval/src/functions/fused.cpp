#include "../border.hpp"
#include <cmath>
#include <graze/rounding/exact_fma.hpp>
#include <graze/rounding/fused.hpp>
#include <limits>

namespace graze::rounding {

namespace {

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

namespace detail {
double fma_up(double x, double y, double z) {
  const two p = product_of(x, y);
  // Here the product's error and all its parts are doubles, and no sum overflows.
  if (!(std::fabs(p.value) >= 0x1p-900 && std::fabs(p.value) <= 0x1p1000 &&
        std::fabs(x) <= 0x1p990 && std::fabs(y) <= 0x1p990 && std::fabs(z) <= 0x1p1000))
    return exact::multiply_add(x, y, z, exact::direction::up);
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
} // namespace detail

double fma_up(double x, double y, double z) { return graze::at_border<detail::fma_up>(x, y, z); }
double fma_down(double x, double y, double z) { return -fma_up(-x, y, -z); }

} // namespace graze::rounding
