// Random formulas: every enclosure holds MPFR's values, every gradient MPFR's differences, and what
// is said to be continuous is defined.
#include "../surface_judge.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/octree/inclusion.hpp>
#include <graze/octree_formula.hpp>
#include <graze/oracle/formula_tree.hpp>
#include <graze/rounding/nearest.hpp>

using namespace graze;
using namespace graze::octree;
using judge::real;
using up = rounding::upward;

namespace {

box some_box(judge::random_source& random) {
  static constexpr std::array<double, 9> places{0, 1, -1, 0.5, -0.5, 2, 1.5, -2, 3};
  box b;
  const int finest = static_cast<int>(random.below(45));
  for (int a = 0; a < 3; ++a) {
    const double p =
        random.below(3) == 0 ? places[random.below(places.size())] : random.in(-2.5, 2.5);
    const double size = random.below(8) == 0 ? 0 : std::ldexp(random.in(0, 1), -finest);
    b.lo[a] = p - (random.below(2) == 0 ? size : 0);
    b.hi[a] = p + size;
  }
  return b;
}
/// Up to a slack for the judge's own error.
template <class I> bool holds(const I& x, const real& v, const real& relative) {
  const real slack = relative * (1 + abs(v));
  return real(x.lower()) <= v + slack && v - slack <= real(x.upper());
}

/// The derivative by central differences, where two steps agree.
std::optional<real> difference(const oracle::tree& f, std::array<real, 3> p, std::size_t axis) {
  std::optional<real> slopes[2];
  const real at = p[axis];
  for (int i = 0; i < 2; ++i) {
    const real h = i == 0 ? real("1e-40") : real("1e-42");
    p[axis] = at + h;
    const auto above = f(p);
    p[axis] = at - h;
    const auto below = f(p);
    if (!above || !below || abs(*above) > real("1e60"))
      return std::nullopt;
    slopes[i] = real((*above - *below) / (2 * h));
  }
  if (abs(*slopes[0] - *slopes[1]) > real("1e-28") * (1 + abs(*slopes[0])))
    return std::nullopt;
  return slopes[1];
}

struct tally {
  int formulas = 0, values = 0, slopes = 0, continuous = 0, wrong = 0;
};

void examine(tally& t, judge::random_source& random, const oracle::tree& tree, int boxes) {
  const auto f = formula::parse(tree.text);
  if (!f) { // a part that is constant may be undefined, or too large
    const bool fair = f.reason().find("not defined") != std::string::npos ||
                      f.reason().find("overflows") != std::string::npos ||
                      f.reason().find("by zero") != std::string::npos ||
                      f.reason().find("negative powers") != std::string::npos;
    INFO(tree.text << ": " << f.reason());
    CHECK(fair);
    return;
  }
  ++t.formulas;
  const formula_surface surface = f->surface();
  for (int i = 0; i < boxes; ++i) {
    const box b = some_box(random);
    bound<up> natural, mean;
    dual<bound<up>> gradient;
    dual<bound<up>, 1> along;
    bool continuous, none;
    {
      const up::scope scope;
      const auto x = intervals<up>(b);
      natural = natural_extension<up>(surface, x);
      gradient = value_and_gradient<up>(surface, x);
      mean = mean_value_form<up>(surface, x, gradient.partial);
      continuous = surface.continuous_on<up>(x);
      none = has_no_zero<up>(surface, b);
      using d = dual<bound<up>, 1>;
      const bound<up> one(1.0), zero(0.0);
      along = surface(d{x[0], {one}}, d{x[1], {zero}}, d{x[2], {zero}});
    }
    using anywhere = interval<rounding::nearest>;
    const anywhere same =
        surface(anywhere(b.lo[0], b.hi[0]), anywhere(b.lo[1], b.hi[1]), anywhere(b.lo[2], b.hi[2]));
    const auto complain = [&](const char* name, const vec3& p) {
      if (t.wrong++ < 5)
        FAIL_CHECK(name << ": " << tree.text << " at " << p[0] << "," << p[1] << "," << p[2]
                        << " in [" << b.lo[0] << "," << b.hi[0] << "]x[" << b.lo[1] << ","
                        << b.hi[1] << "]x[" << b.lo[2] << "," << b.hi[2] << "]: natural ["
                        << natural.lower() << "," << natural.upper() << "] mean [" << mean.lower()
                        << "," << mean.upper() << "]");
    };
    if (same.lower() != natural.lower() || same.upper() != natural.upper())
      complain("backends differ", b.lo);
    if (along.partial[0].lower() != gradient.partial[0].lower() ||
        along.partial[0].upper() != gradient.partial[0].upper())
      complain("one partial is not the first of three", b.lo);
    t.continuous += continuous;
    for (int k = 0; k < 3; ++k) {
      const vec3 p = judge::some_point(random, b);
      const std::array<real, 3> at{real(p[0]), real(p[1]), real(p[2])};
      oracle::tree::gave_up = false;
      const auto exact = tree(at);
      if (!exact) {
        if (continuous && !oracle::tree::gave_up)
          complain("not defined where it is called continuous", p);
        continue;
      }
      ++t.values;
      const real tiny("1e-100");
      if (!holds(natural, *exact, tiny) || !holds(gradient.value, *exact, tiny))
        complain("value", p);
      if (!(mean.lower() != mean.lower()) && !holds(mean, *exact, tiny))
        complain("mean value form", p);
      if (none && *exact == 0)
        complain("a zero denied", p);
    }
    // slopes are those of f on the box, whatever it does beside it: at a point within
    std::array<real, 3> within;
    for (std::size_t a = 0; a < 3; ++a)
      within[a] = real(b.lo[a]) + (real(b.hi[a]) - real(b.lo[a])) * random.in(0.1, 0.9);
    oracle::tree::gave_up = false;
    for (std::size_t a = 0; a < 3; ++a) {
      if (b.lo[a] == b.hi[a])
        continue;
      if (const auto slope = difference(tree, within, a)) {
        ++t.slopes;
        if (!holds(gradient.partial[a], *slope, real("1e-25")))
          complain("slope", b.lo);
      }
    }
  }
}

} // namespace

