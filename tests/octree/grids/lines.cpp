// Lines and cells between planes of any kind, judged in rational numbers: touches, crosses, owns,
// and passages.
#include "../../support/test_inputs.hpp"
#include "hard_grids.hpp"
#include <catch2/catch.hpp>
#include <cfenv>
#include <graze/rounding/hardware.hpp>

using namespace graze;
using namespace graze::grid_tests;
namespace rational = graze::oracle::rational;

namespace {

rational::box cell_of(const hard_grid& g, const std::array<std::uint32_t, 3>& index) {
  rational::box c;
  for (unsigned a = 0; a < 3; ++a) {
    c.lo[a] = g.plane(a, index[a]);
    c.hi[a] = g.plane(a, g.planes.flat(static_cast<int>(a)) ? 0 : index[a] + 1);
  }
  return c;
}

/// Bits of the axes on which it is flat.
unsigned flat_axes(const rational::box& c) {
  unsigned flat = 0;
  for (unsigned a = 0; a < 3; ++a)
    flat |= c.lo[a] == c.hi[a] ? 1u << a : 0;
  return flat;
}

struct tally {
  std::uint64_t asked = 0, touched = 0, crossed = 0, owned = 0, corners = 0, wide = 0;
};

/// All that is said of a line and a cell; `far`: upper planes that the half-open cell includes.
void compare(const exact_line& line, const rational::line& exact, const slabs& cell,
             const rational::box& c, unsigned far, tally& n) {
  const unsigned flat = flat_axes(c);
  ++n.asked;
  const bool touched = rational::meets(exact, c, 7, 7);
  REQUIRE(line.touches(cell) == touched);
  const bool crossed = rational::meets(exact, c, flat, flat);
  REQUIRE(line.crosses(cell) == crossed);
  const bool owned = rational::meets(exact, c, 7, far | flat);
  REQUIRE(line.owns(cell) == owned);
  n.touched += touched;
  n.crossed += crossed;
  n.owned += owned;

  const auto is = rational::common_part(exact, c);
  const auto p = line.through(cell);
  REQUIRE(is.has_value() == p.has_value());
  if (!p)
    return;
  REQUIRE(p->entered == is->entered);
  REQUIRE(p->left == is->left);
  n.corners += std::popcount(p->entered) > 1 || std::popcount(p->left) > 1;
  mpq_class square = 0;
  for (const mpq_class& d : exact.velocity)
    square += d * d;
  const mpq_class duration = is->last - is->first;
  const auto within = [&](const bounds& b, const mpq_class& x, bool squared) {
    const auto power = [&](double y) {
      return squared ? mpq_class(mpq_class(y) * mpq_class(y)) : mpq_class(y);
    };
    REQUIRE(power(b.lo) <= x);
    if (b.hi < INFINITY)
      REQUIRE(x <= power(b.hi));
    // tight: a point, or two ulps at the most
    if (b.hi < INFINITY)
      n.wide += steps_away(b.lo, 1) < b.hi;
    REQUIRE(b.hi <= steps_away(b.lo, 2));
  };
  within(p->enter, is->first, false);
  within(p->leave, is->last, false);
  within(p->length, duration * duration * square, true);
}

} // namespace

TEST_CASE("octree.exact_line: touches, crosses, owns and passages are those of rational numbers",
          "[mpfr][property]") {
  tally n;
  const auto grids = static_cast<std::uint64_t>(test::input_count() / 100);
  for (std::uint64_t i = 0; i < grids; ++i) {
    random_stream r(1601, i);
    const hard_grid g = make_grid(r, 70);
    const place at = make_place(r, g.planes);
    for (int k = 0; k < 4; ++k) {
      const hard_line l = make_line(r, g, at);
      const exact_line line = l.prepared();
      const rational::line exact = l.rational();
      INFO("grid " << i << " (" << name_of(g.planes.rule()) << "), line " << k);
      for (std::uint32_t x = 0; x < at.extent[0]; ++x)
        for (std::uint32_t y = 0; y < at.extent[1]; ++y)
          for (std::uint32_t z = 0; z < at.extent[2]; ++z) {
            if (at.extent[0] * at.extent[1] * at.extent[2] > 8 && r.coin())
              continue;
            const std::array<std::uint32_t, 3> index{at.base[0] + x, at.base[1] + y,
                                                     at.base[2] + z};
            unsigned far = 0;
            for (unsigned a = 0; a < 3; ++a)
              far |= index[a] + 1 == g.planes.count(static_cast<int>(a)) ? 1u << a : 0;
            compare(line, exact, g.planes.voxel(index), cell_of(g, index), far, n);
          }
    }
  }
  CHECK(n.touched > n.asked / 20);
  CHECK(n.touched > n.owned);
  CHECK(n.owned > n.crossed);
  CHECK(n.corners > n.touched / 20);
}

