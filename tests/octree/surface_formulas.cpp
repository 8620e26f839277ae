// Formulas over all their number types: enclosures hold the exact values, and are tight.
#include "surface_judge.hpp"
#include "surface_scenes.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <gmpxx.h>
#include <graze/octree/inclusion.hpp>
#include <graze/rounding/nearest.hpp>
#include <limits>

using namespace graze;
using namespace graze::octree;
using judge::real;
using up = rounding::upward;

namespace {

/// A box that is random, or thin, or flat, or a few ulps beside a place where a formula turns.
template <class S> box some_box(judge::random_source& random, const S& scene) {
  static constexpr std::array<double, 8> turns{0,
                                               1,
                                               -1,
                                               0x1.279a74590331cp-1,
                                               -0x1.279a74590331cp-1,
                                               1.75,
                                               -2.5,
                                               0x1.94c583ada5b53p+0}; // sqrt(5/2)
  box b;
  for (int a = 0; a < 3; ++a) {
    double p = random.in(-scene.reach, scene.reach);
    if (random.below(3) == 0)
      p = turns[random.below(turns.size())];
    double size = std::ldexp(random.in(0, 1), -static_cast<int>(random.below(56)));
    if (random.below(6) == 0)
      size = 0;
    b.lo[a] = p - (random.below(2) == 0 ? size : 0);
    b.hi[a] = p + size;
  }
  return b;
}

template <class I> bool holds(const I& x, const real& v) {
  return real(x.lower()) <= v && v <= real(x.upper());
}

} // namespace

TEST_CASE("octree.formula: constants are enclosed by neighbouring doubles", "[unit]") {
  const auto check = [](rational_bounds b, long p, long q) {
    const mpq_class exact = mpq_class(p) / mpq_class(q);
    CHECK(mpq_class(b.lo) <= exact);
    CHECK(exact <= mpq_class(b.hi));
    CHECK((b.lo == b.hi || std::nextafter(b.lo, INFINITY) == b.hi));
    CHECK((b.lo == b.hi) == (mpq_class(b.lo) == exact));
    CHECK(b.nearest == static_cast<double>(p) / static_cast<double>(q));
  };
  check(enclose_rational(139, 20), 139, 20);
  check(enclose_rational(59, 5), 59, 5);
  check(enclose_rational(1, 3), 1, 3);
  check(enclose_rational(-7, 3), -7, 3);
  check(enclose_rational(5, 2), 5, 2);
  check(enclose_rational(1, 1000003), 1, 1000003);
}

TEST_CASE("octree.formula: cube_minus_identity encloses MPFR's range and is tight",
          "[property][mpfr]") {
  judge::random_source random(3);
  const real turn = 1 / sqrt(real(3)), extremum = 2 / (3 * sqrt(real(3)));
  const auto h = [](const real& x) { return real(x * x * x - x); };
  const double turn_down = 0x1.279a74590331cp-1, turn_up = 0x1.279a74590331dp-1;
  CHECK(real(turn_down) < turn);
  CHECK(turn < real(turn_up));
  std::vector<double> hard{0,        1,         -1,         turn_down, turn_up, -turn_down,
                           -turn_up, 0x1p-1074, -0x1p-1074, 0x1p-540,  2,       1e100};
  for (const double x : std::vector<double>(hard)) {
    hard.push_back(std::nextafter(x, 9e300));
    hard.push_back(std::nextafter(x, -9e300));
  }
  const up::scope scope;
  int wrong = 0, loose = 0;
  for (int i = 0; i < 100000; ++i) {
    const bool pair = i < static_cast<int>(hard.size() * hard.size());
    double a = pair ? hard[i / hard.size()] : random.in(-2.5, 2.5);
    double b = pair ? hard[i % hard.size()]
                    : a + std::ldexp(random.in(0, 1), -static_cast<int>(random.below(54)));
    if (random.below(3) == 0 && !pair)
      b = hard[random.below(static_cast<unsigned>(hard.size()))];
    if (b < a)
      std::swap(a, b);
    const auto x = cube_minus_identity(bound<up>(a, b));
    real lo = std::min(h(real(a)), h(real(b))), hi = std::max(h(real(a)), h(real(b)));
    if (real(a) <= turn && turn <= real(b))
      lo = std::min(lo, real(-extremum));
    if (real(a) <= -turn && -turn <= real(b))
      hi = std::max(hi, extremum);
    wrong += !(real(x.lower()) <= lo && hi <= real(x.upper()));
    // at most four ulps, in units of the bound itself
    const auto slack = [](const real& v) {
      return real(abs(v) * std::ldexp(1.0, -50) + 0x1p-1073);
    };
    loose += real(x.lower()) < lo - slack(lo) || real(x.upper()) > hi + slack(hi);
  }
  CHECK(wrong == 0);
  CHECK(loose == 0);
}

