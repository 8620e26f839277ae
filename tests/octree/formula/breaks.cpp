// Rays that meet poles, jumps and gaps of f: decided, and as an independent judge says. Judges: exact
// roots of the polynomials of which f is made, piece by piece; f without its pole, a continuous
// formula; f on both sides of its jump.
#include "../../support/formulas.hpp"
#include "../../support/paths.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree_formula/lane_kernels.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/oracle/roots.hpp>
#include <vector>

using namespace graze;
using namespace graze::octree;
using oracle::polynomial;
using support::cube_of;
using support::parsed;

namespace {

/// size x size rays from an eye in front of a corner of the cube, to all of it.
std::vector<ray> rays_to(double side, int size) {
  std::vector<ray> rays;
  const vec3 eye{2.1 * side, 1.7 * side, 2.6 * side};
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const double u = (2 * i + 1.07) / size - 1, v = (2 * j + 0.97) / size - 1;
      const vec3 to{1.2 * side * u, 1.19 * side * v, -0.47 * side * (u + v)};
      rays.push_back(*ray::make(eye, {to[0] - eye[0], to[1] - eye[1], to[2] - eye[2]}));
    }
  return rays;
}

/// The first root, between two rationals.
using exact_root = std::optional<std::pair<mpq_class, mpq_class>>;

/// g's first root t in [from, to], without the ends that are left out; g is not 0 twice at an end.
exact_root root_of(const polynomial& g, mpq_class from, mpq_class to, bool with_from = true,
                   bool with_to = true) {
  const mpq_class little(1, mpz_class(1) << 400);
  if (!with_from && g(from) == 0)
    from += little;
  if (!with_to && g(to) == 0)
    to -= little;
  if (to < from)
    return std::nullopt;
  if (const auto r = oracle::first_root(g, from, to))
    return {{r->lo, r->hi}};
  return std::nullopt;
}

/// What is known of a ray exactly: where it is in the domain, and its coordinates.
struct exact_ray {
  mpq_class entry, exit;
  std::array<polynomial, 3> at;
};
using exact_judge = std::function<exact_root(const exact_ray&)>;

/// f is numerator / denominator; they are 0 together nowhere on the rays.
exact_judge rational(
    std::function<polynomial(const polynomial&, const polynomial&, const polynomial&)> numerator) {
  return [numerator](const exact_ray& r) {
    return root_of(numerator(r.at[0], r.at[1], r.at[2]), r.entry, r.exit);
  };
}

/// f is piece(k) where floor(p / step) = k, with p one of the coordinates.
exact_judge stepped(int axis, int step, std::function<polynomial(int, const exact_ray&)> piece) {
  return [=](const exact_ray& r) -> exact_root {
    const polynomial& p = r.at[static_cast<std::size_t>(axis)];
    const mpq_class slope = p.coefficient(1);
    REQUIRE(slope != 0);
    // the breaks on the way, in order
    mpq_class t = r.entry;
    bool with_t = true;
    while (true) {
      const mpq_class scaled = p(t) / step;
      mpz_class k;
      mpz_fdiv_q(k.get_mpz_t(), scaled.get_num().get_mpz_t(), scaled.get_den().get_mpz_t());
      if (slope < 0 && !with_t && scaled == k)
        --k; // just behind the break, which belongs to the piece before
      const mpq_class end((slope > 0 ? k + 1 : k) * step);
      const mpq_class next = (end - p.coefficient(0)) / slope;
      const bool last = r.exit < next;
      if (const auto found = root_of(piece(static_cast<int>(k.get_si()), r), t,
                                     last ? r.exit : next, with_t, last || slope < 0))
        return found;
      if (last)
        return std::nullopt;
      t = next;
      with_t = slope > 0;
    }
  };
}

struct judged_formula {
  const char* text;
  double side;
  exact_judge judge;
  std::vector<verdict> breaks; ///< what its rays may end in, without a root
};

