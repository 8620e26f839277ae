#pragma once
/// pi, 2/pi, log 2 and inverse factorials, computed by the compiler; tests/interval/rare_wide.cpp
/// compares every bit with MPFR.
#include "wide.hpp"

namespace graze::wide {

namespace detail {
/// 2^(64 N - 1) f, that is a fixed-point number with one bit before the point; each of the two
/// truncations a term costs less than an ulp.
template <int N> constexpr limbs<N> inverse_tangent(std::uint64_t divisor, bool hyperbolic) {
  limbs<N> power{}, sum{};
  power[N - 1] = std::uint64_t{1} << 63;
  divide<N>(power, divisor);
  for (std::uint64_t k = 0; power != limbs<N>{}; ++k) {
    limbs<N> term = power;
    divide<N>(term, 2 * k + 1);
    if (k % 2 == 0 || hyperbolic)
      add<N>(sum, term);
    else
      subtract<N>(sum, term);
    divide<N>(power, divisor * divisor);
  }
  return sum;
}

/// pi/2 2^(64 N - 1). Source: Machin, pi/4 = 4 atan(1/5) - atan(1/239).
template <int N> constexpr limbs<N> machin() {
  limbs<N> r = inverse_tangent<N>(5, false);
  r = shifted_left<N>(r, 2);
  subtract<N>(r, inverse_tangent<N>(239, false));
  return shifted_left<N>(r, 1);
}

inline constexpr int long_limbs = 26; // 1,664 bits, of which a few thousand ulps are lost
inline constexpr limbs<long_limbs> long_half_pi = machin<long_limbs>();

template <int N, int Long> constexpr limbs<N> top(const limbs<Long>& a) {
  limbs<N> r{};
  for (int i = 0; i < N; ++i)
    r[i] = a[Long - N + i];
  return r;
}
} // namespace detail

/// pi/2 = half_pi * 2^(1 - 64 N), truncated.
template <int N>
inline constexpr number<N> half_pi = {detail::top<N, detail::long_limbs>(detail::long_half_pi), 1};

/// 2/pi = two_over_pi * 2^(-1536), truncated: bits for the largest double and N = 4, see
/// reduced_by_half_pi().
inline constexpr int two_over_pi_limbs = 24;
inline constexpr limbs<two_over_pi_limbs> two_over_pi = [] {
  std::array<std::uint64_t, two_over_pi_limbs + detail::long_limbs> n{};
  n.back() = std::uint64_t{1} << 63;
  return quotient<two_over_pi_limbs, detail::long_limbs>(n, detail::long_half_pi);
}();

/// log 2 = log_of_2 * 2^(-64 N), truncated. Source: log 2 = 2 atanh(1/3).
template <int N>
inline constexpr limbs<N> log_of_2 = [] {
  const limbs<N + 1> r = detail::inverse_tangent<N + 1>(3, true); // one bit before the point
  return detail::top<N, N + 1>(shifted_left<N + 1>(r, 2));
}();

/// 1/(2k)! and 1/(2k + 1)!, times 2^(64 N - 1), truncated.
template <int N, int Terms> struct inverse_factorials {
  std::array<limbs<N>, Terms> even, odd;
};
template <int N, int Terms>
inline constexpr inverse_factorials<N, Terms> factorials = [] {
  inverse_factorials<N, Terms> r{};
  limbs<N + 1> f{};
  f[N] = std::uint64_t{1} << 63;
  for (int k = 0; k < Terms; ++k) {
    if (k > 0)
      divide<N + 1>(f, static_cast<std::uint64_t>(2 * k));
    r.even[k] = detail::top<N, N + 1>(f);
    divide<N + 1>(f, static_cast<std::uint64_t>(2 * k + 1));
    r.odd[k] = detail::top<N, N + 1>(f);
  }
  return r;
}();

/// The factorials of terms First, First + 1, ... times that of First, in one limb: 1, then less.
template <int First, int Terms>
inline constexpr inverse_factorials<1, Terms> ratios = [] {
  inverse_factorials<1, Terms> r{};
  limbs<2> even{0, std::uint64_t{1} << 63}, odd = even;
  for (int k = 0; k < Terms; ++k) {
    const auto n = static_cast<std::uint64_t>(2 * (First + k));
    if (k > 0) {
      divide<2>(even, n * (n - 1));
      divide<2>(odd, n * (n + 1));
    }
    r.even[k] = {even[1]}, r.odd[k] = {odd[1]};
  }
  return r;
}();

} // namespace graze::wide
