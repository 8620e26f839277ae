/// The cases of the numerics notes whose verdict is a fact of geometry, whatever computes it.
#include <catch2/catch.hpp>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <graze/oracle/rational.hpp>
#include <xmmintrin.h>

using namespace graze::oracle;

namespace {

struct octant {
  point lo, hi;
  octant(const point& lo_, double size)
      : lo(lo_), hi{lo_[0] + size, lo_[1] + size, lo_[2] + size} {}
};
const octant unit_cube({0, 0, 0}, 1);

void check(const point& o, const point& d, const octant& box, bool touched, bool crossed) {
  CHECK(touches(o, d, box.lo, box.hi) == touched);
  CHECK(crosses(o, d, box.lo, box.hi) == crossed);
  CHECK(rational::touches(o, d, box.lo, box.hi) == touched);
  CHECK(rational::crosses(o, d, box.lo, box.hi) == crossed);
}

} // namespace

TEST_CASE("oracle.known: the octant that one rounding of c misses at level 50 is touched",
          "[regression]") {
  const point o{0x1.89629603723cep-1, 0x1.abdcf56180d59p-1, 0x1.09418883283d0p-2};
  const point d{-0x1.2e3acaacf4b96p-1, -0x1.dc33242b6d7f4p-1, 0x1.0294e0746797cp-1};
  const octant box({0x1.1fd52bb47c850p-2, 0x1.165b57bbd0b40p-4, 0x1.5a1181eb0c588p-1}, 0x1p-50);
  check(o, d, box, true, true);
  check(o, {-d[0], -d[1], -d[2]}, box, false, false);
}

TEST_CASE("oracle.known: the octant that one rounding of x - x0 misses from afar is crossed",
          "[regression]") {
  const point o{0x1.219e25965bd4bp+6, 0x1.2646348ee73a8p+7, 0x1.845529139a566p+7};
  const point d{-0x1.1fc9772cc229bp+6, -0x1.245e8171f0c96p+7, -0x1.828775b980938p+7};
  const octant box({0x1.45832d9621b90p-2, 0x1.56404feb08460p-1, 0x1.0d68c43413600p-1}, 0x1p-50);
  check(o, d, box, true, true);
}

TEST_CASE("oracle.known: a ray with a zero component crosses the root", "[regression]") {
  check({.0625, 0, 0}, {0, 1, 1}, unit_cube, true, true);
}

TEST_CASE("oracle.known: a direction of 2^-540, whose products underflow, crosses the root",
          "[regression]") {
  check({.25, .25, .25}, {0x1p-540, 0x1p-540, 0x1p-540}, unit_cube, true, true);
}

TEST_CASE("oracle.known: a direction of 2^600, whose products overflow, crosses the root",
          "[regression]") {
  check({0, .25, .25}, {0x1p600, 0x1p600, 0x1p600}, unit_cube, true, true);
}

TEST_CASE("oracle.known: the ray that flushing to zero makes miss crosses the root, flushed or not",
          "[regression]") {
  const point o{-0x1p100, -0x1p-441, -0x1p-441}, d{1, 0x1p-540, 0x1p-540};
  check(o, d, unit_cube, true, true);
  const unsigned found = _mm_getcsr();
  _mm_setcsr(found | 0x8040);
  const bool touched = touches(o, d, unit_cube.lo, unit_cube.hi);
  const bool crossed = crosses(o, d, unit_cube.lo, unit_cube.hi);
  _mm_setcsr(found);
  CHECK(touched);
  CHECK(crossed);
}

TEST_CASE("oracle.known: a ray in a mid-plane touches four children and is owned by two, in order",
          "[regression]") {
  const point o{.25, 0, .5}, d{0, 1, 0};
  const auto child = [](unsigned i) {
    return octant({(i & 1) != 0 ? .5 : 0, (i & 2) != 0 ? .5 : 0, (i & 4) != 0 ? .5 : 0}, .5);
  };
  for (unsigned i = 0; i < 8; ++i) {
    CAPTURE(i);
    const octant box = child(i);
    check(o, d, box, i % 2 == 0, false);
    CHECK(owns(o, d, box.lo, box.hi, i) == (i == 4 || i == 6));
    CHECK(rational::owns(o, d, box.lo, box.hi, i) == (i == 4 || i == 6));
  }
  const std::vector<double> planes{0, .5, 1};
  CHECK(steps_in_grid(o, d, {planes, planes, planes}) == std::vector<step>{{{1, 0, 2}, false},
                                                                           {{1, 1, 2}, true},
                                                                           {{1, 2, 2}, false},
                                                                           {{1, 3, 2}, true},
                                                                           {{1, 4, 2}, false}});
}

TEST_CASE("oracle.operands: beyond the last double is infinity, not a NaN", "[regression]") {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(hard_operands::step(largest, 1) == infinity);
  CHECK(hard_operands::step(-largest, 99) == -infinity);
  CHECK(hard_operands::step(infinity, 3) == infinity);
  CHECK(hard_operands::step(infinity, -1) == largest);
}

TEST_CASE("oracle.operands: every interval is one", "[regression]") {
  // log([nan, 0x1.fffffffffffffp+1023]) was asked once in 16.5 million trials: the ends of a range
  // that is near the last double find it at once
  unsigned long wrong = 0;
  const auto look = [&wrong](const graze::bounds& x) {
    const bool empty = x.lo != x.lo && x.hi != x.hi;
    wrong += !empty && graze::checking::is_empty(x.lo, x.hi) ? 1 : 0;
  };
  constexpr double largest = std::numeric_limits<double>::max();
  for (const active_range active : {active_range{0, 10}, active_range{-largest, largest}}) {
    hard_arguments make(12);
    for (int i = 0; i < 300000; ++i)
      look(make.interval(active));
  }
  hard_intervals made(13);
  for (int i = 0; i < 300000; ++i) {
    graze::bounds x, y, z;
    made.next(x, y, z);
    look(x), look(y), look(z);
  }
  hard_boxes boxes(14);
  for (int i = 0; i < 300000; ++i)
    look(boxes.next());
  CHECK(wrong == 0);
}
