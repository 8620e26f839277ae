// write_api_expected FILE: operands, and by MPFR what each statement of statements.hpp gives.
#include "operands.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <graze/oracle/ranges.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/oracle/rounding.hpp>
#include <limits>
#include <random>

namespace {

using namespace graze;
namespace ranges = oracle::ranges;
using oracle::mpfr;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr bounds around_big{0x1p53, 0x1.0000000000001p+53};                // 2^53 + 1
constexpr bounds around_tenth{0x1.9999999999999p-4, 0x1.999999999999ap-4}; // 0.1L

/// C's fmod over a box, from its definition: for x, y >= 0, x - n y where n <= x / y < n + 1, for
/// every n that occurs, by rationals. Boxes with more than some quotients are taken from the lines
/// x = n y: all remainders below the greatest y that meets one occur.
bounds remainder_of_positive(double a, double b, double c, double d) {
  using rational = mpq_class;
  if (d == 0)
    return bounds::empty();
  if (d == infinity || b == infinity || c == 0 || rational(b) / rational(c) > 1000000) {
    // the quotients have no bound, or many integers: 0 to the greatest y with x = m y
    if (a == b && c == d)
      return {std::fmod(a, d), std::fmod(a, d)};
    if (d == infinity) // the quotient 0 for y > b; and below, y goes up to b
      return c > b ? bounds{a, b} : bounds{0, b};
    const mpz_class n = mpz_class(rational(a) / rational(d));
    if (b == infinity || rational(n + 1) * rational(d) <= rational(b))
      return {0, d};
    if (a == b && b == 0)
      return {0, 0};
    const rational greatest = rational(b) / rational(n + 1);
    double up = greatest.get_d();
    while (rational(up) < greatest)
      up = std::nextafter(up, infinity);
    return {0, up};
  }
  const mpz_class first = mpz_class(rational(a) / rational(d));
  const mpz_class last = mpz_class(rational(b) / rational(c));
  rational least, greatest;
  bool any = false;
  const auto add = [&](const rational& r) {
    least = any && least < r ? least : r;
    greatest = any && greatest > r ? greatest : r;
    any = true;
  };
  for (mpz_class n = first; n <= last && n <= first + 4; ++n) {
    // the part of the box with n y <= x <= (n + 1) y is a polygon; x - n y is linear on it
    const rational A(a), B(b), C(c), D(d), N(n), M(n + 1);
    for (const rational& y : {C, D})
      for (const rational& x : {A, B, rational(N * y), rational(M * y)})
        if (A <= x && x <= B && N * y <= x && x <= M * y)
          add(x - N * y);
    for (const rational& x : {A, B})
      for (const rational& k : {N, M})
        if (k != 0) {
          const rational y = x / k;
          if (C <= y && y <= D && N * y <= x && x <= M * y)
            add(x - N * y);
        }
  }
  double down = least.get_d(), up = greatest.get_d();
  while (rational(down) > least)
    down = std::nextafter(down, -infinity);
  while (rational(up) < greatest)
    up = std::nextafter(up, infinity);
  return {down, up};
}
bounds c_remainder(const bounds& x, const bounds& y) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  const double c = std::max({0.0, y.lo, -y.hi}), d = std::max(-y.lo, y.hi);
  bounds r = bounds::empty();
  if (x.hi >= 0)
    r = ranges::convex_hull(r, remainder_of_positive(std::max(0.0, x.lo), x.hi, c, d));
  if (x.lo < 0)
    r = ranges::convex_hull(r,
                            ranges::neg(remainder_of_positive(std::max(0.0, -x.hi), -x.lo, c, d)));
  return r;
}

api::ends to_ends(const bounds& x) { return {x.lo, x.hi}; }
api::ends to_ends(double x) { return {x, x}; }
api::ends to_ends(bool x) { return {x ? 1.0 : 0.0, x ? 1.0 : 0.0}; }

#define GRAZE_STATEMENT(kind, name, code, judge)                                                   \
  api::ends name([[maybe_unused]] const bounds& x, [[maybe_unused]] const bounds& y) {             \
    return to_ends(judge);                                                                         \
  }
namespace statement {
#include "statements.hpp"
}
#undef GRAZE_STATEMENT

/// Ends of both signs near 0, 1, pi, the ends of the format; unbounded, flat and empty ones; some
/// of any exponent, and neighbours.
std::vector<bounds> hard_intervals(std::mt19937_64& bits) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double largest = std::numeric_limits<double>::max(), least = 0x1p-1074;
  std::vector<bounds> r{{0, 0},
                        {1, 1},
                        {1, 2},
                        {0, 1},
                        {-1, 0},
                        {-1, 1},
                        {-2, -1},
                        {0.1, 0.1},
                        {0.1, 0.3},
                        {-0.7, 0.1},
                        {3, 4},
                        {1.5, 1.75},
                        {-3.5, -3},
                        {5, 7},
                        {least, least},
                        {-least, least},
                        {0, least},
                        {largest, largest},
                        {-largest, largest},
                        {0x1p-1022, 0x1p-1021},
                        {1, infinity},
                        {-infinity, -1},
                        {0, infinity},
                        {-infinity, 0},
                        {-infinity, infinity},
                        {nan, nan},
                        {0x1.921fb54442d18p+0, 0x1.921fb54442d19p+0},
                        {6, 6.5},
                        {0x1p600, 0x1p700},
                        {-0x1.fffffffffffffp-2, 0.5},
                        {0x1p53, 0x1p54},
                        {-27, -8}};
  const auto number = [&](int exponents) {
    const double significand = std::ldexp(static_cast<double>(bits() >> 11), -53) + 0.5;
    const double size =
        std::ldexp(significand, static_cast<int>(bits() % (2 * exponents)) - exponents);
    return (bits() & 1) != 0 ? size : -size;
  };
  for (int i = 0; i < 48; ++i) {
    const double a = number(i < 32 ? 4 : 300), b = i % 3 == 0   ? std::nextafter(a, infinity)
                                                   : i % 3 == 1 ? number(4)
                                                                : a + std::fabs(a) * 0.125;
    r.push_back({std::min(a, b), std::max(a, b)});
  }
  return r;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_api_expected FILE\n");
    return 2;
  }
  std::mt19937_64 bits(1);
  const std::vector<bounds> hard = hard_intervals(bits);
  api::expectations e;
  for (std::size_t i = 0; i < hard.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const bounds& y = hard[k == 0 ? i : bits() % hard.size()];
      e.operands.push_back({to_ends(hard[i]), to_ends(y)});
    }
  const auto add = [&](auto judge) {
    for (const auto& [x, y] : e.operands)
      e.expected.push_back(judge(bounds{x.lower, x.upper}, bounds{y.lower, y.upper}));
  };
#define GRAZE_STATEMENT(kind, name, code, judge) add(statement::name);
#include "statements.hpp"
#undef GRAZE_STATEMENT
  return api::write(argv[1], e) ? 0 : 2;
}
