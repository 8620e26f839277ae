// Sums: GMP's rationals, rounded once by MPFR.
#include "exact_judge.hpp"
#include <catch2/catch.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/reductions.hpp>
#include <vector>

using graze::rounded;
using graze::oracle::hard_operands;
using graze::oracle::hardness;

TEST_CASE("interval.reductions: correctly rounded in each direction", "[mpfr][hardcase]") {
  hard_operands numbers(7);
  const std::pair<rounded, mpfr_rnd_t> directions[] = {
      {rounded::nearest, MPFR_RNDN}, {rounded::down, MPFR_RNDD}, {rounded::up, MPFR_RNDU}};
  int wrong = 0;
  const auto check = [&](double got, const mpq_class& exact, mpfr_rnd_t to) {
    const double expected = graze::test::rounded(exact, to);
    if (got != expected && ++wrong < 5)
      UNSCOPED_INFO(std::hexfloat << got << " expected " << expected);
  };
  for (int i = 0; i < graze::test::inputs() / 4; ++i) {
    std::vector<double> x, y;
    const auto length = 1 + numbers.below(12);
    while (x.size() < length) {
      const auto p =
          numbers.next(static_cast<hardness>(numbers.below(static_cast<int>(hardness::count))));
      if (!std::isfinite(p.x) || !std::isfinite(p.y))
        continue;
      x.push_back(p.x);
      y.push_back(p.y);
      if (numbers.coin()) { // cancels all but a little, or all
        x.push_back(numbers.coin() ? -p.x : numbers.nudged(-p.x));
        y.push_back(p.y);
        if (!std::isfinite(x.back()))
          x.back() = 0;
      }
    }
    mpq_class sum, sum_abs, sum_sqr, dot;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const mpq_class a(x[k]), b(y[k]);
      sum += a;
      sum_abs += abs(a);
      sum_sqr += a * a;
      dot += a * b;
    }
    for (const auto& [direction, to] : directions) {
      check(graze::sum(x, direction), sum, to);
      check(graze::sum_abs(x, direction), sum_abs, to);
      check(graze::sum_sqr(x, direction), sum_sqr, to);
      check(graze::dot(x, y, direction), dot, to);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("interval.reductions: ties, overflow on the way, subnormal sums", "[unit][hardcase]") {
  using v = std::vector<double>;
  constexpr double largest = std::numeric_limits<double>::max(), least = 0x1p-1074;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(graze::sum(v{1, 0x1p-53}) == 1);
  CHECK(graze::sum(v{1, 0x1p-53, least}) == 1 + 0x1p-52);
  CHECK(graze::sum(v{1 + 0x1p-52, 0x1p-53}) == 1 + 0x1p-51);
  CHECK(graze::sum(v{1 + 0x1p-52, 0x1p-53, -least}) == 1 + 0x1p-52);
  CHECK(graze::sum(v{largest, largest, -largest}) == largest);
  CHECK(graze::sum(v{largest, 0x1p970}) == infinity);
  CHECK(graze::sum(v{largest, 0x1p970, -least}) == largest);
  CHECK(graze::sum(v{largest, 0x1p970}, rounded::down) == largest);
  CHECK(graze::sum(v{-largest, -largest}, rounded::up) == -largest);
  CHECK(graze::dot(v{least}, v{0.5}) == 0);
  CHECK(graze::dot(v{least, least}, v{0.5, least}) == least);
  CHECK(graze::dot(v{least}, v{least}, rounded::up) == least);
  CHECK(graze::dot(v{-least}, v{least}, rounded::down) == -least);
  CHECK(graze::sum_sqr(v{largest, largest}, rounded::down) == largest);
  CHECK(graze::dot(v{largest, largest}, v{largest, -largest}) == 0);
  for (const rounded to : {rounded::nearest, rounded::down, rounded::up}) {
    CHECK(!std::signbit(graze::sum(v{}, to)));
    CHECK(!std::signbit(graze::sum(v{1, -1}, to)));
    CHECK(!std::signbit(graze::sum(v{-0.0, -0.0}, to)));
  }
  CHECK(graze::sum(v(100000, largest), rounded::down) == largest);
  CHECK(graze::sum(v(1 << 20, 0.1)) == 0x1.999999999999ap-4 * 0x1p20);
}

TEST_CASE("interval.reductions: NaN and infinities", "[unit]") {
  using v = std::vector<double>;
  constexpr double infinity = std::numeric_limits<double>::infinity(),
                   nan = std::numeric_limits<double>::quiet_NaN();
  for (const rounded to : {rounded::nearest, rounded::down, rounded::up}) {
    CHECK(std::isnan(graze::sum(v{1, nan}, to)));
    CHECK(std::isnan(graze::sum(v{infinity, -infinity}, to)));
    CHECK(std::isnan(graze::sum(v{infinity, nan, infinity}, to)));
    CHECK(graze::sum(v{1, -infinity, -infinity}, to) == -infinity);
    CHECK(graze::sum_abs(v{infinity, -infinity}, to) == infinity);
    CHECK(graze::sum_sqr(v{infinity, -infinity, 1}, to) == infinity);
    CHECK(std::isnan(graze::sum_sqr(v{infinity, nan}, to)));
    CHECK(std::isnan(graze::dot(v{infinity, 1}, v{0, 1}, to)));
    CHECK(std::isnan(graze::dot(v{infinity, 1}, v{1, -infinity}, to)));
    CHECK(graze::dot(v{infinity, 1}, v{-2, -infinity}, to) == -infinity);
  }
}
