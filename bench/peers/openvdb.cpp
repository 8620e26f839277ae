#include "peers.hpp"
#include "rounded_ray.hpp"
#include <openvdb/math/DDA.h>
#include <openvdb/math/Ray.h>
#include <openvdb/openvdb.h>
#include <openvdb/tree/ValueAccessor.h>

namespace graze::bench {
namespace {

using tree_of_masks = ::openvdb::MaskTree;
using ray_in_cells = ::openvdb::math::Ray<double>;

/// What LevelSetHDDA asks of its user: which nodes there are, and what to do at a voxel.
struct tester {
  using RayT = ray_in_cells;
  using accessor = ::openvdb::tree::ValueAccessor<const tree_of_masks>;

  ray_in_cells part;
  const accessor& tree;
  const std::array<int, 3>& first;
  std::vector<voxel_key>& found;

  [[nodiscard]] const ray_in_cells& ray() const { return part; }
  void setRange(double from, double to) { part.setTimes(from, to); }
  void init(double) {}
  template <class Node> [[nodiscard]] bool hasNode(const ::openvdb::Coord& at) const {
    return tree.probeConstNode<Node>(at) != nullptr;
  }
  bool operator()(const ::openvdb::Coord& at, double) {
    if (tree.isValueOn(at))
      found.push_back(key_of({static_cast<std::uint32_t>(at[0] - first[0]),
                              static_cast<std::uint32_t>(at[1] - first[1]),
                              static_cast<std::uint32_t>(at[2] - first[2])}));
    return false; // on to the next
  }
};

} // namespace

template <> struct peer<openvdb>::structure {
  explicit structure(const voxel_grid& grid)
      : first(grid.first_cell()), side(1 << grid.level()), per_voxel(1 / grid.voxel_size()) {
    ::openvdb::tree::ValueAccessor<tree_of_masks> fill(tree);
    for (const voxel_index& v : grid.voxels)
      fill.setValueOn({static_cast<int>(v[0]) + first[0], static_cast<int>(v[1]) + first[1],
                       static_cast<int>(v[2]) + first[2]});
    read = std::make_unique<tester::accessor>(tree);
  }
  tree_of_masks tree;
  std::array<int, 3> first;
  int side;
  double per_voxel; ///< a power of two
  std::unique_ptr<tester::accessor> read;
};

template <>
peer<openvdb>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<openvdb>::~peer() = default;

template <> void peer<openvdb>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  structure& s = *structure_;
  using vector = ::openvdb::Vec3d;
  const octree::vec3 &o = r.origin(), &d = r.direction();
  ray_in_cells whole(vector(o[0], o[1], o[2]) * s.per_voxel, vector(d[0], d[1], d[2]) * s.per_voxel,
                     0.0);
  const vector lo(s.first[0], s.first[1], s.first[2]);
  if (!whole.clip(::openvdb::BBoxd(lo, lo + vector(s.side))))
    return;
  tester t{whole, *s.read, s.first, found};
  using hdda = ::openvdb::math::LevelSetHDDA<
      tree_of_masks, static_cast<int>(tree_of_masks::RootNodeType::ChildNodeType::LEVEL)>;
  hdda::test(t);
}

template <> std::optional<octree::ray> peer<openvdb>::received(const octree::ray& r) const {
  // in cells: nothing rounds, but the range of double ends
  for (unsigned a = 0; a < 3; ++a)
    for (const double x : {r.origin()[a], r.direction()[a]})
      if (x * structure_->per_voxel / structure_->per_voxel != x)
        return std::nullopt;
  return r;
}

} // namespace graze::bench