std::vector<judged_formula> exactly_judged() {
  const auto of = [](auto f) { return rational(f); };
  return {
      {"1/x+y+z", 2, of([](auto x, auto y, auto z) { return 1 + x * (y + z); }), {verdict::pole}},
      {"1/x^2-y-4", 2, of([](auto x, auto y, auto) { return 1 - (y + 4) * x * x; }), {}},
      {"1/x^3+y*z",
       2,
       of([](auto x, auto y, auto z) { return 1 + y * z * x * x * x; }),
       {verdict::pole}},
      {"1/x+1/y+1/z",
       2,
       of([](auto x, auto y, auto z) { return y * z + x * z + x * y; }),
       {verdict::pole}},
      {"1/x+y/x+z", 2, of([](auto x, auto y, auto z) { return 1 + y + x * z; }), {verdict::pole}},
      {"1/(x^2+y^2-1)+z",
       2,
       of([](auto x, auto y, auto z) { return 1 + z * (x * x + y * y - 1); }),
       {verdict::pole}},
      {"2^-40/x+y-1/2",
       2,
       of([](auto x, auto y, auto) {
         return mpq_class(1, mpz_class(1) << 40) + x * (y - mpq_class(1, 2));
       }),
       {verdict::pole}},
      {"x/x+y", 2, of([](auto, auto y, auto) { return 1 + y; }), {verdict::gap}},
      {"x^2/x+y", 2, of([](auto x, auto y, auto) { return x + y; }), {verdict::gap}},
      {"x/abs(x)+y",
       2,
       stepped(0, 4, [](int k, const exact_ray& r) { return r.at[1] + (k < 0 ? -1 : 1); }),
       {verdict::jump}},
      {"abs(x)/x*y+z",
       2,
       stepped(0, 4,
               [](int k, const exact_ray& r) { return r.at[2] + (k < 0 ? -1 : 1) * r.at[1]; }),
       {verdict::jump}},
      {"sign(x)+y",
       2,
       stepped(0, 4, [](int k, const exact_ray& r) { return r.at[1] + (k < 0 ? -1 : 1); }),
       {verdict::jump}},
      {"z-floor(x)",
       3,
       stepped(0, 1, [](int k, const exact_ray& r) { return r.at[2] - k; }),
       {verdict::jump}},
      {"ceil(x)+y*z",
       3,
       stepped(0, 1, [](int k, const exact_ray& r) { return r.at[1] * r.at[2] + k + 1; }),
       {verdict::jump}},
      {"floor(floor(x)/2)+y",
       4,
       stepped(0, 2, [](int k, const exact_ray& r) { return r.at[1] + k; }),
       {verdict::jump}},
      {"x-2*floor(x/2)-1+y",
       4,
       stepped(0, 2, [](int k, const exact_ray& r) { return r.at[0] - (2 * k + 1) + r.at[1]; }),
       {verdict::jump}},
      {"y/(x-floor(x)-1/2)+1",
       2,
       stepped(
           0, 1,
           [](int k, const exact_ray& r) { return r.at[1] + r.at[0] - mpq_class(2 * k + 1, 2); }),
       {verdict::pole, verdict::jump}},
      {"(x-2*floor(x/2)-1)^2+(y-2*floor(y/2)-1)^2+(z-2*floor(z/2)-1)^2-0.3",
       4,
       // a ball in the middle of each cube
       [](const exact_ray& r) {
         exact_root first;
         for (int i = -3; i <= 3; i += 2)
           for (int j = -3; j <= 3; j += 2)
             for (int k = -3; k <= 3; k += 2) {
               const polynomial g =
                   sqr(r.at[0] - i) + sqr(r.at[1] - j) + sqr(r.at[2] - k) - mpq_class(3, 10);
               const mpq_class a = g.coefficient(2), b = g.coefficient(1), c = g.coefficient(0);
               if (b * b < 4 * a * c)
                 continue;
               const auto root = root_of(g, r.entry, r.exit);
               if (root && (!first || root->first < first->first))
                 first = root;
             }
         return first;
       },
       {verdict::jump}},
  };
}

void check_verdict(const certified_hit& h, const std::vector<verdict>& breaks) {
  const bool allowed = h.outcome == verdict::miss || h.outcome == verdict::hit ||
                       std::find(breaks.begin(), breaks.end(), h.outcome) != breaks.end();
  REQUIRE(allowed);
  if (h.outcome != verdict::miss)
    REQUIRE(h.t_near <= h.t_far);
}

certified_traversal<formula_surface> traversal_of(const formula& f, const box& domain) {
  const auto t = certified_traversal<formula_surface>::make(f.surface(), domain);
  REQUIRE(t);
  return *t;
}

certified_hit along(const char* text, const box& domain, const vec3& origin,
                    const vec3& direction) {
  const formula f = parsed(text);
  return traversal_of(f, domain).first_hit(*ray::make(origin, direction));
}

} // namespace

