/// OpenVDB, in cells of edge 1, rays in double.
///
/// dda: DDA from where the ray enters the root to where it leaves it. level-set-hdda: LevelSetHDDA down
/// to the cell. volume-ray-intersector: it tells leaves of 8^3 cells apart and no cells, so that an
/// occupied octant is a leaf; asked leaf by leaf.
#include <openvdb/math/DDA.h>
#include <openvdb/math/Ray.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/RayIntersector.h>
#include <openvdb/tree/ValueAccessor.h>
#include <peers/library.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

using tree_of_masks = ::openvdb::MaskTree;
using accessor = ::openvdb::tree::ValueAccessor<const tree_of_masks>;
using ray_in_cells = ::openvdb::math::Ray<double>;
using vector = ::openvdb::Vec3d;

vector scaled_vector(const vec3& v, double factor) { return vector(v[0], v[1], v[2]) * factor; }

::openvdb::Coord coordinates(const std::array<int, 3>& cell) { return {cell[0], cell[1], cell[2]}; }

/// Cuts the ray to the root; false where it passes by.
bool clip(ray_in_cells& ray, const unit_cells& cells) {
  const vector lo(cells.root[0], cells.root[1], cells.root[2]);
  return ray.clip(::openvdb::BBoxd(lo, lo + vector(cells.side)));
}

class masks : public structure {
public:
  masks(const occupied_octants& octants, const unit_cells& cells) : cells_(cells) {
    ::openvdb::tree::ValueAccessor<tree_of_masks> fill(tree_);
    for (const octant_index& at : octants.indices)
      fill.setValueOn(coordinates(cells.cell(at)));
    read_ = std::make_unique<accessor>(tree_);
  }

protected:
  tree_of_masks tree_;
  unit_cells cells_;
  std::unique_ptr<accessor> read_;
};

class level_set_hdda final : public masks {
public:
  using masks::masks;

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    // in cells: nothing rounds, but the range of double ends
    const double cells = 1 / cells_.edge;
    for (unsigned a = 0; a < 3; ++a)
      for (const double x : {r.origin()[a], r.direction()[a]})
        if (x * cells / cells != x)
          return std::nullopt;
    return r;
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const double cells = 1 / cells_.edge; // a power of two
    ray_in_cells whole(scaled_vector(r.origin(), cells), scaled_vector(r.direction(), cells), 0.0);
    if (!clip(whole, cells_))
      return;
    tester t{whole, *read_, cells_, found};
    using hdda = ::openvdb::math::LevelSetHDDA<
        tree_of_masks, static_cast<int>(tree_of_masks::RootNodeType::ChildNodeType::LEVEL)>;
    hdda::test(t);
  }

private:
  /// What LevelSetHDDA asks of its user: which nodes there are, and what to do at a cell.
  struct tester {
    using RayT = ray_in_cells;

    ray_in_cells part;
    const accessor& read;
    const unit_cells& cells;
    std::vector<octant_key>& found;

    [[nodiscard]] const ray_in_cells& ray() const { return part; }
    void setRange(double from, double to) { part.setTimes(from, to); }
    void init(double) {}
    template <class Node> [[nodiscard]] bool hasNode(const ::openvdb::Coord& at) const {
      return read.probeConstNode<Node>(at) != nullptr;
    }
    bool operator()(const ::openvdb::Coord& at, double) {
      if (read.isValueOn(at))
        found.push_back(cells.key(at));
      return false; // on to the next
    }
  };
};

/// The ray where an octant's edge is `edge`, from t = 0 on.
ray_in_cells ray_of_edge(const octree::ray& r, const unit_cells& cells, double edge) {
  const vec3& o = r.origin();
  return {vector(o[0] / cells.edge, o[1] / cells.edge, o[2] / cells.edge) * edge,
          scaled_vector(r.direction(), 1), 0.0};
}
std::optional<octree::ray> received_of_edge(const octree::ray& r, const unit_cells& cells,
                                            double edge) {
  const vector eye = ray_of_edge(r, cells, edge).eye();
  return ray_if_any(
      {eye[0] / edge * cells.edge, eye[1] / edge * cells.edge, eye[2] / edge * cells.edge},
      r.direction());
}

class dda final : public masks {
public:
  using masks::masks;

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    return received_of_edge(r, cells_, 1);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    ray_in_cells ray = ray_of_edge(r, cells_, 1);
    if (!clip(ray, cells_))
      return;
    ::openvdb::math::DDA<ray_in_cells> walk(ray);
    do {
      if (read_->isValueOn(walk.voxel()))
        found.push_back(cells_.key(walk.voxel()));
    } while (walk.step());
  }
};

class volume_ray_intersector final : public structure {
public:
  volume_ray_intersector(const occupied_octants& octants, const unit_cells& cells)
      : octants_(octants.indices), cells_(cells) {}

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    return received_of_edge(r, cells_, side);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const ray_in_cells ray = ray_of_edge(r, cells_, side);
    for (const octant_index& at : octants_) {
      leaves grid;
      const std::array<int, 3> cell = cells_.cell(at);
      grid.tree().touchLeaf({cell[0] * side, cell[1] * side, cell[2] * side})->setValuesOn();
      ::openvdb::tools::VolumeRayIntersector<leaves> intersector(grid);
      double from = 0, to = 0;
      if (intersector.setIndexRay(ray) && intersector.march(from, to))
        found.push_back(key_of(at));
    }
  }

private:
  static constexpr int side = 8; // of a leaf
  /// A tree of smaller nodes than OpenVDB's own: one is made for each octant of each ray.
  using leaves = ::openvdb::Grid<::openvdb::tree::Tree4<bool, 2, 2, 3>::Type>;

  std::vector<octant_index> octants_;
  unit_cells cells_;
};

} // namespace

std::vector<variant> openvdb_variants() {
  return {
      {"openvdb-dda", "crossed", timed::no, "OpenVDB, DDA", "OpenVDB, DDA", built_in_cells<dda>},
      {"openvdb-level-set-hdda", "crossed", timed::yes, "OpenVDB", "OpenVDB, LevelSetHDDA",
       built_in_cells<level_set_hdda>},
      {"openvdb-volume-ray-intersector", "crossed", timed::no, "OpenVDB, leaf by leaf",
       "OpenVDB, VolumeRayIntersector, leaf by leaf", built_in_cells<volume_ray_intersector>},
  };
}

} // namespace graze::peers
