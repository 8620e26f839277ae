/// NanoVDB: the walks of its HDDA through a grid, in cells of edge 1, rays in float, normalised as its
/// own examples do: the steps forward in HDDA.h (Delta) are lengths.
///
/// first-active: firstActive() again and again, each time without the cells that it has found. hdda:
/// the loop of ZeroCrossing() in HDDA.h, which keeps each active cell that it comes to.
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/Ray.h>
#include <peers/library.hpp>
#include <peers/nanovdb_walk.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

using ray_in_cells = ::nanovdb::Ray<float>;
using ::nanovdb::Coord;

class grid_of_cells : public structure {
public:
  grid_of_cells(const occupied_octants& octants, const unit_cells& cells) : cells_(cells) {
    ::nanovdb::GridBuilder<float> builder(0.0f);
    auto fill = builder.getAccessor();
    for (const octant_index& at : octants.indices) {
      const std::array<int, 3> cell = cells.cell(at);
      fill.setValue(Coord(cell[0], cell[1], cell[2]), 1.0f);
    }
    handle_ = builder.getHandle<>();
    grid_ = handle_.grid<float>();
  }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    const vec3 at = eye(r);
    return ray_if_any({at[0] * cells_.edge, at[1] * cells_.edge, at[2] * cells_.edge},
                      unit_direction(r));
  }

protected:
  [[nodiscard]] ray_in_cells cell_ray(const octree::ray& r) const {
    const auto vector = [](const vec3& v) {
      return ::nanovdb::Vec3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                              static_cast<float>(v[2]));
    };
    return {vector(eye(r)), vector(unit_direction(r)), 0.0f};
  }

  unit_cells cells_;
  ::nanovdb::GridHandle<> handle_;
  ::nanovdb::FloatGrid* grid_ = nullptr;

private:
  /// The origin in cells, in float.
  [[nodiscard]] vec3 eye(const octree::ray& r) const {
    const vec3& o = r.origin();
    return to_float(vec3{o[0] / cells_.edge, o[1] / cells_.edge, o[2] / cells_.edge});
  }
  [[nodiscard]] static vec3 unit_direction(const octree::ray& r) {
    const vec3& d = r.direction();
    const double length = std::hypot(d[0], d[1], d[2]);
    return to_float(vec3{d[0] / length, d[1] / length, d[2] / length});
  }
};

class hdda final : public grid_of_cells {
public:
  using grid_of_cells::grid_of_cells;

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const std::size_t before = found.size();
    walk_by_hdda(*grid_, cell_ray(r), [&](const Coord& at) {
      const octant_key key = cells_.key(at);
      if (found.size() == before || found.back() != key)
        found.push_back(key);
    });
  }
};

class first_active final : public grid_of_cells {
public:
  using grid_of_cells::grid_of_cells;

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const ray_in_cells ray = cell_ray(r);
    std::vector<Coord> without;
    for (;;) {
      auto read = grid_->getAccessor();
      ray_in_cells part = ray; // it is clipped
      Coord at;
      float t = 0;
      if (!::nanovdb::firstActive(part, read, at, t))
        break;
      found.push_back(cells_.key(at));
      without.push_back(at);
      set_active(at, false);
    }
    for (const Coord& at : without)
      set_active(at, true);
  }

private:
  void set_active(const Coord& at, bool active) {
    auto* leaf = const_cast<::nanovdb::NanoLeaf<float>*>(grid_->getAccessor().probeLeaf(at));
    auto& mask = leaf->data()->mValueMask;
    active ? mask.setOn(leaf->CoordToOffset(at)) : mask.setOff(leaf->CoordToOffset(at));
  }
};

} // namespace

std::vector<variant> nanovdb_variants() {
  return {
      {"nanovdb-first-active", "crossed", timed::yes, "NanoVDB, firstActive",
       "NanoVDB, firstActive again and again (float)", built_in_cells<first_active>},
      {"nanovdb-hdda", "crossed", timed::yes, "NanoVDB", "NanoVDB, HDDA as in ZeroCrossing (float)",
       built_in_cells<hdda>},
  };
}

} // namespace graze::peers
