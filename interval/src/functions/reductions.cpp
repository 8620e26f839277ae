#include "../border.hpp"
#include "../exact/long_accumulator.hpp"
#include <cassert>
#include <cmath>
#include <graze/reductions.hpp>
#include <limits>

namespace graze {

namespace detail {

namespace {
/// Is +-(n + f) * 2^exponent, 0 <= f < 1, f > 0 iff `more`, nearer to the double above it in
/// magnitude (or as near, and that one is even)? n has 54 bits or more unless f = 0.
bool nearer_away(rounding::exact::uint128 n, int exponent, bool more) {
  const int leading = rounding::exact::bit_length(n);
  int quantum = exponent + leading - 53;
  if (quantum > 971)
    return true; // 2^1024 or above: infinity
  if (quantum < -1074)
    quantum = -1074;
  const int shift = quantum - exponent;
  if (shift <= 0 || shift > leading)
    return false;
  const auto half = rounding::exact::uint128{1} << (shift - 1);
  const auto rest = shift == 128 ? n : n & ((half << 1) - 1);
  const bool odd = shift < 128 && ((n >> shift) & 1) != 0;
  return rest > half || (rest == half && (more || odd));
}
} // namespace

double long_accumulator::round(rounded to) const {
  using rounding::exact::direction;
  const bool is_negative = negative();
  auto magnitude = words_;
  if (is_negative) {
    std::uint64_t carry = 1;
    for (std::uint64_t& word : magnitude) {
      word = ~word + carry;
      carry = carry != 0 && word == 0 ? 1 : 0;
    }
  }
  unsigned top = length - 1;
  while (top > 1 && magnitude[top] == 0)
    --top;
  const uint128 n = (uint128{magnitude[top]} << 64) | magnitude[top - 1];
  if (n == 0)
    return 0;
  bool more = false;
  for (unsigned i = 0; i + 1 < top; ++i)
    more = more || magnitude[i] != 0;
  const int exponent = last_bit + 64 * (static_cast<int>(top) - 1);
  direction d = to == rounded::up ? direction::up : direction::down;
  if (to == rounded::nearest)
    d = nearer_away(n, exponent, more) != is_negative ? direction::up : direction::down;
  return rounding::exact::round(is_negative, n, exponent, more, d);
}

} // namespace detail

namespace {

/// A sum as it grows: exact, and the infinities and NaNs apart.
class sum_so_far {
public:
  void add(double x) {
    if (std::isfinite(x))
      exact_.add(x);
    else
      special_ += x; // inf - inf is NaN, and NaN stays
  }
  void add_product(double x, double y) {
    if (std::isfinite(x) && std::isfinite(y))
      exact_.add_product(x, y);
    else
      special_ += x * y;
  }
  [[nodiscard]] double round(rounded to) const {
    return special_ == 0 ? exact_.round(to) : special_;
  }

private:
  detail::long_accumulator exact_;
  double special_ = 0;
};

} // namespace

namespace inside {
double sum(std::span<const double> x, rounded to) {
  sum_so_far s;
  for (const double t : x)
    s.add(t);
  return s.round(to);
}

double sum_abs(std::span<const double> x, rounded to) {
  sum_so_far s;
  for (const double t : x)
    s.add(std::fabs(t));
  return s.round(to);
}

double sum_sqr(std::span<const double> x, rounded to) {
  sum_so_far s;
  for (const double t : x)
    s.add_product(t, t);
  return s.round(to);
}

double dot(std::span<const double> x, std::span<const double> y, rounded to) {
  assert(x.size() == y.size());
  if (x.size() != y.size())
    return std::numeric_limits<double>::quiet_NaN();
  sum_so_far s;
  for (std::size_t i = 0; i < x.size(); ++i)
    s.add_product(x[i], y[i]);
  return s.round(to);
}
} // namespace inside

double sum(std::span<const double> x, rounded to) { return at_border<inside::sum>(x, to); }
double sum_abs(std::span<const double> x, rounded to) { return at_border<inside::sum_abs>(x, to); }
double sum_sqr(std::span<const double> x, rounded to) { return at_border<inside::sum_sqr>(x, to); }
double dot(std::span<const double> x, std::span<const double> y, rounded to) {
  return at_border<inside::dot>(x, y, to);
}

} // namespace graze
