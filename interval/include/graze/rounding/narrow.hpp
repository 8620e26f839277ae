#pragma once
/// float to double, exactly, and double to float, rounded as asked: what lets the operations on
/// doubles serve floats.
///
/// An operation on floats is that of doubles, rounded to float once, and is correctly rounded. For
/// t real or infinite let D(t) be the greatest double <= t and F(t) the greatest float <= t. Then
/// F(D(t)) = F(t): a float f <= t is a double <= t, hence f <= D(t), and D(t) <= t, so that D(t)
/// and t have the same floats below them. The same upwards. So where `mul_down` is correctly
/// rounded on doubles, narrow_down(mul_down(x, y)) is so on floats; and where the bounds of a
/// function are the tightest doubles, they are the tightest floats once narrowed. It needs no more
/// of the two formats than that each float is a double. (Rounding to nearest twice is not so.)
/// Proof: proofs/coq/Narrow.v.
///
/// No rounding mode, FTZ or DAZ reaches these functions: no subnormal float meets a floating-point
/// instruction, and what the instruction gives for others in any mode is one of the two neighbours,
/// of which a comparison finds the right one. constexpr; C++17.
#include <cstdint>

namespace graze::rounding {

namespace detail {

enum class narrowing { down, up, nearest };

constexpr float narrowed(double x, narrowing to) {
  constexpr std::uint64_t infinite = 0x7ff0000000000000, fraction = 0x000fffffffffffff,
                          largest = 0x7f7fffff; // 2^128 - 2^104, as a float
  constexpr std::uint64_t least_normal = 897;   // 2^-126, as the field of a double's exponent
  constexpr int dropped = 29;                   // bits that a float's significand lacks
  constexpr std::uint64_t deepest = 25;         // below 2^-150 all are, and are less than a half

  const auto bits = __builtin_bit_cast(std::uint64_t, x);
  const std::uint64_t size = bits & (infinite | fraction), sign = bits >> 63;
  const std::uint64_t field = size >> 52;
  const std::uint64_t significand = (size & fraction) | (std::uint64_t{field != 0} << 52);
  const std::uint64_t depth = field < least_normal ? least_normal - field : 0;
  const int shift = dropped + static_cast<int>(depth < deepest ? depth : deepest);
  const std::uint64_t kept = significand >> shift, lost = significand - (kept << shift);

  // the hidden bit of what is kept adds 1 to the field, which is 1 for 2^-126
  std::uint64_t result = ((field + depth - least_normal) << 23) + kept;
  const bool beyond = result > largest;
  result = beyond ? largest : result;
  bool away = false;
  if (to == narrowing::nearest) {
    const std::uint64_t half = std::uint64_t{1} << (shift - 1);
    away = beyond | (lost + (kept & 1) > half); // the largest float is odd: a tie goes to infinity
  } else {
    away = (beyond | (lost != 0)) & ((sign != 0) == (to == narrowing::down));
  }
  result += static_cast<std::uint64_t>(away | (size >= infinite)); // after the largest: infinity
  result |= static_cast<std::uint64_t>(size > infinite) << 22;     // and a NaN stays one
  return __builtin_bit_cast(float, static_cast<std::uint32_t>(sign << 31 | result));
}

/// Neither 0 < |x| < 2^-126 nor to be computed by the compiler.
constexpr bool by_instruction(double x) {
  constexpr std::uint64_t least_normal = std::uint64_t{897} << 52;
  const std::uint64_t size = __builtin_bit_cast(std::uint64_t, x) & 0x7fffffffffffffff;
  return size - 1 >= least_normal - 1 && !__builtin_is_constant_evaluated();
}
/// x as a float, rounded either way.
inline float neighbour(double x) {
  auto near = static_cast<float>(x);
#if defined(__x86_64__)
  asm("" : "+x"(near)); // to be computed once: in another mode it might be the other one
#else
  asm("" : "+m"(near));
#endif
  return near;
}
/// The float below (above) x, which is not 0, if `wrong`.
constexpr float lower_if(bool wrong, float x) {
  const auto bits = __builtin_bit_cast(std::int32_t, x);
  return __builtin_bit_cast(float, bits - std::int32_t{wrong} * (bits >> 31 | 1));
}
constexpr float higher_if(bool wrong, float x) {
  const auto bits = __builtin_bit_cast(std::int32_t, x);
  return __builtin_bit_cast(float, bits + std::int32_t{wrong} * (bits >> 31 | 1));
}

} // namespace detail

/// The greatest float <= x, and the least >= x; of either infinity, and of NaN, itself. A zero
/// keeps its sign, and what becomes zero has that of x, as IEEE 754's conversion has it.
constexpr float narrow_down(double x) {
  if (!detail::by_instruction(x))
    return detail::narrowed(x, detail::narrowing::down);
  const float near = detail::neighbour(x);
  return detail::lower_if(near > x, near);
}
constexpr float narrow_up(double x) {
  if (!detail::by_instruction(x))
    return detail::narrowed(x, detail::narrowing::up);
  const float near = detail::neighbour(x);
  return detail::higher_if(near < x, near);
}
/// The nearest float, of two the even one; from 2^128 - 2^103 on infinity.
constexpr float narrow_to_nearest(double x) {
  return detail::narrowed(x, detail::narrowing::nearest);
}

/// x as a double, exactly; a NaN stays one.
constexpr double widened(float x) {
  constexpr std::uint32_t least_normal = 0x00800000;
  const auto bits = __builtin_bit_cast(std::uint32_t, x);
  const std::uint32_t size = bits & 0x7fffffff;
  if (size - 1 >= least_normal - 1)
    return x;
  // a subnormal float is an integer times 2^-149
  const auto integer = __builtin_bit_cast(std::uint64_t, static_cast<double>(size));
  return __builtin_bit_cast(double, (integer - (std::uint64_t{149} << 52)) |
                                        std::uint64_t{bits >> 31} << 63);
}

/// For templates over both.
constexpr double widened(double x) { return x; }

} // namespace graze::rounding