TEST_CASE("octree.surfaces: natural extension, mean value form and gradient hold MPFR's values",
          "[property][mpfr]") {
  scenes::for_each([](const auto& scene) {
    judge::random_source random(17);
    int wrong_natural = 0, wrong_mean = 0, wrong_gradient = 0, loose = 0, far_normal = 0,
        unequal = 0;
    for (int i = 0; i < 4000; ++i) {
      const box b = some_box(random, scene);
      bound<up> natural, mean;
      dual<bound<up>> gradient;
      {
        const up::scope scope;
        const auto x = intervals<up>(b);
        natural = natural_extension<up>(scene.surface, x);
        gradient = value_and_gradient<up>(scene.surface, x);
        mean = mean_value_form<up>(scene.surface, x, gradient.partial);
      }
      using anywhere = interval<rounding::nearest>; // needs no scope; the same bounds
      const anywhere same = scene.surface(anywhere(b.lo[0], b.hi[0]), anywhere(b.lo[1], b.hi[1]),
                                          anywhere(b.lo[2], b.hi[2]));
      unequal += same.lower() != natural.lower() || same.upper() != natural.upper();
      for (int k = 0; k < 4; ++k) {
        const vec3 p = judge::some_point(random, b);
        using d = dual<real>;
        const d exact = scene.surface(d::variable(real(p[0]), 0), d::variable(real(p[1]), 1),
                                      d::variable(real(p[2]), 2));
        CHECK(exact.value == scene.surface(real(p[0]), real(p[1]), real(p[2])));
        wrong_natural += !holds(natural, exact.value);
        wrong_mean += !holds(mean, exact.value);
        const vec3 shading = normal(scene.surface, p);
        for (int a = 0; a < 3; ++a) {
          wrong_gradient += !holds(gradient.partial[a], exact.partial[a]);
          far_normal += abs(real(shading[a]) - exact.partial[a]) > real(1e-12);
        }
      }
      // the corners' values and the turning points in between make the range: on a box of one point
      // the enclosure is a few roundings wide
      if (b.lo == b.hi)
        loose += !(natural.upper() - natural.lower() < 1e-13);
    }
    INFO("reach " << scene.reach);
    CHECK(wrong_natural == 0);
    CHECK(wrong_mean == 0);
    CHECK(wrong_gradient == 0);
    CHECK(far_normal == 0);
    CHECK(loose == 0);
    CHECK(unequal == 0);
  });
}

TEST_CASE("octree.inclusion: the centre of a flat subnormal box is in the box", "[regression]") {
  // half of it, rounded up, twice, is twice the number: a centre outside, and a bound without
  // 2^-148
  const auto square = [](const auto& x, const auto&, const auto&) { return sqr(x * 0x1p1000); };
  const box flat{{0x1p-1074, 0, 0}, {0x1p-1074, 0, 0}};
  const up::scope scope;
  const auto x = intervals<up>(flat);
  const auto bounds = mean_value_form<up>(square, x, value_and_gradient<up>(square, x).partial);
  CHECK(bounds.lower() == 0x1p-148);
  CHECK(bounds.upper() == 0x1p-148);
}

TEST_CASE("octree.inclusion: certified signs are MPFR's, and known off the surface",
          "[property][mpfr]") {
  scenes::for_each([](const auto& scene) {
    judge::random_source random(23);
    const up::scope scope;
    int wrong = 0, unknown = 0, known_beside = 0;
    for (int i = 0; i < 3000; ++i) {
      vec3 p, q;
      for (int a = 0; a < 3; ++a) {
        p[a] = random.in(-scene.reach, scene.reach);
        q[a] = p[a];
      }
      const real value = scene.surface(real(p[0]), real(p[1]), real(p[2]));
      const int sign = certified_sign_at<up>(scene.surface, p);
      wrong += sign != 0 && sign != value.sign();
      unknown += sign == 0 && abs(value) > real(1e-12);
      // walk to the surface along an axis, to neighbouring doubles on either side of it
      q[i % 3] = random.in(-scene.reach, scene.reach);
      if (judge::sign_at(scene.surface, q) == value.sign())
        continue;
      while (true) {
        vec3 middle = p;
        middle[i % 3] = p[i % 3] / 2 + q[i % 3] / 2;
        if (middle == p || middle == q)
          break;
        const int exact = judge::sign_at(scene.surface, middle),
                  certified = certified_sign_at<up>(scene.surface, middle);
        wrong += certified != 0 && certified != exact;
        known_beside += certified != 0;
        (exact == value.sign() ? p : q) = middle;
      }
    }
    INFO("reach " << scene.reach);
    CHECK(wrong == 0);
    CHECK(unknown == 0);
    CHECK(known_beside > 10000);
  });
}

TEST_CASE("octree.dual: quotient and root follow their rules", "[unit]") {
  using d = dual<double>;
  const d x = d::variable(2, 0), y = d::variable(4, 1);
  const d q = x / y, r = sqrt(y), s = -(x * y) + 3.0 - y;
  CHECK(q.value == 0.5);
  CHECK(q.partial == vec3{0.25, -0.125, 0});
  CHECK(r.value == 2);
  CHECK(r.partial == vec3{0, 0.25, 0});
  CHECK(s.value == -9);
  CHECK(s.partial == vec3{-4, -3, 0});
}
