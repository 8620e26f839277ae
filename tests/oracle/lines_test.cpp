/// Grids of planes by each rule, segments and boxes: the fast answers are the rational ones.
#include "hard_rays.hpp"
#include <catch2/catch.hpp>
#include <cfenv>
#include <graze/oracle/arrival.hpp>
#include <graze/oracle/lines.hpp>
#include <graze/oracle/planes.hpp>
#include <graze/oracle/rational.hpp>

using namespace graze::oracle;
using graze::oracle::test::hard_scenes;

namespace {

mpq_class value(const plane_terms& p) {
  return mpq_class(p[0]) + mpq_class(p[1]) + mpq_class(p[2]);
}

struct axis {
  double origin, spacing;
};
std::vector<axis> hard_axes() {
  std::vector<axis> axes;
  for (const double o : {0.0, -0.3, -10.0, 1e6, 0x1p-1070, -0x1p60, 0x1.fffffffffffffp0, -1e-7})
    for (const double s : {0.1, 0.05, 1.0 / 3, 25.2165, 27.9808, 0.6051, 1e-7, 0x1p-4, 0x1p-1074,
                           0x1.0000000000001p-52, 0x1.8p-53, 0x1p-53, 3.0, 1e15, 1e-300})
      axes.push_back({o, s});
  return axes;
}

place place_of(const mpq_class& x, const std::vector<plane_terms>& planes) {
  int at = -1;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (x == value(planes[k]))
      return static_cast<place>(2 * k);
    if (x > value(planes[k]))
      at = static_cast<int>(2 * k + 1);
  }
  return static_cast<place>(at);
}

/// As in steps_test.cpp, and to t = 1 for a segment.
std::vector<step> steps_by_definition(const rational::line& l,
                                      const std::array<std::vector<plane_terms>, 3>& planes) {
  std::vector<mpq_class> times{0};
  if (l.last)
    times.push_back(1);
  for (unsigned a = 0; a < 3; ++a)
    if (l.velocity[a] != 0)
      for (const plane_terms& p : planes[a])
        if (const mpq_class t = (value(p) - l.origin[a]) / l.velocity[a];
            t > 0 && !(l.last && t > 1))
          times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<step> steps;
  const auto report = [&](const mpq_class& t, bool segment) {
    step found{{}, segment};
    for (unsigned a = 0; a < 3; ++a) {
      found.at[a] = place_of(l.origin[a] + t * l.velocity[a], planes[a]);
      if (found.at[a] < 0 || found.at[a] > static_cast<int>(2 * planes[a].size() - 2))
        return;
    }
    steps.push_back(found);
  };
  for (std::size_t i = 0; i < times.size(); ++i) {
    report(times[i], false);
    if (i + 1 < times.size())
      report((times[i] + times[i + 1]) / 2, true);
    else if (!l.last)
      report(times[i] + 1, true);
  }
  return steps;
}

/// A line among planes of any rule, on which rounding decides; some are segments, some axes flat.
struct hard_line {
  line l;
  std::array<std::vector<plane_terms>, 3> planes;
};
class hard_lines {
public:
  explicit hard_lines(std::uint64_t seed) : scenes_(seed) {}
  hard_line next() {
    while (true) {
      const auto s = scenes_.next();
      hard_line h{{s.origin, s.direction}, {}};
      bool far = false;
      for (unsigned a = 0; a < 3; ++a)
        for (const double p : s.planes[a])
          far = far || std::fabs(p) > 0x1p1000 || std::fabs(s.origin[a]) > 0x1p1000;
      const bool sums = !far && scenes_.below(2) == 0; // as real numbers, on a lattice about them
      const bool end = !far && scenes_.below(2) == 0;
      for (unsigned a = 0; a < 3; ++a) {
        const auto count = scenes_.below(8) == 0 ? 1 : s.planes[a].size();
        for (unsigned k = 0; k < count; ++k)
          h.planes[a].push_back(
              sums ? plane_exactly(s.planes[a][0], s.planes[a][1] - s.planes[a][0], k)
                   : plane_terms{s.planes[a][k], 0, 0});
      }
      if (sums && scenes_.below(2) == 0) { // along multiples of the spacings
        for (unsigned a = 0; a < 3; ++a) {
          const double spacing = s.planes[a][1] - s.planes[a][0];
          h.l.origin[a] = s.planes[a][0];
          h.l.direction[a] = spacing * static_cast<double>(1u << scenes_.below(3));
          if (scenes_.below(8) == 0)
            h.l.direction[a] = 0;
        }
      }
      if (end) {
        point to;
        for (unsigned a = 0; a < 3; ++a) {
          const double moved = h.l.origin[a] + h.l.direction[a];
          to[a] = scenes_.below(3) == 0 ? s.planes[a][scenes_.below(s.planes[a].size())]
                                        : (scenes_.below(8) == 0 ? h.l.origin[a] : moved);
          if (scenes_.below(8) == 0)
            to[a] = std::nextafter(to[a], h.l.origin[a]);
          if (!std::isfinite(to[a]) || std::fabs(to[a]) > 0x1p1000)
            to[a] = s.planes[a][0];
        }
        if (to == h.l.origin)
          continue;
        h.l.end = to;
      } else if (h.l.direction == point{}) {
        continue;
      }
      bool increasing = true;
      for (unsigned a = 0; a < 3; ++a)
        for (std::size_t k = 1; k < h.planes[a].size(); ++k)
          increasing = increasing && value(h.planes[a][k - 1]) < value(h.planes[a][k]);
      if (increasing)
        return h;
    }
  }

private:
  hard_scenes scenes_;
};

