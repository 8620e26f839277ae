#pragma once
/// Any number as the nearest doubles below and above it. C++17.
#include <cmath>
#include <graze/rounding/narrow.hpp>
#include <limits>
#include <type_traits>

namespace graze {

namespace detail {

__extension__ using int128 = __int128;
__extension__ using uint128 = unsigned __int128;

/// std::is_integral has __int128, and std::is_floating_point __float128, in gnu++ modes only.
template <class N>
inline constexpr bool is_integer =
    std::is_integral_v<N> || std::is_same_v<N, int128> || std::is_same_v<N, uint128>;
#if defined(__SIZEOF_FLOAT128__)
__extension__ using float128 = __float128;
template <class N>
inline constexpr bool is_real = std::is_floating_point_v<N> || std::is_same_v<N, float128>;
#else
template <class N> inline constexpr bool is_real = std::is_floating_point_v<N>;
#endif
template <class N>
inline constexpr bool is_number = is_integer<N> || is_real<N> || std::is_enum_v<N>;

/// Is every value of N a double?
template <class N>
inline constexpr bool exactly_a_double =
    is_integer<N> ? sizeof(N) <= 4 : std::is_same_v<N, double> || std::is_same_v<N, float>;

// Comparisons with an integer are made in its type; beyond<N>, 2^(its digits), which does not fit
// it, is above every value.
template <class N> constexpr double beyond() {
  double power = 1;
  constexpr bool has_sign = std::is_signed_v<N> || std::is_same_v<N, int128>;
  for (unsigned i = has_sign ? 1 : 0; i < 8 * sizeof(N); ++i)
    power *= 2;
  return power;
}
template <class N> bool above(double near, const N& v) {
  if constexpr (is_integer<N>)
    return near >= beyond<N>() || static_cast<N>(near) > v;
  else
    return static_cast<N>(near) > v;
}
template <class N> bool below(double near, const N& v) {
  if constexpr (is_integer<N>)
    return near < beyond<N>() && static_cast<N>(near) < v;
  else
    return static_cast<N>(near) < v;
}

/// The greatest double <= v and the least double >= v, for any number that converts to double and
/// back, in any rounding mode. Of a NaN: NaN.
template <class N> double round_down(const N& v) {
  if constexpr (std::is_enum_v<N>) {
    return round_down(static_cast<std::underlying_type_t<N>>(v));
  } else if constexpr (std::is_same_v<N, float>) {
    return rounding::widened(v); // with DAZ too
  } else if constexpr (exactly_a_double<N>) {
    return static_cast<double>(v);
  } else {
    auto near = static_cast<double>(v);
    while (above(near, v)) // at most once, unless N is a class that converts carelessly
      near = std::nextafter(near, -std::numeric_limits<double>::infinity());
    return near;
  }
}
template <class N> double round_up(const N& v) {
  if constexpr (std::is_enum_v<N>) {
    return round_up(static_cast<std::underlying_type_t<N>>(v));
  } else if constexpr (std::is_same_v<N, float>) {
    return rounding::widened(v); // with DAZ too
  } else if constexpr (exactly_a_double<N>) {
    return static_cast<double>(v);
  } else {
    auto near = static_cast<double>(v);
    while (below(near, v))
      near = std::nextafter(near, std::numeric_limits<double>::infinity());
    return near;
  }
}

/// The greatest Bound (double or float) <= v, and the least >= v.
template <class Bound, class N> Bound round_down_to(const N& v) {
  if constexpr (std::is_same_v<Bound, float> && !std::is_same_v<N, float>)
    return rounding::narrow_down(round_down(v));
  else
    return static_cast<Bound>(round_down(v));
}
template <class Bound, class N> Bound round_up_to(const N& v) {
  if constexpr (std::is_same_v<Bound, float> && !std::is_same_v<N, float>)
    return rounding::narrow_up(round_up(v));
  else
    return static_cast<Bound>(round_up(v));
}
/// Is every value of N a Bound?
template <class Bound, class N>
inline constexpr bool exactly_a =
    std::is_same_v<Bound, double> ? exactly_a_double<N>
                                  : std::is_same_v<N, float> || (is_integer<N> && sizeof(N) <= 2);

} // namespace detail

} // namespace graze
