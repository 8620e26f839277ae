#include "default_mode.hpp"
#include <algorithm>
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
    if (p == 0 || std::signbit(p) != std::signbit(after) || std::ilogb(p) != std::ilogb(after) ||
        after - next != step) {
      p = next;
      continue;
    }
    // as many steps as stay in the binade: those below 2^(e+1), or above -2^e
    const double end = p > 0 ? std::ldexp(1.0, std::ilogb(p) + 1) : -std::ldexp(1.0, std::ilogb(p));
    const double room = std::isfinite(end) ? (end - next) / step : 0;
    const auto jump =
        static_cast<std::uint32_t>(std::clamp(std::floor(room) - 2, 0.0, static_cast<double>(k)));
    p = next + step * jump; // exact: a multiple of u within the binade
    k -= jump;
  }
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
double plane_added(double o, double s, std::uint32_t k) { return in_default_mode(added, o, s, k); }
double plane_binary32(double o, double s, std::uint32_t k) {
  return in_default_mode(in_floats, o, s, k);
}

} // namespace graze::oracle