TEST_CASE("octree.formula: rays past poles and jumps end as exact roots say, all of them decided",
          "[property]") {
  int all = 0; // that end in a pole, a jump or a gap
  for (const judged_formula& j : exactly_judged()) {
    const formula f = parsed(j.text);
    const box domain = cube_of(j.side);
    const auto traversal = traversal_of(f, domain);
    int hits = 0, met = 0;
    for (const ray& r : rays_to(j.side, 128)) {
      const certified_hit h = traversal.first_hit(r);
      INFO(j.text << ": " << r.direction()[0] << " " << r.direction()[1] << " "
                  << r.direction()[2]);
      REQUIRE(h.outcome != verdict::undecided);
      check_verdict(h, j.breaks);
      const bool breaks = h.outcome != verdict::hit && h.outcome != verdict::miss;
      hits += h.outcome == verdict::hit;
      met += breaks;
      if ((hits + met) % 8 != 0 && !breaks)
        continue;
      const auto range =
          oracle::rational::range_in(r.origin(), r.direction(), domain.lo, domain.hi);
      exact_root root;
      if (range)
        root = j.judge({range->first, range->second, oracle::along(r.origin(), r.direction())});
      REQUIRE((h.outcome == verdict::hit) == root.has_value());
      if (root) {
        CHECK(mpq_class(h.t_near) <= root->second);
        CHECK(root->first <= mpq_class(h.t_far));
      }
    }
    INFO(j.text);
    CHECK(hits > 100);
    all += met;
  }
  CHECK(all > 10000);
}

TEST_CASE("octree.formula: a surface with a pole is that without it", "[property]") {
  struct pair {
    const char *text, *without;
    double side;
  };
  for (const pair& p : {pair{"sec(x)+y", "1+y*cos(x)", 2},
                        {"x*tan(z/0.5)-y", "x*sin(2*z)-y*cos(2*z)", 2},
                        {"coth(x)+y", "cosh(x)+y*sinh(x)", 2},
                        {"csch(x)+y", "1+y*sinh(x)", 2},
                        {"cot(x)+csc(x)*y+3", "cos(x)+y+3*sin(x)", 2},
                        {"sec(x)+tan(x)*y+z/4", "1+sin(x)*y+z/4*cos(x)", 2},
                        {"cot(x)+csc(y)+z", "cos(x)*sin(y)+sin(x)+z*sin(x)*sin(y)", 2}}) {
    const formula f = parsed(p.text), g = parsed(p.without);
    const auto one = traversal_of(f, cube_of(p.side)), other = traversal_of(g, cube_of(p.side));
    int hits = 0, poles = 0;
    for (const ray& r : rays_to(p.side, 128)) {
      const certified_hit h = one.first_hit(r), judge = other.first_hit(r);
      INFO(p.text << ": " << r.direction()[0] << " " << r.direction()[1] << " "
                  << r.direction()[2]);
      REQUIRE(h.outcome != verdict::undecided);
      check_verdict(h, {verdict::pole});
      REQUIRE(judge.outcome != verdict::undecided);
      REQUIRE((h.outcome == verdict::hit) == (judge.outcome == verdict::hit));
      hits += h.outcome == verdict::hit;
      poles += h.outcome == verdict::pole;
      if (h.outcome == verdict::hit) {
        REQUIRE(h.t_near <= judge.t_far);
        REQUIRE(judge.t_near <= h.t_far);
      }
    }
    INFO(p.text);
    CHECK(hits > 100);
    CHECK(poles > 10);
  }
}

