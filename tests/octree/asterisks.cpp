// The asterisks: enclosures and derivatives hold MPFR's values, off and on the axis and at the
// origin; no octant with a point of the surface is dropped; the lanes agree.
#include "surface_judge.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/octree/asterisk.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/lazy_octree.hpp>
#include <graze/octree/voxelizer.hpp>

using namespace graze;
using namespace graze::octree;
using judge::real;
using up = rounding::upward;

namespace {

const box unit{{-1, -1, -1}, {1, 1, 1}};

/// By sines and angles, with the values that asterisk.hpp gives to the axis and the origin.
template <int M, int N> real exact(const real& x, const real& y, const real& z) {
  const real rho = sqrt(real(x * x + y * y)), distance = sqrt(real(x * x + y * y + z * z));
  if (rho == 0)
    return -distance;
  return real(sin(real(M * atan2(y, x))) * sin(real(N * atan2(rho, z))) - distance);
}

/// Boxes at large, at the axis, at the cut of atan2, at the poles and at the origin; thin and flat.
box some_box(judge::random_source& random) {
  box b;
  const unsigned kind = random.below(6);
  const int finest = static_cast<int>(random.below(kind == 5 ? 1000 : 50));
  for (int a = 0; a < 3; ++a) {
    double p = random.in(-1, 1);
    if (kind == 0 || kind == 5 || (kind == 1 && a < 2) || (kind == 2 && a == 1))
      p = random.below(2) == 0 ? 0 : std::ldexp(p, -finest);
    if (kind == 3)
      p = std::ldexp(std::nearbyint(4 * p), -2);
    const double size = random.below(8) == 0 ? 0 : std::ldexp(random.in(0, 1), -finest);
    b.lo[a] = p - (random.below(2) == 0 ? size : 0);
    b.hi[a] = p + size;
  }
  return b;
}

template <int M, int N> void enclosures() {
  const asterisk<M, N> f;
  judge::random_source random(100 * M + N);
  int wrong = 0, wrong_mean = 0, wrong_slope = 0, wrong_sign = 0, slopes = 0, bounded = 0,
      wrong_value = 0, loose = 0;
  for (int i = 0; i < 4000; ++i) {
    const box b = some_box(random);
    bound<up> natural, mean;
    dual<bound<up>> g;
    {
      const up::scope scope;
      const auto x = intervals<up>(b);
      natural = natural_extension<up>(f, x);
      g = value_and_gradient<up>(f, x);
      mean = mean_value_form<up>(f, x, g.partial);
    }
    CHECK(natural.lower() == g.value.lower());
    CHECK(natural.upper() == g.value.upper());
    const bool has_origin = b.lo[0] <= 0 && b.lo[1] <= 0 && b.lo[2] <= 0 && b.hi[0] >= 0 &&
                            b.hi[1] >= 0 && b.hi[2] >= 0;
    if (has_origin) {
      wrong += !(natural.lower() <= 0 && natural.upper() >= 0);
      wrong_mean += mean.lower() > 0 || mean.upper() < 0;
    }
    for (int k = 0; k < 3; ++k) {
      const vec3 p = judge::some_point(random, b);
      const real v = exact<M, N>(real(p[0]), real(p[1]), real(p[2]));
      // the judge's own error at 600 bits, of angles near the axis
      const real slack("1e-150");
      wrong += !(real(natural.lower()) <= v + slack && v - slack <= real(natural.upper()));
      if (mean.lower() <= mean.upper())
        wrong_mean += !(real(mean.lower()) <= v + slack && v - slack <= real(mean.upper()));
      const up::scope scope;
      const int sign = certified_sign_at<up>(f, p);
      wrong_sign += sign != 0 && abs(v) > slack && sign != v.sign();
      if (std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}) < 0x1p-450)
        continue; // squares underflow
      loose += sign == 0 && abs(v) > real(1e-12);
      wrong_value += std::fabs(f(p[0], p[1], p[2]) - v.convert_to<double>()) > 1e-12;
    }
    std::array<real, 3> within;
    for (std::size_t a = 0; a < 3; ++a)
      within[a] = real(b.lo[a]) + (real(b.hi[a]) - real(b.lo[a])) * random.in(0.1, 0.9);
    if (abs(within[0]) + abs(within[1]) < real("1e-12"))
      continue; // differences of the judge's are too coarse
    for (std::size_t a = 0; a < 3; ++a) {
      const real h("1e-45");
      auto after = within, before = within;
      after[a] += h;
      before[a] -= h;
      const real slope = (exact<M, N>(after[0], after[1], after[2]) -
                          exact<M, N>(before[0], before[1], before[2])) /
                         (2 * h);
      ++slopes;
      const real slack = real("1e-20") * (1 + abs(slope));
      if (b.lo[a] < b.hi[a] || (b.lo[0] == b.hi[0] && b.lo[1] == b.hi[1] && b.lo[2] == b.hi[2]))
        wrong_slope += g.partial[a].lower() <= g.partial[a].upper() &&
                       !(real(g.partial[a].lower()) <= slope + slack &&
                         slope - slack <= real(g.partial[a].upper()));
      bounded += std::isfinite(g.partial[a].lower()) && std::isfinite(g.partial[a].upper());
    }
  }
  CHECK(wrong == 0);
  CHECK(wrong_mean == 0);
  CHECK(wrong_slope == 0);
  CHECK(wrong_sign == 0);
  CHECK(wrong_value == 0);
  CHECK(loose == 0);
  CHECK(slopes > 7000);
  CHECK(bounded > slopes / 2);
}

