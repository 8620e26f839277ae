// Rays, exact decisions, descents, voxel walks, surfaces and formulas.
#include "rows.hpp"
#include <graze/batch.hpp>
#include <graze/octree/box.hpp>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/exact.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_formula.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::environments {

namespace {

using namespace octree;

double of_bits(std::uint64_t bits) { return std::bit_cast<double>(bits); }
const double tiny = of_bits(1), small = of_bits(0x0004000000000000);

/// Rays through corners and faces, directions subnormal, huge and far apart.
std::vector<ray> rays(answers* given = nullptr) {
  const double coordinates[] = {0, 0.25, 0.5, -1, 0.75, tiny, 1};
  const double components[] = {0, 1, -1, tiny, -small, 0x1p-600, 0x1p600, 0.3, of_bits(3)};
  std::vector<ray> made;
  for (std::size_t i = 0; i < 7 * 7 * 81; ++i) {
    const vec3 o{coordinates[i % 7], coordinates[i / 7 % 7], coordinates[(i * 3 + i / 49) % 7]};
    const vec3 d{components[i / 49 % 9], components[i / 441 % 9], components[(i + i / 7) % 9]};
    const auto r = ray::make(o, d);
    if (given != nullptr)
      given->says(r ? 1 : 0);
    if (r)
      made.push_back(*r);
  }
  return made;
}

/// Of the unit cube, and of one whose octants are subnormal.
const cube roots[] = {{{0, 0, 0}, 1}, {{0, 0, 0}, of_bits(std::uint64_t{1} << 40)}};

void ask_touches(answers& a) {
  for (const ray& r : rays())
    for (const cube& c : roots)
      for (unsigned child = 0; child < 8; child += 3) {
        // the child's corner as bits: the halves are exact
        const double half = c.size == 1 ? 0.5 : of_bits(std::uint64_t{1} << 39);
        const cube inner{
            {(child & 1) != 0 ? half : 0, (child & 2) != 0 ? half : 0, (child & 4) != 0 ? half : 0},
            half};
        a.says(touches(r, inner) ? 1 : 0);
        a.says(owns(r, inner) ? 1 : 0);
      }
}

struct every_child {
  using node = int;
  [[nodiscard]] int root() const { return 0; }
  [[nodiscard]] std::uint8_t child_mask(int, const cube&, std::uint8_t wanted) const {
    return wanted;
  }
  [[nodiscard]] int child(int, unsigned) const { return 0; }
};
template <template <class, convention> class M, class B, convention C>
void ask_descent(answers& a) {
  for (const ray& r : rays()) {
    std::uint64_t met = 0;
    const typename B::scope scope;
    const M<B, C> method(r);
    descend(method, roots[0], 3, every_child{}, [&](const cube& c, int, const auto&) {
      met = met * 0x100000001b3 ^ std::bit_cast<std::uint64_t>(c.lo[0]) ^
            std::bit_cast<std::uint64_t>(c.lo[1]) << 1 ^ std::bit_cast<std::uint64_t>(c.lo[2]) << 2;
      return false;
    });
    a.says(met);
  }
}

void ask_voxel_rays(answers& a, batch::path p) {
  batch::force_path(p);
  for (const cube& c : roots) {
    std::vector<std::array<std::uint32_t, 3>> voxels;
    for (std::uint32_t i = 0; i < 16; ++i)
      voxels.push_back({i, (i * 7) % 16, (i * 5 + 3) % 16}), voxels.push_back({i, i, i});
    const auto root = root_cube::make(c, 4);
    a.says(root ? 1 : 0);
    if (!root)
      continue;
    const auto set = voxel_set::make(*root, voxels);
    const std::vector<ray> all = rays();
    std::vector<std::uint32_t> counts(all.size());
    for (const exactness certainty : {exactness::exact, exactness::conservative})
      for (const convention rule : {convention::owned, convention::closed}) {
        count_voxels(*set, all, rule, certainty, counts);
        for (const std::uint32_t n : counts)
          a.says(n);
      }
    for (const ray& r : all)
      a.says(first_voxel(*set, r).has_value() ? 1 : 0);
  }
  batch::unforce_path();
}

/// Of every rule, and of subnormal planes.
std::vector<grid> grids(answers& a) {
  std::vector<grid> made;
  const auto keep = [&](const expected<grid>& g) {
    a.says(g ? 1 : 0);
    if (g)
      made.push_back(*g);
  };
  for (const plane_rule rule : {plane_rule::exact, plane_rule::rounded, plane_rule::multiplied,
                                plane_rule::added, plane_rule::binary32}) {
    keep(grid::make({-0.3, 0, 0.1}, {0.1, 0x1.5555555555555p-2, 0}, {7, 5, 1}, rule));
    keep(grid::make({tiny, -small, 0}, {of_bits(3), small, of_bits(1)}, {6, 9, 4}, rule));
  }
  const std::vector<double> planes{-small, 0, tiny, of_bits(5), 0.25, 0.5};
  keep(grid::make({planes, planes, planes}));
  for (const grid& g : made)
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint32_t k = 0; k <= g.count(axis); ++k)
        a.value_is(g.lower(axis, k)), a.value_is(g.upper(axis, k));
  return made;
}

std::vector<segment> segments() {
  std::vector<segment> made;
  for (const ray& r : rays())
    if (const auto s = segment::make(r.origin(), r.direction()))
      made.push_back(*s);
  return made;
}