TEST_CASE("octree.formula: a surface across a jump is that of its two sides", "[property]") {
  struct row {
    const char* text;
    std::size_t axis; ///< of the plane on which f jumps, or is not defined
    verdict met;
  };
  for (const row& w : {row{"atan2(y,x)-z", 1, verdict::jump},
                       {"sin(atan2(y,x)-z)", 1, verdict::jump},
                       {"atan2(y,x)/2-z*x", 1, verdict::jump},
                       {"if(y > 0, x+2, z)-1/2", 1, verdict::jump},
                       {"if(x < 0, y, 1/x)+z", 0, verdict::pole},
                       {"atan(1/x)+y", 0, verdict::jump},
                       {"atan(1/x)*z+y", 0, verdict::jump},
                       {"sin(x)/x+y", 0, verdict::gap},
                       {"expm1(x)/x+2*y", 0, verdict::gap},
                       {"tan(x/2)/sin(x)+y", 0, verdict::gap}}) {
    const formula f = parsed(w.text);
    const box domain = cube_of(2);
    box below = domain, above = domain;
    below.hi[w.axis] = -0x1p-80;
    above.lo[w.axis] = 0x1p-80;
    const auto whole = traversal_of(f, domain), one = traversal_of(f, below),
               other = traversal_of(f, above);
    int hits = 0, met = 0;
    for (const ray& r : rays_to(2, 128)) {
      const certified_hit h = whole.first_hit(r);
      INFO(w.text << ": " << r.direction()[0] << " " << r.direction()[1] << " "
                  << r.direction()[2]);
      REQUIRE(h.outcome != verdict::undecided);
      check_verdict(h, {w.met});
      certified_hit first = one.first_hit(r), second = other.first_hit(r);
      if (second.outcome == verdict::hit &&
          (first.outcome != verdict::hit || second.t_far < first.t_near))
        std::swap(first, second);
      REQUIRE(first.outcome != verdict::undecided);
      REQUIRE((h.outcome == verdict::hit) == (first.outcome == verdict::hit));
      hits += h.outcome == verdict::hit;
      met += h.outcome == w.met;
      if (h.outcome == verdict::hit) {
        REQUIRE(h.t_near <= first.t_far);
        REQUIRE(first.t_near <= h.t_far);
      }
    }
    INFO(w.text);
    CHECK(hits > 100);
    CHECK(met > 10);
  }
}

TEST_CASE("octree.formula: past poles and jumps every path finds what scalar code finds",
          "[unit]") {
  for (const judged_formula& j : exactly_judged()) {
    const formula f = parsed(j.text);
    const auto scalar = traversal_of(f, cube_of(j.side));
    const std::vector<ray> rays = rays_to(j.side, 48);
    test::for_each_path([&](batch::path p) {
      const auto lanes =
          lane_certified_traversal<formula_surface>::make(f.surface(), cube_of(j.side), p);
      REQUIRE(lanes);
      std::vector<certified_hit> hits(rays.size());
      lanes->first_hits(rays, hits);
      int different = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
        different += !(hits[i] == scalar.first_hit(rays[i]));
      INFO(j.text);
      CHECK(different == 0);
    });
  }
}

TEST_CASE("octree.formula: a root at a jump, or that a pole meets, is not lost", "[hardcase]") {
  const box domain = cube_of(2);
  struct row {
    const char* text;
    vec3 origin, direction;
  };
  // the root is at t = 1
  for (const row& w : {row{"z-floor(x)", {.5, .25, .5}, {.5, 0, .5}},
                       {"z-floor(x)", {1.5, .25, 1.5}, {-.5, 0, -.5}},
                       {"floor(x)-1", {0, .25, .5}, {1, 0, 0}},
                       {"floor(x)*(2-x)-1", {0, .25, .5}, {1, 0, 0}},
                       {"ceil(x)-1", {2, .25, .5}, {-1, 0, 0}},
                       {"ceil(x)*x-1", {0, .25, .5}, {1, 0, 0}},
                       {"trunc(x)-1", {0, .25, .5}, {1, 0, 0}},
                       {"trunc(x)+1", {0, .25, .5}, {-1, 0, 0}},
                       {"sign(x-1)+y-1/4", {0, .25, 0}, {1, 0, 0}},
                       {"sign(x)", {-1, .25, 0}, {1, 0, 0}},
                       {"sign(floor(x-1)+y-1/4)", {0, .25, 0}, {1, 0, 0}},
                       {"atan2(y,x)-pi", {-1, 1, 0}, {0, -1, 0}},
                       {"atan2(y,x)-pi", {-1, -1, 0}, {0, 1, 0}},
                       {"(x-1)^2/y", {0, .25, 0}, {1, 0, 0}},
                       {"(x-1)^2*(floor(y+x)+1)", {0, .25, 0}, {1, 0, 0}},
                       {"(x-1)^2*sec(x*pi/2+y)", {0, .25, 0}, {1, 0, 0}},
                       {"abs(x-1)/y", {0, .25, 0}, {1, 0, 0}},
                       {"max(floor(x)-1, (x-1)^2)", {0, .25, 0}, {1, 0, 0}},
                       {"if(x < 1, x+1, x-1)", {0, .25, 0}, {1, 0, 0}},
                       {"if(x <= 1, (x-1)^2, 5)", {0, .25, 0}, {1, 0, 0}},
                       {"(x-1)%1*(x+1)", {.5, .25, 0}, {.5, 0, 0}},
                       {"sqrt(x-1)*floor(x)", {0, .25, 0}, {1, 0, 0}},
                       {"hypot(x-1, floor(x)-1)", {0, .25, 0}, {1, 0, 0}},
                       {"(x-1)^2*(1+1/(x-1+y-1/4+z))", {0, .25, .5}, {1, 0, 0}}}) {
    INFO(w.text);
    const certified_hit h = along(w.text, domain, w.origin, w.direction);
    CHECK_FALSE(is_free(h.outcome));
    CHECK(h.t_near <= 1);
    CHECK(1 <= h.t_far);
  }
}