TEST_CASE("octree.exact_line: boxes of any doubles, flat ones included", "[mpfr][property]") {
  tally n;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    random_stream r(1602, i);
    const hard_grid g = make_grid(r, 5);
    const place at = make_place(r, g.planes);
    box b{};
    rational::box c;
    for (unsigned a = 0; a < 3; ++a) {
      const int axis = static_cast<int>(a);
      const std::uint32_t k = at.base[a];
      b.lo[a] = g.planes.lower(axis, k);
      b.hi[a] = r.one_in(3) ? b.lo[a] : g.planes.upper(axis, k + at.extent[a]);
      c.lo[a] = mpq_class(b.lo[a]);
      c.hi[a] = mpq_class(b.hi[a]);
    }
    const hard_line l = make_line(r, g, at);
    INFO("box " << i);
    compare(l.prepared(), l.rational(), slabs(b), c, 0, n);
    compare(l.prepared(), l.rational(), slabs(b, 5), c, 5, n);
  }
  CHECK(n.touched > 5'000);
  CHECK(n.crossed > 1'000);

  const ray r = *ray::make({0, 0, 0}, {1, 1, 1});
  CHECK_FALSE(touches(r, box{{1, 1, 1}, {0, 2, 2}}));
  CHECK_FALSE(crosses(r, box{{1, 1, 1}, {0, 2, 2}}));
  CHECK_FALSE(passage_through(r, box{{1, 1, 1}, {0, 2, 2}}));
  CHECK(crosses(r, box{{1, 1, 1}, {1, 1, 1}})); // a point
  CHECK(touches(*segment::make({0, 0, 0}, {1, 1, 1}), box{{1, 1, 1}, {2, 2, 2}}));
  CHECK_FALSE(
      touches(*segment::make({0, 0, 0}, {1, 1, 0x1.fffffffffffffp-1}), box{{1, 1, 1}, {2, 2, 2}}));
}

TEST_CASE("octree.exact_line: comparisons of arrivals that differ by ulps, in every mode",
          "[mpfr][hardcase]") {
  // a box of which the ray leaves one axis about when it enters another: full significands, so that
  // all operations round
  std::uint64_t touched = 0, all = 0;
  using rounding::hardware::mode;
  for (const mode m : {mode::nearest, mode::down, mode::up})
    for (std::uint64_t i = 0; i < 60'000; ++i) {
      random_stream r(1603, i);
      vec3 o, d;
      for (unsigned a = 0; a < 3; ++a) {
        o[a] = r.sign() * near_one(r);
        d[a] = near_one(r) * (a == 2 ? 0x1p-20 : 1);
      }
      const double x = o[0] + near_one(r), t = (x - o[0]) / d[0];
      const double y = steps_away(o[1] + t * d[1], r.between(-2, 2));
      box b{{-4, y, -4}, {x, 8, 4}};
      rational::box c;
      for (unsigned a = 0; a < 3; ++a) {
        c.lo[a] = mpq_class(b.lo[a]);
        c.hi[a] = mpq_class(b.hi[a]);
      }
      const bool is = rational::touches(rational::ray_of(o, d), c);
      const bool as_segment = rational::touches(rational::segment_of(o, d), c);
      const ray line = *ray::make(o, d);
      const segment between = *segment::make(o, d);
      bool found = false, found_between = false;
      {
        const rounding::hardware::mode_scope scope(m);
        found = touches(line, b);
        found_between = touches(between, b);
      }
      REQUIRE(found == is);
      REQUIRE(found_between == as_segment);
      touched += is;
      ++all;
    }
  CHECK(touched > all / 5);
  CHECK(touched < all - all / 5);
}

TEST_CASE("octree.exact_line: distances, planes and differences beyond the doubles, in every mode",
          "[regression]") {
  // The ray is at x = 1.5e308 at t = 3.75, and at y = t.
  const ray forward = *ray::make({-1.5e308, 0, 0}, {8e307, 1, 0}),
            backward = *ray::make({1.5e308, 0, 0}, {-8e307, 1, 0});
  const segment between = *segment::make({-1.5e308, 0, 0}, {1.7e308, 4, 0});
  const slabs right(box{{1.5e308, 3, 0}, {1.6e308, 4, 0}}),
      left(box{{-1.6e308, 3, 0}, {-1.5e308, 4, 0}});
  slabs of_multiples = right; // 1.3e308 and 1.4e308, as the sums of -1.7e308 and more than 2^1024
  of_multiples.lower[0] = {-1.7e308, 1e303, 300'000};
  of_multiples.upper[0] = {-1.7e308, 1e303, 310'000};
  const int found = std::fegetround();
  for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const bool ahead = touches(forward, right), behind = touches(backward, left),
               multiples = touches(forward, of_multiples), ends = touches(between, right);
    const auto p = passage_through(forward, right);
    std::fesetround(found);
    CHECK(ahead);
    CHECK(behind);
    CHECK(multiples);
    CHECK(ends);
    REQUIRE(p);
    CHECK((p->enter.lo > 3.74 && p->enter.hi < 3.76 && p->entered == face_bit(0, false)));
  }
}

#if defined(__x86_64__)
TEST_CASE("octree.ray_segment: ends are those given where numbers are flushed", "[regression]") {
  namespace hardware = rounding::hardware;
  const volatile double tiny = 0x1p-1074; // read where it is flushed
  const unsigned found = hardware::mxcsr();
  hardware::set_mxcsr(0x9fc0); // FTZ and DAZ
  const auto from = ray_segment::make(tiny, INFINITY), to = ray_segment::make(0, tiny),
             wrong = ray_segment::make(tiny, 0), negative = ray_segment::make(-tiny, 1);
  const bool whole = !from || from->whole();
  hardware::set_mxcsr(found);
  REQUIRE(from);
  CHECK(from->first() == 0x1p-1074);
  CHECK_FALSE(whole);
  REQUIRE(to);
  CHECK(to->last() == 0x1p-1074);
  CHECK_FALSE(wrong);
  CHECK_FALSE(negative);
}
#endif

TEST_CASE("octree.segment: refuses ends that are not finite, and a point", "[unit]") {
  CHECK_FALSE(segment::make({0, 0, NAN}, {1, 1, 1}));
  CHECK_FALSE(segment::make({0, 0, 0}, {1, INFINITY, 1}));
  CHECK_FALSE(segment::make({1, 0, 0}, {1, -0.0, 0}));
  CHECK(segment::make({0, 0, 0}, {0, 0, 0x1p-1074}));
}
