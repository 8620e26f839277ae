// Surfaces that are not defined, or not continuous, everywhere: nothing is lost, and nothing that
// is no zero is certified.
#include "../../support/formulas.hpp"
#include "../surface_judge.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_formula/lane_kernels.hpp>

using namespace graze;
using namespace graze::octree;
using up = rounding::upward;
using support::parsed;

namespace {

const box unit{{-1, -1, -1}, {1, 1, 1}};

struct leaf_counts {
  std::size_t all = 0, certified = 0;
};
leaf_counts leaves_of(const formula& f, int level, const box& domain = unit) {
  const auto tree = voxelize(f.surface(), domain, level);
  REQUIRE(tree);
  leaf_counts r{tree->leaf_count(), 0};
  for (const content c : tree->leaves())
    r.certified += c == content::certified;
  const auto by_lanes = voxelize_in_lanes(f.surface(), domain, level);
  REQUIRE(by_lanes);
  CHECK(by_lanes->leaf_count() == r.all);
  return r;
}

surface_hit hit(const formula& f, const vec3& origin, const vec3& direction) {
  const auto tree = voxelize(f.surface(), unit, 5);
  REQUIRE(tree);
  const auto t = surface_traversal<formula_surface>::make(f.surface(), unit, *tree, 30);
  REQUIRE(t);
  return t->first_hit(*ray::make(origin, direction));
}

content content_of(const formula& f, const box& b) {
  const up::scope scope;
  if (has_no_zero<up>(f.surface(), b))
    return content::none;
  return leaf_content<up>(f.surface(), b);
}

} // namespace

TEST_CASE("octree.formula: where nothing is defined nothing is kept", "[unit]") {
  CHECK(leaves_of(parsed("sqrt(x-2)"), 4).all == 0);
  CHECK(leaves_of(parsed("log(-1-x^2)+y"), 4).all == 0);
  CHECK(leaves_of(parsed("min(y, sqrt(x-2))"), 4).all == 0);
  CHECK(leaves_of(parsed("y+0*sqrt(x-2)"), 4).all == 0);
  CHECK(leaves_of(parsed("sqrt(x-2)-sqrt(x-2)+y"), 4).all == 0);
  // defined in the half x >= 1/4, with its face
  const formula half = parsed("y+0*sqrt(x-1/4)");
  CHECK(content_of(half, {{0, -.5, 0}, {.125, .5, .25}}) == content::none);
  CHECK(content_of(half, {{0, -.5, 0}, {.25, .5, .25}}) == content::possible);
  CHECK(content_of(half, {{.25, -.5, 0}, {.5, .5, .25}}) == content::certified);
}

TEST_CASE("octree.formula: a pole, a jump or a gap is not certified as a zero", "[unit]") {
  const box across{{-.25, -.25, -.25}, {.5, .5, .5}};
  for (const char* text : {"1/x",
                           "x/x-1/2",
                           "1/x+y",
                           "1/x^3",
                           "x^-1",
                           "tan(2x+pi/2)",
                           "cot(x)",
                           "csc(x)",
                           "coth(x)",
                           "csch(x)",
                           "sign(x)+1/2",
                           "floor(x)+1/2",
                           "x/sqrt(x^2)",
                           "x/abs(x)",
                           "atan2(x,y-1)-x*y",
                           "atan2(x, -1)",
                           "log(x^2)/x",
                           "y/x",
                           "sqrt(x+y)-z",
                           "x^1.5-y",
                           "x/x*y",
                           "y+0/x",
                           "sqrt(x)*0+y",
                           "ceil(x)-1/2",
                           "trunc(4x)-1/2",
                           "rootn(x,-3)",
                           "x^y-1",
                           "if(x<0,-1,1)",
                           "if(x>=0,y+1,y-1)",
                           "mod(x,1/8)-1/16",
                           "x%(1/4)-1/8",
                           "if(x<y,z-1,z+1)",
                           "if(x==0,z,1)",
                           "if(x!=0,1/x,1)",
                           "if(x<0,1,-1)*y"}) {
    INFO(text);
    CHECK(content_of(parsed(text), across) != content::certified);
    CHECK(leaves_of(parsed(text), 3).all < 512 + 1);
  }
  CHECK(leaves_of(parsed("1/x"), 4).all <= 2 * 16 * 16);
  CHECK(leaves_of(parsed("1/x"), 4).certified == 0);
  CHECK(leaves_of(parsed("sign(x)+1/2"), 4).all <= 2 * 16 * 16);
  // beside the gap they are
  const box beside{{.25, -.25, -.25}, {.5, .5, .5}};
  for (const char* text :
       {"1/x+4*y-3", "y/x", "sqrt(x)-2*abs(y)-y", "x^1.5-y", "log(x)+1+y", "x^y-1",
        "if(x>0,y,sqrt(x-1))", "if(x>=1/4,y,1/z)", "mod(x,1)-y-1/4", "if(x<0,sqrt(x-1),y)"}) {
    INFO(text);
    CHECK(content_of(parsed(text), beside) == content::certified);
  }
}

