#include "default_mode.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <graze/oracle/planes.hpp>

namespace graze::oracle {
namespace {

// Each has a volatile number: what has one is not moved across a change of mode.

[[gnu::noinline]] plane_terms exactly(double o, double s, double k) {
  volatile double rounded = k * s;
  const double product = rounded;
  // a multiple of the lowest bit of s, so that it is a double even where the product is subnormal
  return {o, product, std::fma(k, s, -product)};
}

[[gnu::noinline]] double rounded(double o, double s, double k) {
  volatile double plane = std::fma(k, s, o);
  return plane;
}

[[gnu::noinline]] double multiplied(double o, double s, double k) {
  volatile double product = k * s; // and no compiler makes two operations one
  return o + product;
}

[[gnu::noinline]] double in_floats(double o, double s, double k) {
  volatile float product = static_cast<float>(k) * static_cast<float>(s);
  return static_cast<double>(static_cast<float>(o) + product);
}

/// The exponent's bits and the sign: the same for all doubles of a binade.
std::uint64_t binade(double x) { return std::bit_cast<std::uint64_t>(x) >> 52; }

/// RN(p + s) - p is the same for two steps, and all results stay in one binade: let u be the ulp of its
/// doubles, p = m u, s = (q + r) u, 0 <= r < 1. Unless r = 1/2 each step adds q u, or each (q + 1) u. If
/// r = 1/2, ties go to even m: after a step m is even, and each later one adds the even one of q u and
/// (q + 1) u; a first step from an odd m adds the other one, so that two steps that are equal are two of
/// the later ones.
[[gnu::noinline]] double added(double o, double s, std::uint32_t k) {
  volatile double first = o;
  double p = first;
  while (k != 0) {
    const double next = p + s;
    --k;
    if (k == 0 || !std::isfinite(next) || next == p)
      return next;
    const double after = next + s;
    const double step = next - p;
    // next and after in p's binade, then the difference is exact
    const std::uint64_t here = binade(p);
    if (k < 8 || here != binade(after) || after - next != step) {
      p = next;
      continue;
    }
    // as many steps as stay in the binade: those below 2^(e+1), or above -2^e
    const double end = std::bit_cast<double>(p > 0 ? (here + 1) << 52 : here << 52);
    const double room = std::isfinite(end) ? (end - next) / step : 0;
    const double jump = room > 3 ? std::min(std::floor(room) - 2, static_cast<double>(k)) : 0;
    p = next + step * jump; // exact: a multiple of u within the binade
    k -= static_cast<std::uint32_t>(jump);
  }
  return p;
}

/// Plane k of a block of eight, which is asked about together.
[[gnu::noinline]] double added_again(double o, double s, std::uint32_t k) {
  struct place {
    double origin = 0, spacing = 0, plane = 0;
    std::uint32_t k = ~std::uint32_t{0};
  };
  thread_local constinit std::array<place, 64> known{};
  const std::uint32_t block = k & ~std::uint32_t{7};
  const auto key = std::bit_cast<std::uint64_t>(o) * 3 + std::bit_cast<std::uint64_t>(s) + block;
  place& at = known[(key * 0x9e3779b97f4a7c15u) >> 58];
  if (at.k != block || at.origin != o || at.spacing != s)
    at = {o, s, added(o, s, block), block};
  double p = at.plane;
  for (std::uint32_t i = block; i != k; ++i)
    p = p + s;
  return p;
}

template <class Rule> auto in_default_mode(Rule rule, double o, double s, std::uint32_t k) {
  const default_mode scope;
  return rule(o, s, k);
}

} // namespace

plane_terms plane_exactly(double o, double s, std::uint32_t k) {
  return in_default_mode(exactly, o, s, k);
}
double plane_rounded(double o, double s, std::uint32_t k) {
  return in_default_mode(rounded, o, s, k);
}
double plane_multiplied(double o, double s, std::uint32_t k) {
  return in_default_mode(multiplied, o, s, k);
}
double plane_added(double o, double s, std::uint32_t k) {
  return in_default_mode(added_again, o, s, k);
}
double plane_binary32(double o, double s, std::uint32_t k) {
  return in_default_mode(in_floats, o, s, k);
}

} // namespace graze::oracle
