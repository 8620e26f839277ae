// What compilers are known to do with operands that they see:
// fold, merge two divisions under two modes into one, rewrite -(y - x), contract a product into a
// sum.
#include <cstdio>
#include <graze/interval.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace rounding = graze::rounding;

namespace {

int failures = 0;

void expect(const char* backend, const char* expression, double found, double expected) {
  if (__builtin_memcmp(&found, &expected, sizeof found) == 0)
    return;
  ++failures;
  std::printf("%s: %s is %a, must be %a\n", backend, expression, found, expected);
}

template <class B> void cases() {
  {
    [[maybe_unused]] const typename B::scope scope;
    const double one = 1, three = 3, tenth = 0.1;
    const double down = B::div_down(one, three), up = B::div_up(one, three);
    expect(B::name, "1/3 rounded down, one of two divisions", down, 0x1.5555555555555p-2);
    expect(B::name, "1/3 rounded up, one of two divisions", up, 0x1.5555555555556p-2);
    expect(B::name, "-(y - x)", B::sub_down(tenth, three), -0x1.7333333333334p+1);
    expect(B::name, "y - x", B::sub_up(tenth, three), -0x1.7333333333333p+1);
    expect(B::name, "x - x down", B::sub_down(tenth, tenth), -0.0);
    expect(B::name, "x - x up", B::sub_up(tenth, tenth), 0.0);
    expect(B::name, "sqrt 2 down", B::sqrt_down(2.0), 0x1.6a09e667f3bccp+0);
    expect(B::name, "sqrt 2 up", B::sqrt_up(2.0), 0x1.6a09e667f3bcdp+0);
    expect(B::name, "2^-1074 / 2 up", B::div_up(0x1p-1074, 2.0), 0x1p-1074);
    expect(B::name, "2^1023 * 2 down", B::mul_down(0x1p1023, 2.0), 0x1.fffffffffffffp+1023);
    // a value held in an x87 register would give 0x1.8p-1020
    const double tiny = B::mul_up(B::mul_up(0x1p-600, 1.5), 0x1p-500);
    expect(B::name, "(2^-600 * 1.5 * 2^-500) * 2^80 up", B::mul_up(tiny, 0x1p80), 0x1p-994);
  }
  using I = graze::interval<B>;
  const I sum = I(0.1) + I(0.2), other = I(0.1) + I(0.7);
  expect(B::name, "lower end of 0.1 + 0.2", sum.lower(), 0x1.3333333333333p-2);
  expect(B::name, "upper end of 0.1 + 0.2", sum.upper(), 0x1.3333333333334p-2);
  expect(B::name, "lower end of 0.1 + 0.7", other.lower(), 0x1.9999999999999p-1);
  expect(B::name, "upper end of 0.1 + 0.7", other.upper(), 0x1.999999999999ap-1);
}

/// Double results that are floats where the exact ones are not, or that overflow as floats.
template <class B> void float_cases() {
  using F = graze::float_interval<B>;
  const auto both = [](const char* expression, const F& x, double lower, double upper) {
    expect(B::name, expression, x.lower(), lower);
    expect(B::name, expression, x.upper(), upper);
  };
  both("1/3 of floats", F(1.0f) / F(3.0f), 0x1.555554p-2, 0x1.555556p-2);
  both("1 + 2^-60 of floats", F(1.0f) + F(0x1p-60f), 1, 0x1.000002p+0);
  both("1 - 2^-60 of floats", F(1.0f) - F(0x1p-60f), 0x1.fffffep-1, 1);
  both("2^-100 squared", F(0x1p-100f) * F(0x1p-100f), 0, 0x1p-149);
  both("2^127 * 2 of floats", F(0x1p127f) * F(2.0f), 0x1.fffffep+127, __builtin_inf());
  both("sqrt 2 of floats", sqrt(F(2.0f)), 0x1.6a09e6p+0, 0x1.6a09e8p+0);
  both("0.1 as floats", F(0.1), 0x1.999998p-4, 0x1.99999ap-4);
  both("2^24 + 1 as floats", F(16777217), 0x1p24, 0x1.000002p+24);
}

/// The caller's product beside the backend's sum, where -ffp-contract=fast would like to fuse them.
template <class B> [[gnu::noinline]] double product_then_sum(double x, double y, double z) {
  [[maybe_unused]] const typename B::scope scope;
  return B::add_down(x * y, z);
}
template <class B>
[[gnu::noinline]] double product_up_then_plain_sum(double x, double y, double z) {
  double product = 0;
  {
    [[maybe_unused]] const typename B::scope scope;
    product = B::mul_up(x, y);
  }
  return product + z;
}

} // namespace

int visible_operands() {
  cases<rounding::switching>();
  cases<rounding::upward>();
  cases<rounding::nearest>();
  cases<rounding::split>();
  float_cases<rounding::switching>();
  float_cases<rounding::upward>();
  float_cases<rounding::nearest>();
  float_cases<rounding::split>();
  // (1 + 2^-52)^2 = 1 + 2^-51 + 2^-104: rounded first, its sum with -(1 + 2^-51) is 0, a fused one
  // 2^-104
  const double x = 0x1.0000000000001p+0, z = -0x1.0000000000002p+0;
  expect("nearest", "add_down(x * y, z)", product_then_sum<rounding::nearest>(x, x, z), -0.0);
  // and rounded up it is 1 + 3 2^-52
  expect("nearest", "mul_up(x, y) + z", product_up_then_plain_sum<rounding::nearest>(x, x, z),
         0x1p-52);
  expect("upward", "mul_up(x, y) + z", product_up_then_plain_sum<rounding::upward>(x, x, z),
         0x1p-52);
  std::printf("visible operands: %d wrong\n", failures);
  return failures;
}