rational::line exactly(const line& l) {
  return l.end ? rational::segment_of(l.origin, *l.end) : rational::ray_of(l.origin, l.direction);
}

} // namespace

TEST_CASE("oracle.planes: each rule's planes are MPFR's", "[property][mpfr]") {
  for (const auto& [o, s] : hard_axes())
    for (const std::uint32_t k :
         {0u, 1u, 2u, 3u, 7u, 10u, 17u, 100u, 1000u, 4095u, 65537u, 1u << 20}) {
      CAPTURE(o, s, k);
      CHECK(value(plane_exactly(o, s, k)) == rational::plane_exactly(o, s, k));
      CHECK(plane_rounded(o, s, k) == rational::plane_rounded(o, s, k));
      CHECK(plane_multiplied(o, s, k) == rational::plane_multiplied(o, s, k));
      CHECK(plane_added(o, s, k) == rational::plane_added(o, s, k));
      CHECK(plane_binary32(o, s, k) == rational::plane_binary32(o, s, k));
    }
  // by hand: 0.1 is above 1/10, three of it above 0.3
  CHECK(plane_rounded(0, 0.1, 3) == 0.30000000000000004);
  CHECK(plane_multiplied(0, 0.1, 3) == 0.30000000000000004);
  CHECK(plane_added(0, 0.1, 3) == 0.30000000000000004);
  CHECK(plane_added(0, 0.1, 10) == 0.9999999999999999);
  CHECK(plane_rounded(0, 0.1, 10) == 1);
  CHECK(plane_multiplied(-0.3, 0.1, 3) == 0x1p-54);
  CHECK(plane_rounded(-0.3, 0.1, 3) == 0x1p-55); // 3 RN(0.1) - RN(0.3), exactly
  CHECK(plane_binary32(0, 0.1, 1) == 0.1f);
  CHECK(plane_binary32(0, 0.1, 3) == static_cast<double>(0.3f));
}

TEST_CASE("oracle.planes: added planes are those of step by step", "[property]") {
  for (const auto& [o, s] : hard_axes()) {
    double plane = o;
    for (std::uint32_t k = 0; k <= 3000; ++k, plane += s)
      if (plane_added(o, s, k) != plane) {
        CAPTURE(o, s, k);
        REQUIRE(plane_added(o, s, k) == plane);
      }
    CHECK(plane_added(o, s, 0) == o);
  }
}

TEST_CASE("oracle.planes: any rounding mode", "[unit]") {
  const double plane = plane_rounded(0, 0.1, 3), added = plane_added(0, 0.1, 10);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const bool same = plane_rounded(0, 0.1, 3) == plane && plane_added(0, 0.1, 10) == added;
    std::fesetround(FE_TONEAREST);
    CHECK(same);
  }
}

