// The arithmetic functions on bounds: MPFR at the corners of boxes, and the definition of each
// decoration.
#include "exact_judge.hpp"
#include <catch2/catch.hpp>
#include <graze/decorated.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/rounding/fused.hpp>
#include <vector>

using graze::bounds;
using graze::decoration;
using graze::oracle::hard_boxes;
using graze::oracle::hard_operands;
using graze::oracle::hardness;
using graze::test::inputs;
using graze::test::same;
namespace f = graze::functions;
namespace oracle = graze::oracle;
namespace ranges = graze::oracle::ranges;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_CASE("interval.fma: the point function is MPFR's on hard operands", "[mpfr][hardcase]") {
  hard_operands numbers(1);
  const double largest = std::numeric_limits<double>::max();
  int wrong = 0;
  for (int i = 0; i < inputs(); ++i) {
    const auto p =
        numbers.next(static_cast<hardness>(numbers.below(static_cast<int>(hardness::count))));
    const double near = p.x * p.y;
    const int exponent = std::isnormal(near) ? std::ilogb(near) : 0;
    double z = 0;
    switch (numbers.below(8)) {
    case 0:
      z = numbers.special();
      break;
    case 1:
      z = -(p.x * p.y);
      break; // what is left is the product's error
    case 2:
      z = numbers.nudged(-(p.x * p.y));
      break;
    case 3:
      z = std::ldexp(numbers.with_exponent(0), exponent - 53);
      break;
    case 4:
      z = std::ldexp(1, exponent - 54 - static_cast<int>(numbers.below(60)));
      break;
    case 5:
      z = std::ldexp(1, exponent + 52 + static_cast<int>(numbers.below(60)));
      break;
    case 6:
      z = largest;
      break;
    default:
      z = numbers.any_normal();
      break;
    }
    if (numbers.coin())
      z = -z;
    for (const bool up : {false, true}) {
      const double got =
          up ? graze::rounding::fma_up(p.x, p.y, z) : graze::rounding::fma_down(p.x, p.y, z);
      const double expected = oracle::rounded(mpfr_fma, up ? MPFR_RNDU : MPFR_RNDD, p.x, p.y, z);
      if (!(got == expected || (got != got && expected != expected)) ||
          (got == 0 && std::signbit(got) != std::signbit(expected))) {
        if (++wrong < 5)
          UNSCOPED_INFO(std::hexfloat << p.x << " * " << p.y << " + " << z
                                      << (up ? " up " : " down ") << got << " expected "
                                      << expected);
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("interval.fma: the last of the error terms decides", "[regression]") {
  // 2^54 - 2 + 2^-53, where doubles are 2 apart below 2^54: the sums before are exact or ties.
  for (int e = -200; e <= 200; e += 50) {
    const double x = std::ldexp(0x1p27 - 1, e), y = 0x1p27 + 1, z = std::ldexp(0x1p-53 - 1, e);
    CHECK(graze::rounding::fma_up(x, y, z) == std::ldexp(0x1p54, e));
    CHECK(graze::rounding::fma_down(x, y, z) == std::ldexp(0x1p54 - 2, e));
    CHECK(graze::rounding::fma_up(-x, y, -z) == -std::ldexp(0x1p54 - 2, e));
  }
}

TEST_CASE("interval.arithmetic: tightest on hard boxes", "[mpfr][hardcase]") {
  hard_boxes boxes(2);
  std::vector<std::string> wrong;
  const auto check = [&](const char* name, const bounds& got, const bounds& expected,
                         const bounds& x, const bounds& y, const bounds& z) {
    if (!same(got, expected)) {
      std::ostringstream text;
      text << std::hexfloat << name << " [" << x.lo << "," << x.hi << "] [" << y.lo << "," << y.hi
           << "] [" << z.lo << "," << z.hi << "] gave [" << got.lo << "," << got.hi << "] not ["
           << expected.lo << "," << expected.hi << "]";
      wrong.push_back(text.str());
    }
  };
  for (int i = 0; i < inputs(); ++i) {
    const bounds x = boxes.next(), y = boxes.next(), z = boxes.next();
#define GRAZE_CHECK(name, ...)                                                                     \
  check(#name, f::name::value(__VA_ARGS__), ranges::name(__VA_ARGS__), x, y, z)
    GRAZE_CHECK(add, x, y);
    GRAZE_CHECK(sub, x, y);
    GRAZE_CHECK(mul, x, y);
    GRAZE_CHECK(div, x, y);
    GRAZE_CHECK(recip, x);
    GRAZE_CHECK(sqr, x);
    GRAZE_CHECK(sqrt, x);
    GRAZE_CHECK(abs, x);
    GRAZE_CHECK(min, x, y);
    GRAZE_CHECK(max, x, y);
    GRAZE_CHECK(fma, x, y, z);
#undef GRAZE_CHECK
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(wrong.size(), 5); ++i)
    UNSCOPED_INFO(wrong[i]);
  CHECK(wrong.empty());
}

TEST_CASE("interval.arithmetic: decorations of partial functions", "[unit]") {
  using enum decoration;
  const auto div = [](bounds x, bounds y) {
    return graze::local_decoration<f::div>(f::div::value(x, y), x, y);
  };
  CHECK(div({1, 2}, {1, 2}) == com);
  CHECK(div({1, 2}, {0, 2}) == trv);
  CHECK(div({1, 2}, {0, 0}) == trv);
  CHECK(div({1, 2}, {1, infinity}) == dac);
  CHECK(div({0x1p1000, 0x1p1000}, {0x1p-1000, 1}) == dac); // overflows
  CHECK(div(bounds::empty(), {1, 2}) == trv);
  const auto sqrt = [](bounds x) { return graze::local_decoration<f::sqrt>(f::sqrt::value(x), x); };
  CHECK(sqrt({0, 4}) == com);
  CHECK(sqrt({-0.0, infinity}) == dac);
  CHECK(sqrt({-0x1p-1074, 4}) == trv);
  CHECK(sqrt(bounds::empty()) == trv);
}

namespace {

/// The real function, by MPFR at t + side * 2^-1100: on one side of t whatever double lies there.
using real_function = void (*)(mpfr_ptr result, mpfr_ptr x);
bool is_beside(double t, int side, real_function function, double expected) {
  oracle::number x(2200);
  mpfr_set_d(x, t, MPFR_RNDN);
  oracle::number step(1.0);
  mpfr_mul_2si(step, step, -1100, MPFR_RNDN);
  mpfr_mul_si(step, step, side, MPFR_RNDN);
  mpfr_add(x, x, step, MPFR_RNDN);
  function(x, x);
  return mpfr_cmp_d(x, expected) == 0;
}

/// Is the step function constant on x, and continuous at its ends as seen from outside?
template <class F> void check_step(const char* name, const bounds& x, real_function function) {
  const bounds value = F::value(x);
  CAPTURE(name, x.lo, x.hi);
  if (x.is_empty()) {
    REQUIRE(value.is_empty());
    REQUIRE(F::local(x) == decoration::trv);
    return;
  }
  REQUIRE(is_beside(x.lo, 0, function, value.lo));
  REQUIRE(is_beside(x.hi, 0, function, value.hi));
  const bool constant = value.lo == value.hi;
  const decoration label = graze::local_decoration<F>(value, x);
  REQUIRE((label >= decoration::dac) == constant);
  REQUIRE(label >= decoration::def);
  if (constant && x.is_common() && std::fabs(x.lo) < 0x1p900) {
    const bool about =
        is_beside(x.lo, -1, function, value.lo) && is_beside(x.hi, 1, function, value.lo);
    REQUIRE((label == decoration::com) == about);
  }
}

} // namespace

TEST_CASE("interval.step functions: values by MPFR, decorations by their definition",
          "[mpfr][hardcase]") {
  hard_boxes boxes(3);
  auto& numbers = boxes.numbers;
  const auto integral = [&] { // about integers and half-integers, small and near 2^52
    const double base = numbers.coin()
                            ? static_cast<double>(numbers.below(8)) / 2
                            : std::ldexp(1, 50) + static_cast<double>(numbers.below(64)) / 2 - 8;
    const double x = numbers.coin() ? numbers.nudged(base) : base;
    return numbers.coin() ? -x : x;
  };
  for (int i = 0; i < inputs() / 2; ++i) {
    bounds x = boxes.next();
    if (numbers.below(4) != 0) {
      const double a = integral(), b = numbers.coin() ? a : integral();
      x = {std::min(a, b), std::max(a, b)};
    }
    check_step<f::ceil>("ceil", x, [](mpfr_ptr r, mpfr_ptr a) { mpfr_ceil(r, a); });
    check_step<f::floor>("floor", x, [](mpfr_ptr r, mpfr_ptr a) { mpfr_floor(r, a); });
    check_step<f::trunc>("trunc", x, [](mpfr_ptr r, mpfr_ptr a) { mpfr_trunc(r, a); });
    check_step<f::round_ties_to_even>("round_ties_to_even", x,
                                      [](mpfr_ptr r, mpfr_ptr a) { mpfr_roundeven(r, a); });
    check_step<f::round_ties_to_away>("round_ties_to_away", x,
                                      [](mpfr_ptr r, mpfr_ptr a) { mpfr_round(r, a); });
    check_step<f::sign>("sign", x,
                        [](mpfr_ptr r, mpfr_ptr a) { mpfr_set_si(r, mpfr_sgn(a), MPFR_RNDN); });
  }
}