/// The octants of the level that hold the point: eight at most, if it lies in their faces.
template <class Octree> bool all_kept(const Octree& tree, const std::array<real, 3>& p) {
  const double cells = std::ldexp(1.0, tree.level());
  unsigned first[3], last[3];
  for (std::size_t a = 0; a < 3; ++a) {
    const real at = (p[a] - real(tree.root_octant().lo[a])) / real(tree.root_octant().size) * cells;
    const real whole = floor(at);
    const int index = whole.template convert_to<int>();
    last[a] = static_cast<unsigned>(std::min(index, static_cast<int>(cells) - 1));
    first[a] = at == whole && index > 0 ? static_cast<unsigned>(index - 1) : last[a];
  }
  for (unsigned x = first[0]; x <= last[0]; ++x)
    for (unsigned y = first[1]; y <= last[1]; ++y)
      for (unsigned z = first[2]; z <= last[2]; ++z) {
        auto n = tree.root();
        for (int bit = tree.level() - 1; bit >= 0; --bit) {
          const unsigned child = (x >> bit & 1u) | (y >> bit & 1u) << 1 | (z >> bit & 1u) << 2;
          if (tree.child_mask(n, tree.root_octant(), static_cast<std::uint8_t>(1u << child)) == 0)
            return false;
          n = tree.child(n, child);
        }
      }
  return true;
}

template <int M, int N> void nothing_is_dropped(int level) {
  const auto tree = voxelize_in_lanes(asterisk<M, N>{}, unit, level);
  REQUIRE(tree);
  judge::random_source random(5 * M + N);
  int points = 0, dropped = 0;
  for (int i = 0; i < 10000; ++i) {
    // a direction at large, near the axis, near the cut, or near where a sine is 0 or 1
    real theta = real(random.in(-1, 1)) * 4 * atan(real(1)),
         phi = real(random.in(0, 1)) * 4 * atan(real(1));
    const real tiny = real(std::ldexp(random.in(-1, 1), -static_cast<int>(random.below(60))));
    const unsigned kind = random.below(5);
    const real pi = 4 * atan(real(1));
    if (kind == 0)
      phi = random.below(2) == 0 ? real(abs(tiny)) : real(pi - abs(tiny));
    if (kind == 1)
      theta = pi + tiny;
    if (kind == 2)
      phi = pi * static_cast<int>(1 + random.below(2 * N - 1)) / (2 * N) + tiny;
    if (kind == 3)
      theta = pi * static_cast<int>(random.below(4 * M)) / (2 * M) + tiny;
    const real r = sin(real(M * theta)) * sin(real(N * phi));
    if (!(r > 0))
      continue;
    ++points;
    const real rho = r * sin(phi);
    dropped +=
        !all_kept(*tree, {real(rho * cos(theta)), real(rho * sin(theta)), real(r * cos(phi))});
  }
  CHECK(points > 2500);
  CHECK(dropped == 0);
  CHECK(all_kept(*tree, {real(0), real(0), real(0)}));
}