TEST_CASE("oracle.lines: steps are the definition's, for planes as sums and segments",
          "[property][hardcase]") {
  hard_lines random(16);
  std::vector<step> fast;
  unsigned segments = 0, ends_on_plane = 0, flat = 0, ties = 0;
  const auto by_gmp = decisions.gmp;
  for (int i = 0; i < 40'000; ++i) {
    const hard_line h = random.next();
    steps_in_grid(h.l, {h.planes[0], h.planes[1], h.planes[2]}, fast);
    const auto slow = steps_by_definition(exactly(h.l), h.planes);
    if (fast != slow) {
      CAPTURE(i, h.l.origin, h.l.direction, h.l.end.value_or(point{}), h.l.end.has_value(),
              h.planes[0], h.planes[1], h.planes[2]);
      REQUIRE(fast.size() == slow.size());
      REQUIRE(fast == slow);
    }
    segments += h.l.end && !slow.empty() ? 1 : 0;
    for (unsigned a = 0; a < 3; ++a) {
      flat += h.planes[a].size() == 1 && !slow.empty() ? 1 : 0;
      ends_on_plane += h.l.end && !slow.empty() && slow.back().at[a] % 2 == 0 ? 1 : 0;
    }
    for (const step& x : slow)
      ties += x.at[0] % 2 == 0 && x.at[1] % 2 == 0 ? 1 : 0;
  }
  CHECK(segments > 4000);
  CHECK(ends_on_plane > 1000);
  CHECK(flat > 1000);
  CHECK(ties > 5000);
  CHECK(decisions.gmp > by_gmp + 1000);
}

