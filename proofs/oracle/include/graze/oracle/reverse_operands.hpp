#pragma once
/// Operands on which reverse operations go wrong, if they go wrong: ranges that end at, beside or
/// just out of reach of a value of the direct function.
#include <algorithm>
#include <climits>
#include <cmath>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/reverse.hpp>
#include <numbers>

namespace graze::oracle::reverse {

/// Operands of a reverse operation: c, x, and what else it has.
struct reverse_case {
  bounds u, c, x;
  int n;
};

/// Operands of the algebraic reverse operations, with solutions at or near an end of x, or just out
/// of reach. A fixed sequence for a seed. To be used in round to nearest.
class algebraic_operands : public hard_operands {
public:
  using hard_operands::hard_operands;

  /// Any double, often a hard one; finite.
  double number() {
    for (;;) {
      const auto h = static_cast<hardness>(below(static_cast<std::uint64_t>(hardness::count)));
      const double x = next(h).x;
      if (std::isfinite(x))
        return x;
    }
  }
  /// A double near 1 or of everyday size, as it suits powers.
  double near_one() {
    switch (below(6)) {
    case 0:
      return step(1, static_cast<int>(below(9)) - 4);
    case 1:
      return with_exponent(static_cast<int>(below(80)) - 40);
    case 2:
      return std::ldexp(1.0, static_cast<int>(below(40)) - 20);
    case 3:
      return 1 + std::ldexp(coin() ? 1.0 : -0.5, -static_cast<int>(below(52)));
    default:
      return with_exponent(static_cast<int>(below(6)) - 3);
    }
  }
  double exponent() {
    static const double list[] = {0,  0.5,     1,    2,         3,      4,     -1,
                                  -2, -0.5,    0.25, 0x1p-1074, 1e-300, 1e300, 0.1,
                                  -7, 1.0 / 3, 53,   -1e18,     0x1p-60};
    switch (below(4)) {
    case 0:
      return list[below(std::size(list))];
    case 1:
      return number();
    default:
      return (coin() ? -1 : 1) * with_exponent(static_cast<int>(below(10)) - 5);
    }
  }
  /// An interval about t: often t alone, or a few ulps wide, or unbounded.
  bounds about(double t) {
    double lo = t, hi = t;
    widen(lo, -1);
    widen(hi, 1);
    return lo <= hi ? bounds{lo, hi} : bounds{hi, lo};
  }

  /// c about f(t), x about t, for f even, not below `least`, finite up to `greatest`.
  template <class Direct> reverse_case even(Direct f, double least, double greatest) {
    double t = number();
    if (std::fabs(t) > greatest)
      t = below(4) == 0 ? std::copysign(greatest, t) : std::ldexp(t, -std::ilogb(t));
    const double y = finite(f({t, 0}).lo.down);
    const bounds c = below(16) == 0 ? about(least) : about(y);
    const bounds x = below(8) == 0 ? bounds::entire() : about(coin() ? t : -t);
    return {bounds::empty(), c, x, 0};
  }
  /// c about t^n.
  reverse_case pown() {
    static const int list[] = {0,  1, 2,    3,     -1,     -2,     -3,      4,       8,
                               -8, 7, 1023, -1074, 100000, -99999, INT_MAX, INT_MIN, INT_MIN + 1};
    const int n = coin() ? list[below(std::size(list))] : static_cast<int>(below(60)) - 30;
    // Roots of any double, and doubles whose powers are near the ends of the range.
    double t = (coin() ? 1 : -1) * (n >= -1 && n <= 1
                                        ? std::fabs(number())
                                        : std::exp2((static_cast<double>(below(2100)) - 1074) / n));
    t = hard_operands::step(t, static_cast<int>(below(1000)));
    if (!std::isfinite(t) || below(4) == 0)
      t = t != 0 && std::isfinite(t) && coin() ? std::ldexp(t < 0 ? -1.0 : 1.0, std::ilogb(t))
                                               : number();
    const double y = finite(pown_at(t == 0 ? place{1, 0} : place{t, 0}, n).lo.down);
    const bounds c = about(y);
    const bounds x = below(8) == 0 ? bounds::entire() : about(below(4) != 0 ? t : -t);
    return {bounds::empty(), c, x, n};
  }
  /// c about u t.
  reverse_case mul() {
    double dividend = number(), divisor = number();
    if (coin()) { // made for each other
      const auto h = static_cast<hardness>(below(static_cast<std::uint64_t>(hardness::count)));
      const auto [p, q] = next(h);
      if (std::isfinite(p) && std::isfinite(q))
        dividend = p, divisor = q;
    }
    const bounds b = about(divisor), c = about(dividend);
    const double quotient = divisor == 0 ? number() : dividend / divisor;
    const bounds x = below(8) == 0 || !std::isfinite(quotient) ? bounds::entire() : about(quotient);
    return {b, c, x, 0};
  }
  /// u the base, x the exponent, c about u^x.
  reverse_case pow() {
    const double base = below(8) == 0 ? std::fabs(number()) : near_one();
    const double power = exponent();
    const double z = finite(base == 0 ? 0.0 : std::pow(base, power));
    const bounds u = about(base), x = about(power), c = about(std::max(z, 0.0));
    return {u, c, x, 0};
  }

private:
  static double finite(double y) {
    return std::clamp(y, -std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
  }
  void widen(double& end, int direction) {
    switch (below(8)) {
    case 0:
    case 1:
      return;
    case 2:
      end = direction * unbounded;
      return;
    case 3:
      end = 0;
      return;
    case 4:
      end = static_cast<double>(below(3)) - 1;
      return;
    case 5: {
      const double other = number();
      end = direction < 0 ? std::min(end, other) : std::max(end, other);
      return;
    }
    default:
      for (auto steps = below(4); steps-- > 0;)
        end = direction < 0 ? reverse::below(end) : reverse::above(end);
      if (!std::isfinite(end)) // not an end of a set that holds real numbers only
        end = direction * std::numeric_limits<double>::max();
    }
  }
};

enum class wave { sin, cos, tan };
inline double direct(wave f, double t, mpfr_rnd_t to) {
  return f == wave::sin   ? rounded(mpfr_sin, to, t)
         : f == wave::cos ? rounded(mpfr_cos, to, t)
                          : rounded(mpfr_tan, to, t);
}

/// Operands of the trigonometric reverse operations. A fixed sequence for a seed. To be used in
/// round to nearest.
class trigonometric_operands : public hard_operands {
public:
  using hard_operands::hard_operands;

