// The hex-float cases on which the paper as printed, or arithmetic without care, misses an octant.
#include <catch2/catch.hpp>
#include <graze/octree/sound.hpp>
#include <graze/oracle/geometry.hpp>
#include <graze/rounding/upward.hpp>
#include <peers/paper2005/published.hpp>
#include <xmmintrin.h>

using namespace graze;
using namespace graze::octree;
using namespace graze::peers;

namespace {

struct scenario {
  const char* why;
  vec3 origin, direction;
  cube octant;
  bool crossed;
};

template <class M> bool passes(const scenario& s) {
  [[maybe_unused]] const typename M::scope scope;
  const M method(*ray::make(s.origin, s.direction));
  typename M::state state;
  return method.enter(s.octant, state);
}

using closed = sound<rounding::upward, convention::closed>;

const scenario scenarios[] = {
    {"c rounded once, level 50",
     {0x1.89629603723cep-1, 0x1.abdcf56180d59p-1, 0x1.09418883283d0p-2},
     {-0x1.2e3acaacf4b96p-1, -0x1.dc33242b6d7f4p-1, 0x1.0294e0746797cp-1},
     {{0x1.1fd52bb47c850p-2, 0x1.165b57bbd0b40p-4, 0x1.5a1181eb0c588p-1}, 0x1p-50},
     true},
    {"one rounding of x - x0, far origin, level 50",
     {0x1.219e25965bd4bp+6, 0x1.2646348ee73a8p+7, 0x1.845529139a566p+7},
     {-0x1.1fc9772cc229bp+6, -0x1.245e8171f0c96p+7, -0x1.828775b980938p+7},
     {{0x1.45832d9621b90p-2, 0x1.56404feb08460p-1, 0x1.0d68c43413600p-1}, 0x1p-50},
     true},
    {"a zero component", {0.0625, 0, 0}, {0, 1, 1}, {{0, 0, 0}, 1}, true},
    {"underflow of c", {0.25, 0.25, 0.25}, {0x1p-540, 0x1p-540, 0x1p-540}, {{0, 0, 0}, 1}, true},
    {"overflow of c, 0 * inf", {0, 0.25, 0.25}, {0x1p600, 0x1p600, 0x1p600}, {{0, 0, 0}, 1}, true},
};

} // namespace

TEST_CASE("octree.published: misses each of the octants known, the sound form none",
          "[regression]") {
  for (const scenario& s : scenarios) {
    INFO(s.why);
    const vec3 hi{s.octant.hi(0), s.octant.hi(1), s.octant.hi(2)};
    CHECK(oracle::touches(s.origin, s.direction, s.octant.lo, hi));
    CHECK(oracle::crosses(s.origin, s.direction, s.octant.lo, hi) == s.crossed);
    CHECK_FALSE(passes<published>(s));
    CHECK(passes<closed>(s));
  }
}

TEST_CASE("octree.ray_bounds: flushing to zero would miss the unit cube, the scope forbids it",
          "[regression]") {
  const scenario s{
      "FTZ", {-0x1p100, -0x1p-441, -0x1p-441}, {1, 0x1p-540, 0x1p-540}, {{0, 0, 0}, 1}, true};
  CHECK(oracle::touches(s.origin, s.direction, {0, 0, 0}, {1, 1, 1}));
  CHECK(passes<closed>(s));
  const unsigned saved = _mm_getcsr();
  _mm_setcsr(saved | 0x8040u); // FTZ and DAZ, as a program compiled with -ffast-math sets them
  const bool found = passes<closed>(s);
  _mm_setcsr(saved);
  CHECK(found);
}