TEST_CASE("oracle.lines: what of a box is met is the rational answer, and who is entered first",
          "[property][hardcase]") {
  hard_lines random(17);
  unsigned touched = 0, crossed = 0, only_touched = 0, equal = 0;
  for (int i = 0; i < 40'000; ++i) {
    const hard_line h = random.next();
    const auto l = exactly(h.l);
    std::vector<meeting> met;
    std::vector<mpq_class> entries;
    for (unsigned v = 0; v < 8; ++v) {
      planes_box b{};
      rational::box r;
      for (unsigned a = 0; a < 3; ++a) {
        const auto last = h.planes[a].size() - 1;
        b.lo[a] = h.planes[a][std::min<std::size_t>(v >> a & 1, last)];
        b.hi[a] = h.planes[a][std::min<std::size_t>((v >> a & 1) + (v != 3 ? 1 : 0), last)];
        r.lo[a] = value(b.lo[a]);
        r.hi[a] = value(b.hi[a]);
      }
      const meeting m(h.l, b);
      const bool touches = rational::touches(l, r), crosses = rational::crosses(l, r);
      if (m.touches() != touches || m.crosses() != crosses) {
        CAPTURE(i, v, h.l.origin, h.l.direction, h.l.end.value_or(point{}), h.l.end.has_value(),
                b.lo, b.hi);
        REQUIRE(m.touches() == touches);
        REQUIRE(m.crosses() == crosses);
      }
      touched += touches ? 1 : 0;
      crossed += crosses ? 1 : 0;
      only_touched += touches && !crosses ? 1 : 0;
      if (!touches)
        continue;
      const auto range = rational::range_in(l, r);
      if (!range)
        continue; // without end
      met.push_back(m);
      entries.push_back(range->first);
    }
    for (std::size_t x = 0; x < met.size(); ++x)
      for (std::size_t y = 0; y < met.size(); ++y) {
        const int sign = (entries[x] > entries[y] ? 1 : 0) - (entries[x] < entries[y] ? 1 : 0);
        if (compare_entries(met[x], met[y]) != sign) {
          CAPTURE(i, h.l.origin, h.l.direction);
          REQUIRE(compare_entries(met[x], met[y]) == sign);
        }
        equal += x != y && sign == 0 ? 1 : 0;
      }
  }
  CHECK(touched > 20'000);
  CHECK(crossed > 10'000);
  CHECK(only_touched > 10'000);
  CHECK(equal > 10'000);
}

TEST_CASE(
    "oracle.lines: a point beside a plane that is no double is on its side of it, and a plane is "
    "itself",
    "[property][hardcase]") {
  const auto side = [](const plane_terms& p, double x) {
    const mpq_class d = value(p) - mpq_class(x);
    return static_cast<place>(sgn(d) < 0 ? 1 : (sgn(d) == 0 ? 0 : -1));
  };
  unsigned tested = 0;
  for (const auto& [o, s] : hard_axes())
    for (std::uint32_t k = 0; k < 3000; k += 1 + k / 40) {
      const plane_terms p = plane_exactly(o, s, k);
      const double nearest = plane_rounded(o, s, k);
      for (const double x :
           {nearest, std::nextafter(nearest, HUGE_VAL), std::nextafter(nearest, -HUGE_VAL)}) {
        // on the first axis the line stays at x; on the others it is in the hull
        const line l{{x, 0, 0}, {0, 1, 0}};
        const std::array<plane_terms, 1> flat{p};
        const std::array<plane_terms, 1> zero{plane_terms{}};
        std::vector<step> steps;
        steps_in_grid(l, {flat, zero, zero}, steps);
        const bool on = side(p, x) == 0;
        if (on == steps.empty()) {
          CAPTURE(o, s, k, x);
          REQUIRE(on != steps.empty());
        }
        const std::array<plane_terms, 2> above{p, plane_exactly(1e300, 0, 0)};
        steps_in_grid(l, {above, zero, zero}, steps);
        if (steps.empty() != (side(p, x) < 0)) {
          CAPTURE(o, s, k, x);
          REQUIRE(steps.empty() == (side(p, x) < 0));
        }
        ++tested;
      }
      // a flat box of this plane is flat
      planes_box b{};
      b.lo[0] = b.hi[0] = p;
      b.hi[1][0] = b.hi[2][0] = 1;
      const meeting m({{o - 1, 0.5, 0.5}, {1, 0, 0}}, b);
      if (m.touches() != m.crosses()) {
        CAPTURE(o, s, k);
        REQUIRE(m.touches() == m.crosses());
      }
    }
  CHECK(tested > 10'000);
}

TEST_CASE("oracle.lines: flat boxes and segments' ends, by hand", "[unit]") {
  const auto met = [](const line& l, const point& lo, const point& hi) {
    const meeting m(l, box_of(lo, hi));
    return std::pair(m.touches(), m.crosses());
  };
  const std::pair none{false, false}, only_touched{true, false}, crossed{true, true};
  // a sheet at z = 0
  CHECK(met({{0.5, 0.5, 1}, {0, 0, -1}}, {0, 0, 0}, {1, 1, 0}) == crossed);
  CHECK(met({{0.5, 0.5, 1}, {0, 0, 1}}, {0, 0, 0}, {1, 1, 0}) == none);
  CHECK(met({{1, 0.5, 1}, {0, 0, -1}}, {0, 0, 0}, {1, 1, 0}) == only_touched);
  CHECK(met({{-1, 0.5, 0}, {1, 0, 0}}, {0, 0, 0}, {1, 1, 0}) == crossed);
  CHECK(met({{-1, 0, 0}, {1, 0, 0}}, {0, 0, 0}, {1, 1, 0}) == only_touched);
  // a point
  CHECK(met({{-1, 0, 0}, {1, 0, 0}}, {0, 0, 0}, {0, 0, 0}) == crossed);
  CHECK(met({{1, 0, 0}, {1, 0, 0}}, {0, 0, 0}, {0, 0, 0}) == none);
  // segments: both ends belong to them
  CHECK(met({{-1, 0.5, 0.5}, {}, point{0, 0.5, 0.5}}, {0, 0, 0}, {1, 1, 1}) == only_touched);
  CHECK(met({{-1, 0.5, 0.5}, {}, point{0x1p-1074, 0.5, 0.5}}, {0, 0, 0}, {1, 1, 1}) == crossed);
  CHECK(met({{-1, 0.5, 0.5}, {}, point{-0x1p-1074, 0.5, 0.5}}, {0, 0, 0}, {1, 1, 1}) == none);
  CHECK(met({{0.5, 0.5, 1}, {}, point{0.5, 0.5, 0}}, {0, 0, 0}, {1, 1, 0}) == crossed);
  CHECK(met({{0.5, 0.5, 0}, {}, point{0.5, 0.5, 1}}, {0, 0, 0}, {1, 1, 0}) == crossed);
  // within the box
  CHECK(met({{0.5, 0.5, 0.5}, {}, point{0.5, 0.5, 0.75}}, {0, 0, 0}, {1, 1, 1}) == crossed);
}
