#pragma once
/// sin and cos, sinh and cosh in N limbs, each with a relative error below 2^8 * 2^(-64 N).
///
/// Write e = 2^(-64 N). With r <= 4/5 and u = r^2, both pairs are r S(u) and C(u) of
///   C(u) = 1 -+ u/2! + u^2/4! -+ ...,  S(u) = 1 -+ u/3! + u^2/5! -+ ...,
/// summed by Horner in fixed point with one bit before the point (an ulp is 2 e). A step truncates
/// a coefficient and a product, less than (2 (N + 1) + 2) e, of which at most u <= 0.64 is passed
/// on: for N <= 4 in all less than 12 e / 0.36 < 34 e; the tail adds 2 e. The series are cut where
/// the next term is below e. r has a relative error below 32 e (0 where r = x; see
/// reduced_by_half_pi()), u hence an error below 48 e, which C and S pass on times 0.56 and 0.19.
/// So C, at least 0.69, has a relative error below (36 + 27 + 1) e / 0.69 < 93 e, S, at least 0.89,
/// below 53 e, and r S, with its own truncation, below 32 e + 53 e + 20 e.
#include "wide_constants.hpp"

namespace graze::wide {

/// Fixed point with one bit before the point.
template <int N> struct even_and_odd {
  limbs<N> even, odd; ///< C(u), S(u)
};

/// C and S divided by the coefficient of their term `First`, from that term on, in one limb: with
/// an error below (2 / 0.36 + 1) 2^-63, as each step truncates a coefficient and a product.
template <int First, int Terms, bool Hyperbolic> constexpr even_and_odd<1> tail(std::uint64_t u) {
  constexpr const auto& f = ratios<First, Terms>;
  std::uint64_t even = f.even[Terms - 1][0], odd = f.odd[Terms - 1][0];
  for (int k = Terms - 2; k >= 0; --k) {
    const std::uint64_t even_step = high(uint128{even} * u), odd_step = high(uint128{odd} * u);
    even = Hyperbolic ? f.even[k][0] + even_step : f.even[k][0] - even_step;
    odd = Hyperbolic ? f.odd[k][0] + odd_step : f.odd[k][0] - odd_step;
  }
  return {{even}, {odd}};
}

/// u <= 0.64 in units of 2^(-64 N).
template <int N, bool Hyperbolic> constexpr even_and_odd<N> series(const limbs<N>& u) {
  static_assert(N == 2 || N == 4);
  // 0.64^17 / 34! < 2^-138; 0.64^29 / 58! < 2^-278
  constexpr int terms = N == 2 ? 17 : 29;
  // for N = 2, the error of one limb from term 10 on is below 7 2^-63 0.64^10 / 20! < 2 e
  constexpr int head = N == 2 ? 10 : terms - 1;
  constexpr const auto& f = factorials<N, terms>;
  limbs<N> even = f.even[head], odd = f.odd[head];
  if constexpr (N == 2) {
    const even_and_odd<1> last = tail<head, terms - head, Hyperbolic>(u[N - 1]);
    even = doubled<N>(high_product<N>(even, last.even[0]));
    odd = doubled<N>(high_product<N>(odd, last.odd[0]));
  }
#pragma GCC unroll 10
  for (int k = head - 1; k >= 0; --k) {
    limbs<N> next_even = f.even[k], next_odd = f.odd[k];
    if constexpr (Hyperbolic) {
      add<N>(next_even, high_product<N>(even, u));
      add<N>(next_odd, high_product<N>(odd, u));
    } else { // the partial sums are positive: the terms alternate and decrease
      subtract<N>(next_even, high_product<N>(even, u));
      subtract<N>(next_odd, high_product<N>(odd, u));
    }
    even = next_even, odd = next_odd;
  }
  return {even, odd};
}

template <int N> constexpr limbs<N> square_as_fraction(const number<N>& r) {
  return shifted_right<N>(high_product<N>(r.significand, r.significand), -2 * r.exponent);
}

/// |x| = (4 k + quadrant) pi/2 + (negative ? -1 : 1) * rest pi/2, 0 < rest <= 1/2, where
/// floor_quadrant is that of |x| itself: floor(2/pi |x|) mod 4.
template <int N> struct reduction {
  number<N> rest;
  int quadrant, floor_quadrant;
  bool negative;
};

/// For |x| >= 3/4 finite. x = M 2^E: with L = N + 2, a window of 64 L bits of 2/pi that starts at
/// the bit of weight 2^(1 - E + 1) gives 2/pi |x| mod 4 with an error below 2^53 units in 2^(64 L -
/// 2). No double is nearer to a multiple of pi/2 than 2^-62 in units of pi/2 (continued fractions;
/// tests/interval/rare_wide.cpp computes the minimum, about 2^-61.5), so the quadrants are exact
/// and the relative error of `rest` is below 2^(53 + 2 + 62 - 64 L) < 2^-10 * 2^(-64 N).
/// Source: Payne and Hanek, SIGNUM Newsletter 18 (1983); Muller, Elementary Functions, ch. 11.
template <int N> constexpr reduction<N> reduced_by_half_pi(double x) {
  constexpr int length = N + 2;
  const rounding::exact::magnitude m = rounding::exact::take_apart(x);
  // the bit of 2/pi of weight 2^(-1 - i) is bit i of the constant, read from its top; 64 zeros are
  // put before it
  const int first = m.exponent - 2 + 64, whole = first / 64, bits = first % 64;
  const auto word = [&](int i) -> std::uint64_t { // from the top
    return i == 0 ? 0 : two_over_pi[two_over_pi_limbs - i];
  };
  limbs<length> t{};
  std::uint64_t carry = 0;
  std::uint64_t below = word(whole + length);
#pragma GCC unroll 8
  for (int i = 0; i < length; ++i) {
    const std::uint64_t above = word(whole + length - 1 - i);
    const std::uint64_t window = bits == 0 ? above : above << bits | below >> (64 - bits);
    const uint128 product = uint128{window} * m.significand + carry;
    t[i] = low(product), carry = high(product);
    below = above;
  }
  reduction<N> r{};
  r.floor_quadrant = static_cast<int>(t[length - 1] >> 62);
  r.negative = ((t[length - 1] >> 61) & 1) != 0;
  r.quadrant = (r.floor_quadrant + (r.negative ? 1 : 0)) & 3;
  t = shifted_left<length>(t, 2);
  if (r.negative) {
    limbs<length> negated{};
    subtract<length>(negated, t);
    t = negated;
  }
  const number<length> rest = normalised<length>(t, 0);
  for (int i = 0; i < N; ++i)
    r.rest.significand[i] = rest.significand[i + length - N];
  r.rest.exponent = rest.exponent;
  return r;
}

template <int N> struct circular {
  number<N> sine, cosine; ///< magnitudes
  bool sine_negative, cosine_negative;
};

/// sin x and cos x for x finite, |x| >= 2^-61.
template <int N> constexpr circular<N> circular_of(double x) {
  number<N> r = from_double<N>(x);
  int quadrant = 0;
  bool negative = false;
  const double magnitude = x < 0 ? -x : x;
  if (magnitude > 0.75) {
    const reduction<N> reduced = reduced_by_half_pi<N>(x);
    r = reduced.rest * half_pi<N>;
    quadrant = reduced.quadrant, negative = reduced.negative;
  }
  const even_and_odd<N> f = series<N, false>(square_as_fraction<N>(r));
  const number<N> sine = r * normalised<N>(f.odd, 1), cosine = normalised<N>(f.even, 1);
  const bool odd = (quadrant & 1) != 0;
  // quadrants: sin = s, c, -s, -c; cos = c, -s, -c, s, where s has the sign of the rest
  const bool sine_negative = ((quadrant & 2) != 0) != (!odd && negative);
  const bool cosine_negative = odd ? ((quadrant == 1) != negative) : quadrant == 2;
  return {odd ? cosine : sine, odd ? sine : cosine, sine_negative != (x < 0), cosine_negative};
}

template <int N> struct hyperbolic {
  number<N> sine, cosine; ///< sinh |x|, cosh x
};

/// For 2^-61 <= |x| <= 1000. Above 3/4, |x| = k log 2 + t with |t| < 0.35 and k >= 1, t with an
/// absolute error below 3 e; then u = t^2 < 0.13 has an error below 8 e, C(u) below
/// (12 / 0.87 + 5) e < 19 e, t S(u) below 22 e, exp(+-t) = C +- t S below 41 e, and
/// 2 sinh |x| = 2^k (exp(t) - 2^(-2 k) exp(-t)), whose bracket is at least 0.35, a relative error
/// below (41 + 41/4 + 2) e / 0.35 < 153 e.
template <int N> constexpr hyperbolic<N> hyperbolic_of(double x) {
  const double magnitude = x < 0 ? -x : x;
  if (magnitude <= 0.75) {
    const number<N> r = from_double<N>(x);
    const even_and_odd<N> f = series<N, true>(square_as_fraction<N>(r));
    return {r * normalised<N>(f.odd, 1), normalised<N>(f.even, 1)};
  }
  const rounding::exact::magnitude m = rounding::exact::take_apart(magnitude);
  // any k next to |x| / log 2 serves: an error of 0.004 in the quotient keeps |t| < 0.35
  const auto k = static_cast<std::uint64_t>(magnitude * 0x1.71547652b82fep+0 + 0.5);
  // in units of 2^(-64 (N + 1)), two limbs more than N: M 2^E - k log 2
  limbs<N + 2> t{};
  t[N] = m.significand << (64 + m.exponent), t[N + 1] = m.significand >> -m.exponent;
  limbs<N + 2> multiple{};
  std::uint64_t carry = 0;
#pragma GCC unroll 8
  for (int i = 0; i <= N; ++i) {
    const uint128 product = uint128{log_of_2<N + 1>[i]} * k + carry;
    multiple[i] = low(product), carry = high(product);
  }
  multiple[N + 1] = carry;
  const bool negative = subtract<N + 2>(t, multiple);
  if (negative) {
    limbs<N + 2> negated{};
    subtract<N + 2>(negated, t);
    t = negated;
  }
  limbs<N> fraction{};
  for (int i = 0; i < N; ++i)
    fraction[i] = t[i + 1];
  const even_and_odd<N> f = series<N, true>(high_product<N>(fraction, fraction));
  const limbs<N> odd = high_product<N>(f.odd, fraction);
  limbs<N> grown = f.even, shrunk = f.even; // exp(t), exp(-t)
  if (negative) {
    subtract<N>(grown, odd);
    add<N>(shrunk, odd);
  } else {
    add<N>(grown, odd);
    subtract<N>(shrunk, odd);
  }
  const auto exponent = static_cast<std::int64_t>(k);
  const limbs<N> other = shifted_right<N>(shrunk, 2 * exponent);
  limbs<N> sine = grown, cosine = grown;
  subtract<N>(sine, other);
  add<N>(cosine, other);
  return {normalised<N>(sine, exponent), normalised<N>(cosine, exponent)};
}

} // namespace graze::wide
