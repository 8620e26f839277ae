// Formulas with gaps, poles and jumps (continuity.cpp has the list of operations), and constants:
// nothing is certified where there is no zero, and a constant is between neighbouring doubles.
#include "../../support/formulas.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/interval.hpp>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_formula/derivatives.hpp>
#include <graze/octree_formula/lane_kernels.hpp>
#include <graze/rounding/nearest.hpp>
#include <mpfr.h>

using namespace graze;
using namespace graze::octree;
using up = rounding::upward;
using support::parsed;

namespace {

/// The number to 400 bits.
class number {
public:
  template <class Make> explicit number(Make make) {
    mpfr_init2(x_, 400);
    make(x_);
  }
  ~number() { mpfr_clear(x_); }
  number(const number&) = delete;
  number& operator=(const number&) = delete;
  [[nodiscard]] double down() const { return mpfr_get_d(x_, MPFR_RNDD); }
  [[nodiscard]] double up() const { return mpfr_get_d(x_, MPFR_RNDU); }
  [[nodiscard]] double nearest() const { return mpfr_get_d(x_, MPFR_RNDN); }

private:
  mpfr_t x_;
};
const number& log_2() {
  static const number x([](mpfr_ptr p) { mpfr_const_log2(p, MPFR_RNDN); });
  return x;
}
const number& log_10() {
  static const number x([](mpfr_ptr p) {
    mpfr_set_ui(p, 10, MPFR_RNDN);
    mpfr_log(p, p, MPFR_RNDN);
  });
  return x;
}

} // namespace

TEST_CASE("octree.formula: of one sign where it is defined, nothing is certified", "[regression]") {
  const box unit{{-1, -1, -1}, {1, 1, 1}}, across{{-.25, -.25, -.25}, {.5, .5, .5}};
  for (const char* text : {"sqrt(x)-2",
                           "rootn(x,2)-2",
                           "rootn(x,4)-2",
                           "rootn(x,6)-2",
                           "-rootn(x,-2)",
                           "-rootn(x,-4)",
                           "x^0.5-2",
                           "x^0.25-2",
                           "x^1.5-2",
                           "-x^y-1",
                           "log(x)-5",
                           "log2(x)-5",
                           "log10(x)-5",
                           "logp1(4x)-5",
                           "asin(4x)-2",
                           "acos(4x)-4",
                           "acosh(4x)-5",
                           "-abs(atanh(4x))-1",
                           "acoth(4x)",
                           "-1/sqrt(x)",
                           "rootn(x+y,4)-2",
                           "rootn(x,4)+rootn(z,2)-4",
                           "rootn(rootn(x,3),4)-2",
                           "-abs(1/x)",
                           "-1/x^2",
                           "-abs(cot(x))-1",
                           "-abs(csc(x))",
                           "-abs(coth(x))",
                           "-abs(csch(x))",
                           "-abs(rootn(x,-3))",
                           "-abs(sec(4x))",
                           "-abs(tan(4x))-1"}) {
    INFO(text);
    const formula f = parsed(text);
    {
      const up::scope scope;
      CHECK(leaf_content<up>(f.surface(), across) != content::certified);
    }
    CHECK_FALSE(f.surface().continuous());
    for (const int level : {2, 4}) {
      const auto tree = voxelize(f.surface(), unit, level);
      REQUIRE(tree);
      for (const content c : tree->leaves())
        CHECK(c != content::certified);
      const auto by_lanes = voxelize_in_lanes(f.surface(), unit, level);
      REQUIRE(by_lanes);
      for (const content c : by_lanes->leaves())
        CHECK(c != content::certified);
    }
    const auto certified = certified_traversal<formula_surface>::make(f.surface(), unit);
    REQUIRE(certified);
    for (const vec3& d : {vec3{1, 0, 0}, vec3{-1, 0, 0}, vec3{1, .125, .0625}}) {
      const ray r = *ray::make({d[0] > 0 ? -3.0 : 3.0, .3, .2}, d);
      CHECK(certified->first_hit(r).outcome != verdict::hit);
    }
  }
}

TEST_CASE("octree.formula: the constants of derivatives are MPFR's, between neighbouring doubles",
          "[regression][mpfr]") {
  const auto check = [](auto zero_to_one) {
    using N = decltype(zero_to_one);
    using d = dual<N, 1>;
    using o = tape::operations<d>;
    // 2^0 = 1 and 10^0 = 1, exactly: the slopes are the constants themselves
    const d at_zero{N(0.0), {N(1.0)}}, at_one{N(1.0), {N(1.0)}};
    const N two = o::exp2(at_zero).partial[0], ten = o::exp10(at_zero).partial[0];
    CHECK(two.lower() == log_2().down());
    CHECK(two.upper() == log_2().up());
    CHECK(ten.lower() == log_10().down());
    CHECK(ten.upper() == log_10().up());
    // their reciprocals, rounded twice
    const N of_two = o::log2(at_one).partial[0], of_ten = o::log10(at_one).partial[0];
    const number one_over_2([](mpfr_ptr p) {
      mpfr_const_log2(p, MPFR_RNDN);
      mpfr_ui_div(p, 1, p, MPFR_RNDN);
    });
    const number one_over_10([](mpfr_ptr p) {
      mpfr_set_ui(p, 10, MPFR_RNDN);
      mpfr_log(p, p, MPFR_RNDN);
      mpfr_ui_div(p, 1, p, MPFR_RNDN);
    });
    CHECK(of_two.lower() <= one_over_2.down());
    CHECK(one_over_2.up() <= of_two.upper());
    CHECK(of_ten.lower() <= one_over_10.down());
    CHECK(one_over_10.up() <= of_ten.upper());
    CHECK(of_two.upper() - of_two.lower() < 0x1p-49);
    CHECK(of_ten.upper() - of_ten.lower() < 0x1p-50);
  };
  {
    const up::scope scope;
    check(bound<up>(0.0, 1.0));
  }
  check(bound<rounding::nearest>(0.0, 1.0));
  using plain = tape::operations<dual<double, 1>>;
  CHECK(plain::exp2({0, {1}}).partial[0] == log_2().nearest());
  CHECK(plain::exp10({0, {1}}).partial[0] == log_10().nearest());
}

TEST_CASE("octree.formula: pi and e in a text are between neighbouring doubles", "[mpfr]") {
  const auto check = [](const char* text, const number& is) {
    INFO(text);
    bool found = false;
    const formula f = parsed(text);
    for (const tape::constant& c : f.surface().program().constants)
      found |= c.lo == is.down() && c.hi == is.up() && c.lo <= c.nearest && c.nearest <= c.hi;
    CHECK(found);
  };
  const number pi([](mpfr_ptr p) { mpfr_const_pi(p, MPFR_RNDN); }), e([](mpfr_ptr p) {
    mpfr_set_ui(p, 1, MPFR_RNDN);
    mpfr_exp(p, p, MPFR_RNDN);
  });
  for (const char* text : {"x+pi", "x*pi", "max(x, pi)"})
    check(text, pi);
  for (const char* text : {"x+e", "x*e", "max(x, e)"})
    check(text, e);
}
