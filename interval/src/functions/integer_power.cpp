// x^n and the n-th root for any int n.
#include "../border.hpp"
#include "../exact/wide_power.hpp"
#include <algorithm>
#include <cmath>
#include <graze/functions/integer_power.hpp>
#include <graze/rounding/switching.hpp>

namespace graze {

using namespace wide;
using rounding::exact::direction;
using rounding::exact::magnitude;

namespace point {

namespace {

directed pown_of_any(double x, int n);

/// x^n for x > 0 finite.
constexpr directed power_of_positive(double x, int n) {
  const magnitude a = rounding::exact::take_apart(x);
  const std::uint32_t count = absolute(n);
  const two_limbs p = power(a.significand << 11, a.exponent + 53, count);
  const std::uint64_t bits = bits_of(a.significand);
  if (n > 0) {
    if (is_exact(bits, count))
      return rounded_exactly(p);
    const enclosure e = enclosed<2>(as_number(p), 0, 8 * std::uint64_t{count});
    return sufficient(e)
               ? e.bounds
               : enclosed<4>(power_of_four_limbs(x, count), 0, 20 * std::uint64_t{count}).bounds;
  }
  if (bits == 1) // p = 2^(exponent - 1)
    return rounded_exactly({p.m, 2 - p.exponent});
  const enclosure e = enclosed<2>(one<2> / as_number(p), 8 * std::uint64_t{count} + 8, 8);
  return sufficient(e)
             ? e.bounds
             : enclosed<4>(one<4> / power_of_four_limbs(x, count), 20 * std::uint64_t{count} + 8, 8)
                   .bounds;
}

} // namespace

namespace {
template <int N> directed quickly_or_not(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const quick_power r = quick<N>(bits & ~rounding::exact::sign_bit);
  if (!r.valid)
    return at_border<pown_of_any>(x, N);
  const std::uint64_t negative = N % 2 != 0 ? bits >> 63 : 0, sign = negative << 63;
  return {std::bit_cast<double>((r.down + negative) | sign),
          std::bit_cast<double>((r.down + (1 - negative)) | sign)};
}
} // namespace

directed pown(double x, int n) {
  switch (n) {
  case 2:
    return quickly_or_not<2>(x);
  case 3:
    return quickly_or_not<3>(x);
  case 4:
    return quickly_or_not<4>(x);
  case 5:
    return quickly_or_not<5>(x);
  case 6:
    return quickly_or_not<6>(x);
  case 7:
    return quickly_or_not<7>(x);
  case 8:
    return quickly_or_not<8>(x);
  default:
    return at_border<pown_of_any>(x, n);
  }
}

namespace {
directed pown_of_any(double x, int n) {
  const bool odd = (n & 1) != 0;
  const double magnitude_of_x = std::fabs(x);
  if (0 < magnitude_of_x && magnitude_of_x < infinity && n != 0) {
    return mirrored(x < 0 && odd, power_of_positive(magnitude_of_x, n));
  }
  if (x != x)
    return {x, x};
  if (n == 0)
    return {1, 1};
  if (x == 0)
    return n > 0 ? directed{0, 0} : directed{not_a_number, not_a_number};
  return mirrored(x < 0 && odd, n > 0 ? directed{infinity, infinity} : directed{0, 0});
}

/// y = m^k against x, or x y against 1 for n < 0, with k = |n|. The root is m (1 + h)^(1/k), where
/// 1 + h is the quotient of the two, hence m + m h/k but for a factor of 1 +- |h|.
template <int N> residual root_residual(double x, int n, double m) {
  const std::uint32_t k = absolute(n);
  const magnitude a = rounding::exact::take_apart(m), b = rounding::exact::take_apart(x);
  number<N> y{};
  if constexpr (N == 2)
    y = as_number(power(a.significand << 11, a.exponent + 53, k));
  else
    y = power_of_four_limbs(m, k);
  const number<N> exact_x = from_double<N>(x);
  if (n < 0)
    y = y * exact_x;
  const number<N>& target = n < 0 ? one<N> : exact_x;
  const signed_number<N> d = difference<N>(target, y);
  const std::uint64_t bits = bits_of(a.significand);
  if (d.sign == 0) { // x y = 1 for powers of two alone; a product that is not exact is low
    const bool exact = n < 0 ? bits == 1 && bits_of(b.significand) == 1 : is_exact(bits, k);
    return {exact ? 0 : -1, -m * 0x1p-60, exact};
  }
  // y is low by a relative error below 20 k 2^(-64 N): d, where negative, has the true sign
  const std::int64_t greater = std::max(target.exponent, y.exponent);
  if (d.sign > 0 && d.magnitude.exponent < greater - 64 * N + std::bit_width(k) + 6)
    return {0, 0, false};
  if (d.magnitude.exponent > y.exponent - 10) // |h| > 2^-12: a poor guess
    return {d.sign, not_a_number, false};
  const double h = estimate(number<N>{d.magnitude.significand, d.magnitude.exponent - y.exponent}) /
                   estimate(number<N>{y.significand, 0});
  return {d.sign, d.sign * m * h / k, false};
}

directed root_of_positive(double x, int n) {
  if (n == 1)
    return {x, x};
  if (n == -1)
    return {rounding::exact::div(1, x, direction::down), rounding::exact::div(1, x, direction::up)};
  if (n == 2)
    return {rounding::switching::sqrt_down(x), rounding::switching::sqrt_up(x)};
  const double guess = n == 3 ? std::cbrt(x) : std::pow(x, 1.0 / n);
  // the greatest and the least root are those of 2^1074 and of 2^-1074 for |n| = 2
  return neighbours_of_root(guess, 0x1p-538, 0x1p538, [x, n](double m) {
    const residual r = root_residual<2>(x, n, m);
    return sufficient(r) ? r : root_residual<4>(x, n, m);
  });
}

} // namespace

namespace inside {
directed rootn(double x, int n) {
  const bool odd = (n & 1) != 0;
  if (x != x || n == 0 || (x < 0 && !odd) || (x == 0 && n < 0))
    return {not_a_number, not_a_number};
  if (x == 0)
    return {0, 0};
  const double magnitude_of_x = std::fabs(x);
  if (magnitude_of_x == infinity)
    return mirrored(x < 0, n > 0 ? directed{infinity, infinity} : directed{0, 0});
  return mirrored(x < 0, root_of_positive(magnitude_of_x, n));
}
} // namespace inside
directed rootn(double x, int n) { return at_border<inside::rootn>(x, n); }

} // namespace point

namespace functions {

namespace {
/// f(t, n) decreasing on each side of a pole at 0.
template <class Function> bounds around_pole(const bounds& x, int n, Function f) {
  if (x.lo == 0 && x.hi == 0)
    return bounds::empty();
  if (x.lo < 0 && 0 < x.hi)
    return bounds::entire();
  return {x.hi == 0 ? -infinity : f(x.hi, n).down, x.lo == 0 ? infinity : f(x.lo, n).up};
}
} // namespace

namespace inside {
/// x^n for n > 0 odd, n > 0 even, and any n.
bounds odd_power(bounds x, int n) {
  return {point::pown_of_any(x.lo, n).down, point::pown_of_any(x.hi, n).up};
}
bounds even_power(bounds x, int n) {
  const double greatest = std::max(-x.lo, x.hi);
  const double least = x.contains(0) ? 0 : std::min(std::fabs(x.lo), std::fabs(x.hi));
  return {least == 0 ? 0 : point::pown_of_any(least, n).down, point::pown_of_any(greatest, n).up};
}
bounds pown(bounds x, int n) {
  const bool odd = (n & 1) != 0;
  if (n > 0)
    return odd ? odd_power(x, n) : even_power(x, n);
  if (odd)
    return around_pole(x, n, point::pown_of_any);
  const double greatest = std::max(-x.lo, x.hi);
  if (greatest == 0)
    return bounds::empty();
  const double least = x.contains(0) ? 0 : std::min(std::fabs(x.lo), std::fabs(x.hi));
  return {point::pown_of_any(greatest, n).down,
          least == 0 ? infinity : point::pown_of_any(least, n).up};
}
} // namespace inside

namespace {

/// Where quick<N> does not decide; out of line, so that the usual case saves no registers.
[[gnu::cold, gnu::noinline]] bounds power_of_any(const bounds x, int n) {
  return at_border<inside::pown>(x, n);
}

/// Without branches on signs, which for mixed ones are not predicted. Where subnormal numbers count
/// as zero (DAZ): an end of that size is not decided as the greatest, and as the least it has 0 for
/// a lower bound either way.
template <int N> [[gnu::noinline]] bounds positive_power(const bounds x) {
  if constexpr (N % 2 != 0) {
    const auto low_bits = std::bit_cast<std::uint64_t>(x.lo),
               high_bits = std::bit_cast<std::uint64_t>(x.hi);
    const quick_power low_end = quick<N>(low_bits & ~rounding::exact::sign_bit);
    const quick_power high_end = quick<N>(high_bits & ~rounding::exact::sign_bit);
    if (!(low_end.valid && high_end.valid)) [[unlikely]]
      return power_of_any(x, N);
    const std::uint64_t low_negative = low_bits >> 63, high_negative = high_bits >> 63;
    return {std::bit_cast<double>((low_end.down + low_negative) | low_negative << 63),
            std::bit_cast<double>((high_end.down + (1 - high_negative)) | high_negative << 63)};
  } else {
    const double greatest = std::max(-x.lo, x.hi), least = std::max(x.lo, -x.hi);
    const bool holds_zero = !(least > 0);
    const quick_power far = quick<N>(std::bit_cast<std::uint64_t>(greatest));
    const quick_power near = quick<N>(std::bit_cast<std::uint64_t>(holds_zero ? greatest : least));
    if (!(far.valid && near.valid)) [[unlikely]]
      return power_of_any(x, N);
    return {std::bit_cast<double>(holds_zero ? 0 : near.down), std::bit_cast<double>(far.down + 1)};
  }
}

} // namespace

bounds pown::value(bounds x, int n) {
  if (x.is_empty())
    return x;
  switch (n) {
  case 0:
    return {1, 1};
  case 1:
    return x;
  case 2:
    return positive_power<2>(x);
  case 3:
    return positive_power<3>(x);
  case 4:
    return positive_power<4>(x);
  case 5:
    return positive_power<5>(x);
  case 6:
    return positive_power<6>(x);
  case 7:
    return positive_power<7>(x);
  case 8:
    return positive_power<8>(x);
  default:
    break;
  }
  return power_of_any(x, n);
}
decoration pown::local(bounds x, int n) {
  return x.is_empty() || (n < 0 && x.contains(0)) ? decoration::trv : decoration::dac;
}

namespace inside {
bounds rootn(bounds x, int n) {
  if (x.is_empty() || n == 0)
    return bounds::empty();
  if ((n & 1) != 0)
    return n > 0 ? bounds{point::inside::rootn(x.lo, n).down, point::inside::rootn(x.hi, n).up}
                 : around_pole(x, n, point::inside::rootn);
  if (x.hi < 0 || (n < 0 && x.hi == 0))
    return bounds::empty();
  const double least = std::max(x.lo, 0.0);
  if (n > 0)
    return {point::inside::rootn(least, n).down, point::inside::rootn(x.hi, n).up};
  return {point::inside::rootn(x.hi, n).down,
          least == 0 ? infinity : point::inside::rootn(least, n).up};
}
} // namespace inside
bounds rootn::value(bounds x, int n) { return at_border<inside::rootn>(x, n); }
decoration rootn::local(bounds x, int n) {
  const bool odd = (n & 1) != 0;
  if (x.is_empty() || n == 0 || (!odd && x.lo < 0) || (n < 0 && x.contains(0)))
    return decoration::trv;
  return decoration::dac;
}

} // namespace functions
} // namespace graze