TEST_CASE("octree.formula: random formulas enclose MPFR's values and differences",
          "[property][mpfr]") {
  judge::random_source random(41);
  oracle::random_bits formulas(41);
  tally t;
  for (int i = 0; i < 3000; ++i)
    examine(t, random, *oracle::some_tree(formulas, 1 + static_cast<int>(random.below(4)), false),
            8);
  CHECK(t.wrong == 0);
  CHECK(t.formulas > 2000);
  CHECK(t.values > 20000);
  CHECK(t.slopes > 10000);
  CHECK(t.continuous > 8000);
}

TEST_CASE("octree.formula: random polynomials enclose MPFR's values and differences",
          "[property][mpfr]") {
  judge::random_source random(43);
  oracle::random_bits formulas(43);
  tally t;
  for (int i = 0; i < 1500; ++i)
    examine(t, random, *oracle::some_tree(formulas, 2 + static_cast<int>(random.below(5)), true),
            8);
  CHECK(t.wrong == 0);
  CHECK(t.formulas > 1400);
  CHECK(t.slopes > 20000);
}

TEST_CASE("octree.formula: polynomials in one variable have their range, but for rounding",
          "[property][mpfr]") {
  judge::random_source random(47);
  int loose = 0, wrong = 0, tried = 0;
  for (int i = 0; i < 150; ++i) {
    // with roots at halves, some of them double, so that turns are also at zeros
    std::string text;
    std::vector<double> c;
    const int degree = 3 + static_cast<int>(random.below(7));
    for (int k = degree; k >= 0; --k) {
      const double value = k == degree ? 1 : std::nearbyint(random.in(-9, 9)) / 2;
      c.push_back(value);
      text.append(value < 0 ? "-" : "+").append(std::to_string(std::fabs(value)));
      if (k > 0)
        text.append("*x^").append(std::to_string(k));
    }
    const auto f = formula::parse(text);
    REQUIRE(f);
    REQUIRE(f->surface().natural_extension_suffices());
    for (int k = 0; k < 20; ++k) {
      const double a = random.in(-2, 2),
                   b = a + std::ldexp(random.in(0, 2), -static_cast<int>(random.below(12)));
      using I = interval<>;
      const I v = f->surface()(I(a, b), I(0), I(0));
      real least, greatest;
      constexpr int samples = 400;
      for (int s = 0; s <= samples; ++s) {
        const real x = real(a) + (real(b) - real(a)) * s / samples;
        real r = 0;
        for (const double coefficient : c)
          r = r * x + coefficient;
        least = s == 0 || r < least ? r : least;
        greatest = s == 0 || greatest < r ? r : greatest;
      }
      ++tried;
      wrong += !(real(v.lower()) <= least && greatest <= real(v.upper()));
      // sampling misses a parabola's turn by (step/2)^2 f''/2
      const real slack = 1e-9 + 0.01 * (greatest - least);
      loose += real(v.lower()) < least - slack || greatest + slack < real(v.upper());
    }
  }
  CHECK(tried == 3000);
  CHECK(wrong == 0);
  CHECK(loose == 0);
}