TEST_CASE("octree.formula: rays find the zeros of partial surfaces, and no others", "[unit]") {
  const auto toward = [](const char* text) { return hit(parsed(text), {-3, .3, .2}, {1, 0, 0}); };
  // a plane at x = 1/4, so at t = 3.25
  for (const char* text :
       {"x-1/4", "(x-1/4)/(x+2)", "1/(x-1/3)+12", "log(x+3/4)", "4-1/x", "sqrt(x+3/4)-1",
        "atan2(x-1/4,y)", "x^1.5-1/8", "(x-1/4)/(y*z)", "if(x<3/4,x-1/4,1/x)"}) {
    INFO(text);
    const surface_hit h = toward(text);
    CHECK(h.outcome == verdict::hit);
    CHECK(h.t_near <= 3.25);
    CHECK(3.25 <= h.t_far);
    CHECK(h.t_far - h.t_near < 1e-6);
  }
  for (const char* text :
       {"1/(x-1/4)", "sign(x-1/4)+y/8", "(x-1/4)/abs(x-1/4)", "atan2(y*0+x-1/4,-1)+1/8",
        "floor(x+3/4)+1/3", "if(x<1/4,-1,1)", "if(x<=1/4,-1,y+1)"}) {
    INFO(text);
    CHECK(toward(text).outcome != verdict::hit);
  }
  // the first root is behind a pole with a change of sign
  const surface_hit behind = toward("1/(x+1/2)-4/3"); // x = 1/4
  CHECK(behind.outcome == verdict::hit);
  CHECK(behind.t_near <= 3.25);
  CHECK(3.25 <= behind.t_far);
}

TEST_CASE("octree.formula: certified hits of partial surfaces are zeros", "[unit]") {
  const auto toward = [](const char* text) {
    const formula f = parsed(text);
    const auto t = certified_traversal<formula_surface>::make(f.surface(), unit);
    REQUIRE(t);
    return t->first_hit(*ray::make({-3, .3, .2}, {1, 0, 0}));
  };
  for (const char* text : {"x-1/4", "(x-1/4)/(x+2)", "1/(x-1/3)+12", "log(x+3/4)", "4-1/x",
                           "sqrt(x+3/4)-1", "atan2(x-1/4,y)", "x^1.5-1/8", "1/(x+1/2)-4/3",
                           "if(x<3/4,x-1/4,1/x)", "if(x>0,sqrt(x)-1/2,1)"}) {
    INFO(text);
    const certified_hit h = toward(text);
    CHECK(h.outcome == verdict::hit);
    CHECK(h.t_near <= 3.25);
    CHECK(3.25 <= h.t_far);
  }
  for (const char* text :
       {"1/(x-1/4)", "sign(x-1/4)+y/8", "(x-1/4)/abs(x-1/4)", "atan2(y*0+x-1/4,-1)+1/8",
        "floor(x+3/4)+1/3", "sqrt(x-2)", "if(x<1/4,-1,1)", "if(x<=1/4,-1,y+1)"}) {
    INFO(text);
    CHECK(toward(text).outcome != verdict::hit);
  }
}

TEST_CASE("octree.formula: at an edge of its domain a surface is not lost", "[hardcase]") {
  // zeros that lie in the domain's boundary: sqrt(x) = 0 on x = 0
  const auto holds_plane = [](const char* text) {
    const auto tree = voxelize(parsed(text).surface(), unit, 4);
    REQUIRE(tree);
    // all octants that touch x = 0 from above hold points of the surface
    std::size_t kept = 0;
    for (unsigned y = 0; y < 16; ++y)
      for (unsigned z = 0; z < 16; ++z) {
        auto n = tree->root();
        bool there = true;
        for (int bit = 3; bit >= 0 && there; --bit) {
          const unsigned child = (8u >> bit & 1u) | (y >> bit & 1u) << 1 | (z >> bit & 1u) << 2;
          there =
              tree->child_mask(n, tree->root_octant(), static_cast<std::uint8_t>(1u << child)) != 0;
          if (there)
            n = tree->child(n, child);
        }
        kept += there;
      }
    return kept == 256;
  };
  CHECK(holds_plane("sqrt(x)"));
  CHECK(holds_plane("x^1.5"));
  CHECK(holds_plane("x*log(x+1)"));
  CHECK(holds_plane("abs(x)"));
  CHECK(holds_plane("x^2"));
  CHECK(holds_plane("sqrt(x)*sqrt(-x)"));
  CHECK(holds_plane("acos(1-x)"));
  CHECK(holds_plane("cbrt(x)^2"));
  CHECK(holds_plane("max(x,-x)"));
  CHECK(holds_plane("hypot(x,0*y)"));
}
