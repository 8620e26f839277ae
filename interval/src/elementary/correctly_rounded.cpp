#include "correctly_rounded.hpp"

namespace graze::correctly_rounded {
namespace {

/// A finite double is m 2^e with an integer m.
struct scaled {
  std::uint64_t m;
  int e;
};
scaled magnitude(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto fraction = bits & 0xfffffffffffff;
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  const int normal = exponent != 0;
  return {fraction | std::uint64_t(normal) << 52, exponent - 1074 - normal};
}

/// x in units of 2^e, e >= x.e; `lost` has a bit set if that is no integer.
std::uint64_t in_units(scaled x, int e, std::uint64_t& lost) {
  const int shift = e - x.e;
  if (shift > 52) {
    lost |= x.m;
    return 0;
  }
  lost |= x.m & ((std::uint64_t{1} << shift) - 1);
  return x.m >> shift;
}

/// Is r = sqrt(x^2 + y^2) exactly, all finite, r >= |x|, |y|? If it is, the least set bits of x, y
/// and r allow it only when x and y are multiples of r's unit: let 2^k be the greatest power that
/// divides both. If one of them is an odd multiple of it, so is r; if both are, the sum of squares
/// is 2 mod 4 (in units of 4^k), no square. So r's least bit is 2^k, no less than its unit. Then
/// all squares are integers below 2^106.
bool exact_hypot(double x, double y, double r) {
  const scaled h = magnitude(r);
  std::uint64_t lost = 0;
  const std::uint64_t a = in_units(magnitude(x), h.e, lost), b = in_units(magnitude(y), h.e, lost);
  // Modulo 2^64 first: one branch, hardly ever taken.
  if ((lost | (a * a + b * b - h.m * h.m)) != 0)
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
