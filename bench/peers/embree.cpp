#include "peers.hpp"
#include "rounded_ray.hpp"
#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>

namespace graze::bench {
namespace {

/// The voxels as user geometry. The callback records the box and never accepts a hit, so that the
/// ray goes on: the fastest way to all boxes on a ray (no hit structure written, no second look at
/// the geometry). Medium build quality was no slower than high.
class boxes {
public:
  boxes(const voxel_grid& grid, bool robust, bool tested) : scene_(rtcNewScene(device())) {
    for (const voxel_index& v : grid.voxels) {
      const octree::cube c = grid.root.octant({v[0], v[1], v[2]}, grid.level());
      corners_.push_back({static_cast<float>(c.lo[0]), static_cast<float>(c.lo[1]),
                          static_cast<float>(c.lo[2]), static_cast<float>(c.hi(0)),
                          static_cast<float>(c.hi(1)), static_cast<float>(c.hi(2))});
      keys_.push_back(key_of(v));
    }
    rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry g = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(g, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(corners_.size()));
    rtcSetGeometryUserData(g, this);
    rtcSetGeometryBoundsFunction(g, bounds, nullptr);
    rtcSetGeometryOccludedFunction(g, tested ? candidate<true> : candidate<false>);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene_, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene_);
  }
  boxes(const boxes&) = delete;
  boxes& operator=(const boxes&) = delete;
  ~boxes() { rtcReleaseScene(scene_); }

  void occupied(const octree::ray& ray, std::vector<voxel_key>& found) const {
    query q;
    rtcInitIntersectContext(&q);
    q.found = &found;
    const octree::vec3 &o = ray.origin(), &d = ray.direction();
    RTCRay r{};
    r.org_x = static_cast<float>(o[0]), r.dir_x = static_cast<float>(d[0]);
    r.org_y = static_cast<float>(o[1]), r.dir_y = static_cast<float>(d[1]);
    r.org_z = static_cast<float>(o[2]), r.dir_z = static_cast<float>(d[2]);
    r.tfar = std::numeric_limits<float>::infinity();
    r.mask = ~0u;
    q.inverse[0] = 1 / r.dir_x, q.inverse[1] = 1 / r.dir_y, q.inverse[2] = 1 / r.dir_z;
    rtcOccluded1(scene_, &q, &r);
  }

private:
  struct query : RTCIntersectContext {
    std::vector<voxel_key>* found;
    float inverse[3];
  };

  static RTCDevice device() {
    static const RTCDevice one = rtcNewDevice("threads=1");
    return one;
  }

  static void bounds(const RTCBoundsFunctionArguments* a) {
    const auto& b = static_cast<const boxes*>(a->geometryUserPtr)->corners_[a->primID];
    *a->bounds_o = {b[0], b[1], b[2], 0, b[3], b[4], b[5], 0};
  }

  template <bool Tested> static void candidate(const RTCOccludedFunctionNArguments* a) {
    const auto* self = static_cast<const boxes*>(a->geometryUserPtr);
    const auto* q = static_cast<const query*>(a->context);
    if (!Tested ||
        on(*reinterpret_cast<const RTCRay*>(a->ray), q->inverse, self->corners_[a->primID]))
      q->found->push_back(self->keys_[a->primID]);
  }

  /// Slabs; rtcOccluded1 gives one ray.
  static bool on(const RTCRay& r, const float (&inverse)[3], const std::array<float, 6>& b) {
    const float x0 = (b[0] - r.org_x) * inverse[0], x1 = (b[3] - r.org_x) * inverse[0];
    const float y0 = (b[1] - r.org_y) * inverse[1], y1 = (b[4] - r.org_y) * inverse[1];
    const float z0 = (b[2] - r.org_z) * inverse[2], z1 = (b[5] - r.org_z) * inverse[2];
    const float in = std::max({std::min(x0, x1), std::min(y0, y1), std::min(z0, z1), r.tnear});
    const float out = std::min({std::max(x0, x1), std::max(y0, y1), std::max(z0, z1), r.tfar});
    return in <= out;
  }

  std::vector<std::array<float, 6>> corners_; ///< lowest and highest of each
  std::vector<voxel_key> keys_;
  RTCScene scene_;
};

} // namespace

#define GRAZE_PEER_EMBREE_BOXES(Library, robust, tested)                                           \
  template <> struct peer<Library>::structure : boxes {                                            \
    explicit structure(const voxel_grid& grid) : boxes(grid, robust, tested) {}                    \
  };                                                                                               \
  template <>                                                                                      \
  peer<Library>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}   \
  template <> peer<Library>::~peer() = default;                                                    \
  template <> void peer<Library>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {  \
    structure_->boxes::occupied(r, found);                                                         \
  }                                                                                                \
  template <> std::optional<octree::ray> peer<Library>::received(const octree::ray& r) const {     \
    return ray_if_any(single(r.origin()), single(r.direction()));                                  \
  }
GRAZE_PEER_EMBREE_BOXES(embree, false, false)
GRAZE_PEER_EMBREE_BOXES(embree_robust, true, false)
GRAZE_PEER_EMBREE_BOXES(embree_tested, false, true)
#undef GRAZE_PEER_EMBREE_BOXES

} // namespace graze::bench