template <class T> std::vector<T> every_fifth(const std::vector<T>& all) {
  std::vector<T> some;
  for (std::size_t i = 0; i < all.size(); i += 5)
    some.push_back(all[i]);
  return some;
}

void ask_lines(answers& a) {
  const auto ask = [&](const exact_line& line, const grid& g, std::size_t i) {
    const slabs cell = g.voxel({static_cast<std::uint32_t>(i) % g.count(0),
                                static_cast<std::uint32_t>(i / 3) % g.count(1),
                                static_cast<std::uint32_t>(i / 5) % g.count(2)});
    a.says((line.touches(cell) ? 1u : 0) | (line.crosses(cell) ? 2u : 0) |
           (line.owns(cell) ? 4u : 0));
    if (const auto p = line.through(cell)) {
      a.says(p->entered | p->left << 8);
      for (const bounds& b : {p->enter, p->leave, p->length})
        a.value_is(b.lo), a.value_is(b.hi);
    }
  };
  const std::vector<grid> all = grids(a);
  const std::vector<ray> lines = every_fifth(rays());
  const std::vector<segment> between = every_fifth(segments());
  for (const grid& g : all) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      ask(lines[i], g, i);
    for (std::size_t i = 0; i < between.size(); ++i)
      ask(between[i], g, i);
  }
}

void ask_grids(answers& a, batch::path p) {
  batch::force_path(p);
  for (const grid& g : grids(a)) {
    std::vector<std::array<std::uint32_t, 3>> voxels;
    for (std::uint32_t i = 0; i < 16; ++i)
      voxels.push_back({i % g.count(0), i * 7 % g.count(1), i % g.count(2)});
    const auto set = voxel_set::make(g, voxels);
    const std::vector<ray> all = every_fifth(rays());
    const std::vector<segment> between = every_fifth(segments());
    std::vector<std::uint32_t> counts(all.size()), of_segments(between.size());
    for (const exactness certainty : {exactness::exact, exactness::conservative})
      for (const convention rule : {convention::owned, convention::closed}) {
        count_voxels(*set, all, rule, certainty, counts);
        count_voxels(*set, between, rule, certainty, of_segments);
        for (const auto* some : {&counts, &of_segments})
          for (const std::uint32_t n : *some)
            a.says(n);
      }
  }
  batch::unforce_path();
}

/// Rays at the surface from outside.
std::vector<ray> camera() {
  std::vector<ray> r;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      const double steps[] = {-1.5, -1.25, -1, -0.5, -0.25, tiny, 0.125, 0.25, 0.5, 1, 1.25, 1.5};
      const vec3 o{6, steps[i], steps[j]};
      r.push_back(*ray::make(o, {-1, i % 3 == 0 ? tiny : 0.0625, j % 2 == 0 ? 0 : -0.03125}));
    }
  return r;
}

void say(answers& a, const certified_hit& h) {
  a.says(static_cast<std::uint64_t>(h.outcome));
  a.value_is(h.t_near), a.value_is(h.t_far);
}
const box domain{{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}};

template <class F> void ask_certified(answers& a, const F& f) {
  const auto t = certified_traversal<F>::make(f, domain);
  for (const ray& r : camera())
    say(a, t->first_hit(r));
}
template <class F> void ask_lanes(answers& a, const F& f, batch::path p) {
  const std::vector<ray> all = camera();
  std::vector<certified_hit> hits(all.size());
  lane_kernels_of<F>(p).certified_hits(f, domain, all.data(), all.size(), hits.data(), nullptr);
  for (const certified_hit& h : hits)
    say(a, h);
  const auto root = enclosing_root(domain, 4);
  const auto tree = voxelize_in_lanes(f, *root, domain, p);
  a.says(tree ? tree->leaf_count() : 0);
}

void ask_formulas(answers& a) {
  for (const char* const text :
       {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", "sin(x)*exp(y) - z/3 + 1e-310",
        "sqrt(x^2 + y^2) + 4.9e-324*z", "log(x) + 2^-1070"}) {
    const auto f = formula::parse(text);
    a.says(f ? 1 : 0);
    if (f)
      ask_certified(a, f->surface());
  }
}

} // namespace

std::vector<row> rows_of_octrees() {
  using rounding::upward, rounding::split;
  std::vector<row> r{
      {"ray::make", promise::immune, [](answers& a) { rays(&a); }},
      {"touches, owns", promise::immune, ask_touches},
      {"grids, exact_line", promise::immune, ask_lines},
      {"descent, sound over upward", promise::immune,
       ask_descent<sound, upward, convention::owned>},
      {"descent, sound over split", promise::immune, ask_descent<sound, split, convention::closed>},
      {"descent, exact over upward", promise::immune,
       ask_descent<exact, upward, convention::closed>},
      {"certified hits", promise::immune, [](answers& a) { ask_certified(a, tanglecube{}); }},
      {"formulas", promise::immune, ask_formulas}};
  for (const batch::path p : batch::paths)
    if (!batch::refusal(p)) {
      r.push_back({std::string("voxel_rays, ") + batch::name(p), promise::immune,
                   [p](answers& a) { ask_voxel_rays(a, p); }});
      r.push_back({std::string("voxel_rays over grids, ") + batch::name(p), promise::immune,
                   [p](answers& a) { ask_grids(a, p); }});
      r.push_back({std::string("certified hits and voxels, ") + batch::name(p), promise::immune,
                   [p](answers& a) { ask_lanes(a, tanglecube{}, p); }});
    }
  return r;
}

} // namespace graze::environments
