#include "correctly_rounded.hpp"

namespace graze::correctly_rounded {
namespace {

/// A finite double is m 2^e with an integer m.
struct scaled {
  std::uint64_t m;
  int e;
};
scaled magnitude(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
  const auto fraction = bits & 0xfffffffffffff;
  const int exponent = static_cast<int>(bits >> 52);
  return exponent == 0 ? scaled{fraction, -1074}
                       : scaled{fraction | std::uint64_t{1} << 52, exponent - 1075};
}

/// x = m 2^e with m < 2^53, if there is such an m.
bool multiple_of(scaled x, int e, std::uint64_t& m) {
  const int shift = e - x.e;
  if (x.m == 0 || shift == 0) {
    m = x.m;
    return true;
  }
  if (shift < 0 || shift > 52 || (x.m & ((std::uint64_t{1} << shift) - 1)) != 0)
    return false;
  m = x.m >> shift;
  return true;
}

/// Is r = sqrt(x^2 + y^2) exactly, all finite, r >= |x|, |y|? If it is, the least set bits of x, y
/// and r allow it only when x and y are multiples of r's unit: let 2^k be the greatest power that
/// divides both. If one of them is an odd multiple of it, so is r; if both are, the sum of squares
/// is 2 mod 4 (in units of 4^k), no square. So r's least bit is 2^k, no less than its unit. Then
/// all squares are integers below 2^106.
bool exact_hypot(double x, double y, double r) {
  const scaled h = magnitude(r);
  std::uint64_t a, b;
  if (!multiple_of(magnitude(x), h.e, a) || !multiple_of(magnitude(y), h.e, b))
    return false;
  __extension__ using wide = unsigned __int128;
  return wide{a} * a + wide{b} * b == wide{h.m} * h.m;
}

} // namespace

double hypot::down(double x, double y) {
  const double r = core_math::hypot(x, y);
  if (r != r)
    return r;
  if (r == infinity)
    return std::fabs(x) == infinity || std::fabs(y) == infinity ? r : below(r);
  return exact_hypot(x, y, r) ? r : below(r);
}

} // namespace graze::correctly_rounded