  struct wave_case {
    double t; ///< a number about which x was made; f(t) is in or near c, most times
    bounds c, x;
  };
  wave_case next(wave f) {
    const double t = argument();
    bounds c = range(f, direct(f, t, coin() ? MPFR_RNDD : MPFR_RNDU));
    if (below(8) == 0) // a range of other values than f's at x
      c = range(f, std::ldexp(static_cast<double>(below(1 << 21)), -20) - 1);
    const bounds x = box(t);
    return {t, c, x};
  }

  double argument() {
    for (;;) {
      const double x = any_argument();
      if (std::isfinite(x))
        return x;
    }
  }
  /// May be infinite.
  double any_argument() {
    const double sign = coin() ? 1 : -1;
    switch (below(10)) {
    case 0: // tiny to huge
      return sign * any_normal();
    case 1: // where the doubles begin to lie further apart than slack, a crest, a period
      return sign * with_exponent(static_cast<int>(below(50)) + 8);
    case 2: { // the doubles nearest to a multiple of pi/2 among all, and their surroundings
      static const double list[] = {0x1.6ac5b262ca1ffp+849,  0x1.921fb54442d18p+0,
                                    0x1.921fb54442d18p+1,    0x1.6c6cbc45dc8dep+5,
                                    0x1.951a0c8a8ae14p+2,    0x1.d9ba50f60e54dp+118,
                                    0x1.7be4cd5b4f5d0p+1000, 0x1.fffffffffffffp+1023};
      return sign * step(list[below(std::size(list))], static_cast<int>(below(5)) - 2);
    }
    case 3: // small
      return sign * (below(8) == 0 ? 0 : special_finite());
    case 4:
    case 5: { // near a multiple of pi/2
      const double k = static_cast<double>(below(coin() ? 20 : 1 << 20));
      return sign * step(k * (std::numbers::pi / 2), static_cast<int>(below(7)) - 3);
    }
    default:
      return sign * std::ldexp(static_cast<double>(below(std::uint64_t{1} << 53)),
                               -53 + static_cast<int>(below(8)));
    }
  }

  /// A range about y, a value of f.
  bounds range(wave f, double y) {
    switch (below(12)) {
    case 0:
      return {-unbounded, y};
    case 1:
      return {y, unbounded};
    case 2: { // beside the crests, or the poles
      const double crest = f == wave::tan ? 0x1p+60 : 1;
      const double lo = step(crest, -static_cast<int>(below(5)));
      const double hi = coin() ? lo : step(crest, static_cast<int>(below(3)));
      return coin() ? bounds{std::min(lo, hi), std::max(lo, hi)}
                    : bounds{-std::max(lo, hi), -std::min(lo, hi)};
    }
    case 3: // about 0
      return {coin() ? 0.0 : -std::fabs(special_finite()), coin() ? 0.0 : special_finite()};
    case 4: {
      const double other = std::ldexp(static_cast<double>(below(1 << 20)), -19) - 1;
      return {std::min(y, other), std::max(y, other)};
    }
    case 5: // just out of reach of y
      return coin() ? bounds{above(y), unbounded} : bounds{-unbounded, below_(y)};
    case 6: {
      const double shifted = coin() ? above(y) : below_(y);
      return {shifted, shifted};
    }
    case 7:
      return {y, y};
    default: {
      double lo = y, hi = y;
      for (auto steps = below(4); steps-- > 0;)
        lo = below_(lo);
      for (auto steps = below(4); steps-- > 0;)
        hi = above(hi);
      return {lo, hi};
    }
    }
  }

  bounds box(double t) {
    double lo = t, hi = t;
    switch (below(10)) {
    case 0:
      break;
    case 1:
      lo = -unbounded;
      break;
    case 2:
      hi = unbounded;
      break;
    case 3:
    case 4: // a few ulps
      for (auto steps = below(6); steps-- > 0;)
        lo = below_(lo);
      for (auto steps = below(6); steps-- > 0;)
        hi = above(hi);
      break;
    case 5: { // one side, to any length
      const double length = std::ldexp(1 + static_cast<double>(below(1 << 20)), -20);
      hi = t + std::ldexp(length, static_cast<int>(below(60)) - 50);
      break;
    }
    default: {
      lo = t - std::ldexp(static_cast<double>(below(1 << 20)), -18);
      hi = t + std::ldexp(static_cast<double>(below(1 << 20)), -18);
    }
    }
    constexpr double largest = std::numeric_limits<double>::max();
    if (lo == unbounded || hi == -unbounded || (std::isinf(lo) && std::isinf(hi)))
      return {-largest, largest};
    return {lo, hi};
  }

private:
  static double below_(double x) { return std::nextafter(x, -unbounded); }
  static double above(double x) { return std::nextafter(x, unbounded); }
  double special_finite() {
    double x = special();
    while (!std::isfinite(x))
      x = special();
    return std::fabs(x);
  }
};

} // namespace graze::oracle::reverse
