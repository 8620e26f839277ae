// atan2 where it is hardest for the fast evaluation: y / x so near to tan m, m a double, that only
// some hundred bits tell the angle from m. The convergents of tan m's continued fraction with
// numerators and denominators below 2^53 are so near.
#include "../../interval/src/elementary/angle_pair.hpp"
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <gmpxx.h>
#include <graze/functions/trigonometric.hpp>
#include <graze/oracle/elementary.hpp>

namespace test = graze::test;
namespace oracle = graze::oracle;
using graze::bounds;

namespace {

struct pair {
  double y, x;
};

/// The last convergent of tan m with both numbers below 2^53, and the one before.
std::vector<pair> convergents(double m) {
  constexpr int bits = 400;
  oracle::number t(bits);
  mpfr_set_d(t, m, MPFR_RNDN);
  mpfr_tan(t, t, MPFR_RNDN);
  mpz_class n, d = 1;
  const mpfr_exp_t e = mpfr_get_z_2exp(n.get_mpz_t(), t);
  (e < 0 ? d : n) <<= static_cast<unsigned long>(e < 0 ? -e : e);
  mpz_class p = 1, q = 0, p_before = 0, q_before = 1;
  std::vector<pair> last;
  const mpz_class most = mpz_class(1) << 53;
  while (d != 0) {
    const mpz_class a = n / d;
    const mpz_class p_next = a * p + p_before, q_next = a * q + q_before;
    if (p_next >= most || q_next >= most)
      break;
    p_before = p, q_before = q;
    p = p_next, q = q_next;
    last.insert(last.begin(), {p.get_d(), q.get_d()});
    const mpz_class rest = n - a * d;
    n = d, d = rest;
  }
  last.resize(std::min<std::size_t>(last.size(), 2));
  return last;
}

bool fused() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

template <class Judge> void each_hard_pair(int count, const Judge& judge) {
  oracle::hard_arguments make(1789);
  for (int i = 0; i < count; ++i) {
    double m = make.uniform(0, 0x1.921fb54442d18p+0);
    switch (i % 4) {
    case 0:
      m = std::ldexp(m, -static_cast<int>(make.below(24)));
      break;
    case 1: // of few bits
      m = std::ldexp(std::floor(std::ldexp(m, 20)), -20);
      break;
    default:
      break;
    }
    if (!(m > 0))
      continue;
    for (const pair& c : convergents(m))
      if (c.y > 0 && c.x > 0) {
        const int size = static_cast<int>(make.below(3)) * 20 - 20;
        const double y = std::ldexp(make.coin() ? c.y : -c.y, size),
                     x = std::ldexp(make.coin() ? c.x : -c.x, size);
        judge(y, x);
        judge(x, y);
      }
  }
}

} // namespace

TEST_CASE("interval.atan2: fast or not, convergents of tangents of doubles are told apart",
          "[regression][mpfr][hardcase]") {
  test::verdict result;
  each_hard_pair(test::inputs_per_operation() / 5, [&](double y, double x) {
    const bounds exact{oracle::rounded_down(mpfr_atan2, y, x),
                       oracle::rounded_up(mpfr_atan2, y, x)};
    result.judge("atan2", exact, graze::functions::atan2::value({y, y}, {x, x}), y, x);
  });
  result.check();
}

#if defined(__x86_64__)
TEST_CASE("interval.atan2: of convergents of tangents of doubles nothing is decided wrongly",
          "[regression][mpfr][hardcase]") {
  if (!fused()) {
    test::skipped("this processor has no fused operations");
    return;
  }
  test::verdict result;
  int decided = 0, pairs = 0;
  each_hard_pair(test::inputs_per_operation() / 5, [&](double y, double x) {
    const bounds both = graze::elementary::angle_if_decided(y, y, x, x);
    ++pairs;
    if (both.is_empty())
      return;
    ++decided;
    result.judge("atan2",
                 {oracle::rounded_down(mpfr_atan2, y, x), oracle::rounded_up(mpfr_atan2, y, x)},
                 both, y, x);
  });
  INFO(decided << " of " << pairs << " decided");
  CHECK(pairs > 10'000);
  CHECK(decided > 0); // those whose double is too far from the convergent
  result.check();
}
#endif