TEST_CASE(
    "octree.formula: what f tends to at a jump, a pole or a hole, without having it, is no hit",
    "[hardcase]") {
  const box domain = cube_of(2);
  struct row {
    const char* text;
    vec3 origin, direction;
  };
  for (const row& w : {row{"z-floor(x)-1/2", {0.5, .25, 1.5}, {1, 0, -1}},
                       {"(x-floor(x))-1", {0, .25, 0}, {1, 0, 0}},
                       {"ceil(x)-x-1+y*0", {.5, .25, 0}, {.5, 0, 0}},
                       {"atan2(y,x)+pi", {-1, 1, 0}, {0, -1, 0}},
                       {"(x-1)/(x-1)*(x-1)", {0, .25, 0}, {1, 0, 0}},
                       {"(x-1)*(1/(x-1))-1+(x-1)", {0, .25, 0}, {1, 0, 0}},
                       {"(x^2-1)/(x-1)-2", {0, .25, 0}, {1, 0, 0}},
                       {"(x^2-1)/(x-1)", {.5, .25, 0}, {1, 0, 0}},
                       {"sin(x-1)/(x-1)-1", {0, .25, 0}, {1, 0, 0}},
                       {"abs(x-1)/(x-1)", {0, .25, 0}, {1, 0, 0}},
                       {"sign(x-1)+1/2", {0, .25, 0}, {1, 0, 0}}}) {
    INFO(w.text);
    CHECK(along(w.text, domain, w.origin, w.direction).outcome != verdict::hit);
  }
}

TEST_CASE("octree.formula: a root beside a pole is a hit, and the pole alone is named",
          "[hardcase]") {
  const box domain = cube_of(2);
  // x = -a / y, y = 1/2, on the far side of the pole and on the near one
  for (const int bits : {4, 20, 40, 46}) {
    const std::string text = "2^-" + std::to_string(bits) + "/x+y";
    const double root = -std::ldexp(2, -bits);
    for (const double side : {-1, 1}) {
      const certified_hit h = along(text.c_str(), domain, {side, .5, .25}, {-side, 0, 0});
      INFO(text << " from " << side << " " << h.t_near << " " << h.t_far);
      CHECK(h.outcome == verdict::hit);
      CHECK(h.unique);
      const double t = (root - side) / -side; // exact
      CHECK(h.t_near <= t);
      CHECK(t <= h.t_far);
    }
    // where y < 0 the root is the pole's other side
    CHECK(along(text.c_str(), {{-2, -2, -2}, {0x1p-60, 2, 2}}, {-1, -.5, .25}, {1, 0, 0}).outcome !=
          verdict::hit);
  }
  const auto outcome = [&](const char* text) {
    return along(text, domain, {-1.75, .25, .375}, {1, 0, 0}).outcome;
  };
  CHECK(outcome("1/x+y/2") == verdict::pole);
  CHECK(outcome("1/x-y-z") == verdict::hit); // at x = 1.6, behind the pole
  CHECK(outcome("1/x^2+y+z") == verdict::miss);
  CHECK(outcome("floor(x)+1/2") == verdict::jump);
  CHECK(outcome("floor(x)+1/x") == verdict::pole);
  CHECK(outcome("x/abs(x)*2+y") == verdict::jump);
  CHECK(outcome("sin(x)/x+y+z") == verdict::gap);
  CHECK(outcome("floor(8*x)+floor(8*y)+floor(8*z)+1/2") == verdict::jump);
  CHECK(outcome("floor(2^60*x)+1/2") != verdict::hit);
  CHECK(outcome("tan(100*x)*0+y") != verdict::hit);
}
