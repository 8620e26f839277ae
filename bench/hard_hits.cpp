// graze-hard-hits: first hits on hard surfaces (thin shells, double roots, a cone's tip, asterisks
// at their pole and origin), by this library's methods and by the baselines, against the exact
// first root: a JSON object a line.
#include <cstdio>
#include <cstdlib>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/exact.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/oracle/roots.hpp>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/nearest.hpp>
#include <peers/paper2005/gargantini.hpp>
#include <peers/paper2005/plain.hpp>
#include <peers/paper2005/published.hpp>
#include <peers/papers/revelles.hpp>
#include <vector>

namespace {

using namespace graze;
using namespace graze::octree;
using namespace graze::peers;

/// Two spheres about 0, the squares of whose radii differ by 1 / Power.
template <std::int64_t Power> struct shell {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    using c = constants<N>;
    const N r = sqr(x) + sqr(y) + sqr(z) - c::exact(1);
    return r * (r + c::template rational<1, Power>());
  }
};
struct squared_sphere {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return sqr(N(sqr(x) + sqr(y) + sqr(z) - constants<N>::exact(1)));
  }
};
struct cone {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return sqr(x) + sqr(y) - sqr(z);
  }
};

struct hard_ray {
  const char* name;
  vec3 origin, direction;
  /// Of asterisks, which are no polynomials: where the first root is known to be (below 0: none).
  double root = 0;
};

/// Of the descents.
int level = 40;

using expected_root = std::optional<oracle::root>;

struct answer {
  verdict outcome;
  double t_near, t_far;
};

/// What the answer is worth beside the root that there is or is not.
const char* judged(const answer& a, const expected_root& is) {
  if (std::isnan(a.t_near) || std::isnan(a.t_far))
    return "nan";
  const bool encloses =
      is && a.t_near <= oracle::double_below(is->lo) && oracle::double_above(is->hi) <= a.t_far;
  switch (a.outcome) {
  case verdict::miss:
    return is ? "missed" : "right";
  case verdict::hit:
    return !is ? "false hit" : encloses ? "right" : "another root";
  default:
    return !is || encloses ? "undecided" : "missed";
  }
}

const char* name_of(verdict v) {
  return v == verdict::hit ? "hit" : v == verdict::miss ? "miss" : "undecided";
}

void print(const char* surface, const hard_ray& r, const char* traversal, const answer& a,
           const expected_root& is) {
  std::printf("{\"surface\": \"%s\", \"ray\": \"%s\", \"traversal\": \"%s\", \"verdict\": \"%s\", "
              "\"outcome\": \"%s\"",
              surface, r.name, traversal, judged(a, is), name_of(a.outcome));
  if (a.outcome != verdict::miss && std::isfinite(a.t_far))
    std::printf(", \"width\": %.3g", a.t_far - a.t_near);
  if (is)
    std::printf(", \"root\": %.17g, \"multiplicity\": %d", is->lo.get_d(), is->multiplicity);
  std::puts("}");
}

template <class F> expected_root first_root(const F& f, const hard_ray& r, const box& domain) {
  const auto range = oracle::rational::range_in(r.origin, r.direction, domain.lo, domain.hi);
  if (!range)
    return std::nullopt;
  const auto [x, y, z] = oracle::along(r.origin, r.direction);
  return oracle::first_root(f(x, y, z), range->first, range->second);
}
template <int M, int N>
expected_root first_root(const asterisk<M, N>&, const hard_ray& r, const box&) {
  if (r.root < 0)
    return std::nullopt;
  return oracle::root{r.root, r.root, 0};
}

template <class M, rounding::Backend B, class F>
void descent(const char* surface, const char* name, const F& f, const box& domain,
             const sparse_octree& octree, const hard_ray& r, const expected_root& is) {
  const surface_hit h = surface_traversal<F, M, B>::make(f, domain, octree, level)
                            ->first_hit(*ray::make(r.origin, r.direction));
  print(surface, r, name, {h.outcome, h.t_near, h.t_far}, is);
}

