#include "peers.hpp"
#include "rounded_ray.hpp"
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/Ray.h>

namespace graze::bench {
namespace {

using ray_in_cells = ::nanovdb::Ray<float>;
using ::nanovdb::Coord;

/// Voxels as cells of edge 1.
struct cells {
  explicit cells(const voxel_grid& grid) : first(grid.first_cell()), size(grid.voxel_size()) {
    ::nanovdb::GridBuilder<float> builder(0.0f);
    auto fill = builder.getAccessor();
    for (const voxel_index& v : grid.voxels)
      fill.setValue(Coord(static_cast<int>(v[0]) + first[0], static_cast<int>(v[1]) + first[1],
                          static_cast<int>(v[2]) + first[2]),
                    1.0f);
    handle = builder.getHandle<>();
    of = handle.grid<float>();
  }

  [[nodiscard]] voxel_key key(const Coord& at) const {
    return key_of({static_cast<std::uint32_t>(at[0] - first[0]),
                   static_cast<std::uint32_t>(at[1] - first[1]),
                   static_cast<std::uint32_t>(at[2] - first[2])});
  }

  struct rounded {
    octree::vec3 eye, unit; ///< in cells, in single precision
  };
  [[nodiscard]] rounded of_ray(const octree::ray& r) const {
    const octree::vec3 &o = r.origin(), &d = r.direction();
    const double length = std::hypot(d[0], d[1], d[2]);
    return {single(octree::vec3{o[0] / size, o[1] / size, o[2] / size}),
            single(octree::vec3{d[0] / length, d[1] / length, d[2] / length})};
  }
  [[nodiscard]] ray_in_cells ray(const octree::ray& r) const {
    const rounded at = of_ray(r);
    const auto vector = [](const octree::vec3& v) {
      return ::nanovdb::Vec3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                              static_cast<float>(v[2]));
    };
    return {vector(at.eye), vector(at.unit), 0.0f};
  }
  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const {
    const rounded at = of_ray(r);
    return ray_if_any({at.eye[0] * size, at.eye[1] * size, at.eye[2] * size}, at.unit);
  }

  std::array<int, 3> first;
  double size; ///< a power of two
  ::nanovdb::GridHandle<> handle;
  ::nanovdb::FloatGrid* of = nullptr;
};

void hdda(const cells& in, ray_in_cells ray, std::vector<voxel_key>& found) {
  auto read = in.of->getAccessor();
  if (!ray.clip(read.root().bbox()) || ray.t1() > 1e20f)
    return;
  const std::size_t before = found.size();
  const auto keep = [&](const Coord& at) {
    const voxel_key key = in.key(at);
    if (read.isActive(at) && (found.size() == before || found.back() != key))
      found.push_back(key);
  };
  constexpr float forward = 1.0001f; // ZeroCrossing's Delta
  Coord at = ::nanovdb::RoundDown<Coord>(ray.start());
  keep(at);
  ::nanovdb::HDDA<ray_in_cells> walk(ray, static_cast<int>(read.getDim(at, ray)));
  while (walk.step()) {
    at = ::nanovdb::RoundDown<Coord>(ray(walk.time() + forward));
    walk.update(ray, static_cast<int>(read.getDim(at, ray)));
    if (walk.dim() > 1 || !read.isActive(at))
      continue;
    keep(at);
    while (walk.step() && read.isActive(walk.voxel()))
      keep(walk.voxel());
  }
}

void first_active(const cells& in, const ray_in_cells& ray, std::vector<voxel_key>& found) {
  std::vector<Coord> without;
  const auto set = [&](const Coord& at, bool on) {
    auto* leaf = const_cast<::nanovdb::NanoLeaf<float>*>(in.of->getAccessor().probeLeaf(at));
    auto& mask = leaf->data()->mValueMask;
    on ? mask.setOn(leaf->CoordToOffset(at)) : mask.setOff(leaf->CoordToOffset(at));
  };
  for (;;) {
    auto read = in.of->getAccessor();
    ray_in_cells part = ray; // it is clipped
    Coord at;
    float t = 0;
    if (!::nanovdb::firstActive(part, read, at, t))
      break;
    found.push_back(in.key(at));
    without.push_back(at);
    set(at, false);
  }
  for (const Coord& at : without)
    set(at, true);
}

} // namespace

#define GRAZE_PEER_NANOVDB_WALK(Library, walk)                                                     \
  template <> struct peer<Library>::structure : cells {                                            \
    using cells::cells;                                                                            \
  };                                                                                               \
  template <>                                                                                      \
  peer<Library>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}   \
  template <> peer<Library>::~peer() = default;                                                    \
  template <> void peer<Library>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {  \
    walk(*structure_, structure_->ray(r), found);                                                  \
  }                                                                                                \
  template <> std::optional<octree::ray> peer<Library>::received(const octree::ray& r) const {     \
    return structure_->received(r);                                                                \
  }
GRAZE_PEER_NANOVDB_WALK(nanovdb_hdda, hdda)
GRAZE_PEER_NANOVDB_WALK(nanovdb_first_active, first_active)
#undef GRAZE_PEER_NANOVDB_WALK

} // namespace graze::bench
