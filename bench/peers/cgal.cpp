#include "peers.hpp"
#include "rounded_ray.hpp"
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Octree.h>

namespace graze::bench {
namespace {

// CGAL::Octree (since 5.3) on a filtered kernel: do_intersect(ray, box) is decided exactly. A ray
// is kept as two points, origin and origin + direction, so a sum that rounds is another ray, and
// voxels are missed (none are where the sum is exact). Exact constructions as well (EPECK)
// would keep every ray, at many times the cost.
using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using points = std::vector<kernel::Point_3>;
using octree_of_points = CGAL::Octree<kernel, points>;
using node = octree_of_points::Node;

points centres_and_corners(const voxel_grid& grid) {
  points p;
  p.reserve(grid.voxels.size() + 2);
  for (const voxel_index& v : grid.voxels) {
    const octree::vec3 c = grid.centre(v);
    p.emplace_back(c[0], c[1], c[2]);
  }
  // The tree takes its root from its points: the root's corners give it ours.
  const octree::cube& root = grid.root.box();
  p.emplace_back(root.lo[0], root.lo[1], root.lo[2]);
  p.emplace_back(root.hi(0), root.hi(1), root.hi(2));
  return p;
}

/// An output iterator that keeps the voxels among the leaves.
struct keep_voxels {
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = void;
  using pointer = void;
  using reference = void;
  std::vector<voxel_key>* found;
  std::size_t level;
  std::array<voxel_key, 2> not_voxels; ///< where the corners alone make a leaf

  keep_voxels& operator*() { return *this; }
  keep_voxels& operator++() { return *this; }
  keep_voxels& operator++(int) { return *this; }
  keep_voxels& operator=(const node& leaf) {
    if (leaf.depth() != level || leaf.empty())
      return *this;
    const auto at = leaf.global_coordinates();
    const voxel_key key = key_of({at[0], at[1], at[2]});
    if (key != not_voxels[0] && key != not_voxels[1])
      found->push_back(key);
    return *this;
  }
};

struct tree_of_voxels {
  explicit tree_of_voxels(const voxel_grid& grid)
      : level(static_cast<std::size_t>(grid.level())), cloud(centres_and_corners(grid)),
        tree(cloud, CGAL::Identity_property_map<kernel::Point_3>(), 1.0) {
    tree.refine([this](const node& n) { return n.depth() < level && !n.empty(); });
    const std::uint32_t last = (1u << grid.level()) - 1;
    corners = {key_of({0, 0, 0}), key_of({last, last, last})};
    for (const voxel_index& v : grid.voxels)
      for (voxel_key& corner : corners)
        if (key_of(v) == corner)
          corner = ~voxel_key{0}; // a voxel after all
  }
  std::size_t level;
  points cloud;
  octree_of_points tree;
  std::array<voxel_key, 2> corners{};
};

} // namespace

template <> struct peer<cgal>::structure : tree_of_voxels {
  using tree_of_voxels::tree_of_voxels;
};
template <> struct peer<cgal_exact>::structure : tree_of_voxels {
  using tree_of_voxels::tree_of_voxels;
};

template <>
peer<cgal>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<cgal>::~peer() = default;

template <> void peer<cgal>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  const octree::vec3 &o = r.origin(), &d = r.direction();
  const kernel::Point_3 from(o[0], o[1], o[2]), to(o[0] + d[0], o[1] + d[1], o[2] + d[2]);
  if (from == to)
    return; // the direction is lost in the sum: no ray in CGAL
  structure_->tree.intersected_nodes(kernel::Ray_3(from, to),
                                     keep_voxels{&found, structure_->level, structure_->corners});
}

template <> std::optional<octree::ray> peer<cgal>::received(const octree::ray& r) const {
  const octree::vec3 &o = r.origin(), &d = r.direction();
  return ray_by_points(o, {o[0] + d[0], o[1] + d[1], o[2] + d[2]});
}

template <>
peer<cgal_exact>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<cgal_exact>::~peer() = default;

template <> void peer<cgal_exact>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  const octree::vec3 &o = r.origin(), &d = r.direction();
  const CGAL::Epeck::Ray_3 ray(CGAL::Epeck::Point_3(o[0], o[1], o[2]),
                               CGAL::Epeck::Vector_3(d[0], d[1], d[2]));
  structure_->tree.intersected_nodes(ray,
                                     keep_voxels{&found, structure_->level, structure_->corners});
}

template <> std::optional<octree::ray> peer<cgal_exact>::received(const octree::ray& r) const {
  return r;
}

} // namespace graze::bench