template <class F>
void on(const char* surface, const F& f, double reach, const std::vector<hard_ray>& rays) {
  const box domain{{-reach, -reach, -reach}, {reach, reach, reach}};
  const auto octree = voxelize(f, domain, 7);
  if (!octree)
    std::abort();
  using rounding::nearest, rounding::upward;
  using enum convention;
  for (const hard_ray& r : rays) {
    const expected_root is = first_root(f, r, domain);
    const certified_hit h =
        certified_traversal<F>::make(f, domain)->first_hit(*ray::make(r.origin, r.direction));
    print(surface, r, "certified", {h.outcome, h.t_near, h.t_far}, is);
    descent<sound<upward, owned>, upward>(surface, "sound", f, domain, *octree, r, is);
    descent<exact<upward, owned>, upward>(surface, "exact", f, domain, *octree, r, is);
    descent<published, nearest>(surface, "published", f, domain, *octree, r, is);
    descent<plain, undirected>(surface, "plain", f, domain, *octree, r, is);
    descent<gargantini, undirected>(surface, "gargantini", f, domain, *octree, r, is);
    descent<revelles, undirected>(surface, "revelles", f, domain, *octree, r, is);
  }
}

std::vector<hard_ray> rays_of_shell(double between) {
  return {{"through the centre", {0, 0, -1.25}, {0, 0, 1}},
          {"beside the centre", {0.3, -0.4, -1.25}, {0, 0, 1}},
          {"touching the outer sphere", {-1.25, 1, 0}, {1, 0, 0}},
          {"between the spheres", {-1.25, between, 0}, {1, 0, 0}},
          {"an ulp outside", {-1.25, 0x1.0000000000001p0, 0}, {1, 0, 0}},
          {"an ulp inside", {-1.25, 0x1.fffffffffffffp-1, 0}, {1, 0, 0}}};
}

std::vector<hard_ray> rays_of_asterisk() {
  // y = 0: sin(m theta) = 0, so f = -R: no root but the origin's
  return {{"along the axis", {0, 0, -2}, {0, 0, 1}, 2},
          {"along the axis, downwards", {0, 0, 2}, {-0.0, 0, -0.5}, 4},
          {"1e-300 beside the axis", {1e-300, 0, -2}, {0, 0, 1}, -1},
          {"from the origin", {0, 0, 0}, {0, 0, 1}, 0},
          {"through the origin, in y = 0", {1, 0, 0.5}, {-1, 0, -0.5}, 1},
          {"through the origin, direction of 1e-300",
           {0x1p-1, 0, 0x1p-2},
           {-0x1p-997, 0, -0x1p-998},
           0x1p996},
          {"in y = 0, 1e-300 above the origin", {1, 0, 1e-300}, {-1, 0, 0}, -1}};
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-hard-hits"))
    return 2;
  if (argc > 1)
    level = std::atoi(argv[1]);
  if (argc > 2 || level < 1 || level > 50) {
    std::fputs("usage: graze-hard-hits [NL]    NL: 1 to 50\n", stderr);
    return 2;
  }
  on("thin shell, 1e-12", shell<1'000'000'000'000>(), 1.5, rays_of_shell(0x1.ffffffffffp-1));
  on("thin shell, 1e-15", shell<1'000'000'000'000'000>(), 1.5, rays_of_shell(0x1.ffffffffffffep-1));
  on("double root", squared_sphere(), 1.5,
     {{"through the centre", {0, 0, -1.25}, {0, 0, 1}},
      {"beside the centre", {0.3, -0.4, -1.25}, {0, 0, 1}},
      {"touching", {-1.25, 1, 0}, {1, 0, 0}},
      {"an ulp outside", {-1.25, 0x1.0000000000001p0, 0}, {1, 0, 0}}});
  on("cone's tip", cone(), 1,
     {{"along the axis", {0, 0, -1}, {0, 0, 1}},
      {"through the tip", {-1, 0, 0.5}, {1, 0, -0.5}},
      {"through the tip from outside", {-1, 0, 0}, {1, 0, 0}},
      {"1e-300 beside the tip", {1e-300, 0, -1}, {0, 0, 1}},
      {"1e-10 beside the tip", {1e-10, 0, -1}, {0, 0, 1}},
      {"along a ruling", {-0.375, -0.5, -0.625}, {3, 4, 5}}});
  const auto on_asterisk = [](const auto& row) {
    on(row.name, row.surface(), row.reach, rays_of_asterisk());
  };
  on_asterisk(built_in<asterisk<3, 4>>);
  on_asterisk(built_in<asterisk<9, 18>>);
  return 0;
}