template <int M, int N> void lanes_agree() {
  const asterisk<M, N> f;
  const auto scalar = voxelize(f, unit, 6);
  REQUIRE(scalar);
  const auto traversal = surface_traversal<asterisk<M, N>>::make(f, unit, *scalar, 30);
  REQUIRE(traversal);
  for (const batch::path p : batch::paths) {
    if (batch::refusal(p))
      continue;
    INFO(batch::name(p));
    const auto lane_octree = voxelize_in_lanes(f, unit, 6, p);
    REQUIRE(lane_octree);
    const auto a = scalar->leaves(), b = lane_octree->leaves();
    CHECK(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    const auto by_lanes = lane_traversal<asterisk<M, N>>::make(f, unit, *lane_octree, 30, p);
    REQUIRE(by_lanes);
    int unequal = 0, hits = 0, undecided = 0;
    for (int j = 5; j < 512; j += 23)
      for (int i = 3; i < 512; i += 23) {
        const double u = (i + 0.5) / 512 - 0.5, v = 0.5 - (j + 0.5) / 512;
        const ray r =
            *ray::make({1.5, 1, 3}, {-3 + u * 3.578125 + v * -0.51171875, -2 + v * 3.8330078125,
                                     -6 + u * -1.7890625 + v * -1.0224609375});
        const surface_hit c = traversal->first_hit(r), d = by_lanes->first_hit(r);
        hits += c.outcome == verdict::hit;
        undecided += c.outcome == verdict::undecided;
        unequal += c.outcome != d.outcome || !(c.t_near == d.t_near) || !(c.t_far == d.t_far);
      }
    CHECK(unequal == 0);
    CHECK(hits > 40);
    CHECK(undecided <= 2);
  }
}

} // namespace

TEST_CASE("octree.asterisk: directions of the sines are MPFR's", "[unit][mpfr]") {
  const auto check = [](int n, const rational_bounds& cosine, const rational_bounds& sine) {
    const real angle = 2 * atan(real(1)) / n;
    CHECK(real(cosine.lo) < cos(angle));
    CHECK(cos(angle) < real(cosine.hi));
    CHECK(std::nextafter(cosine.lo, 2.0) == cosine.hi);
    CHECK(real(sine.lo) < sin(angle));
    CHECK(sin(angle) < real(sine.hi));
    CHECK(std::nextafter(sine.lo, 2.0) == sine.hi);
  };
  check(4, direction_of_sine<4>::cosine, direction_of_sine<4>::sine);
  check(18, direction_of_sine<18>::cosine, direction_of_sine<18>::sine);
}

TEST_CASE("octree.asterisk: enclosures and derivatives hold MPFR's values, at the axis too",
          "[property][mpfr]") {
  enclosures<3, 4>();
  enclosures<9, 18>();
}

TEST_CASE("octree.asterisk: no octant with a point of the surface is dropped", "[property][mpfr]") {
  nothing_is_dropped<3, 4>(5);
  nothing_is_dropped<3, 4>(9);
  nothing_is_dropped<9, 18>(9);
}

TEST_CASE("octree.asterisk: every path has the scalar octree and first hits", "[property]") {
  lanes_agree<3, 4>();
  lanes_agree<9, 18>();
}
