/// Embree 3: the octants as user geometry, or as 12 triangles each, rays in float. Reported is every
/// primitive that Embree calls back for, which is its own test and no formula of ours.
///
/// robust: with RTC_SCENE_FLAG_ROBUST. tested: only those boxes that slabs in float find on the ray, as
/// a user's callback does.
#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>
#include <peers/library.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

/// The callbacks record the octant and never accept a hit, so that the ray goes on: the fastest way
/// to all boxes on a ray (no hit structure written, no second look at the geometry). Medium build
/// quality was no slower than high.
class scene : public structure {
public:
  scene(const occupied_octants& octants, bool robust) : scene_(rtcNewScene(device())) {
    for (const octant_index& at : octants.indices) {
      const vec3 lo = octants.corner(at, 0), hi = octants.corner(at, 1);
      boxes_.push_back({static_cast<float>(lo[0]), static_cast<float>(lo[1]),
                        static_cast<float>(lo[2]), static_cast<float>(hi[0]),
                        static_cast<float>(hi[1]), static_cast<float>(hi[2])});
      keys_.push_back(key_of(at));
    }
    rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
  }
  ~scene() override { rtcReleaseScene(scene_); }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    return ray_in_float(r);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    query q;
    rtcInitIntersectContext(&q);
    q.found = &found;
    const vec3 &o = r.origin(), &d = r.direction();
    RTCRay ray{};
    ray.org_x = static_cast<float>(o[0]), ray.dir_x = static_cast<float>(d[0]);
    ray.org_y = static_cast<float>(o[1]), ray.dir_y = static_cast<float>(d[1]);
    ray.org_z = static_cast<float>(o[2]), ray.dir_z = static_cast<float>(d[2]);
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    q.inverse[0] = 1 / ray.dir_x, q.inverse[1] = 1 / ray.dir_y, q.inverse[2] = 1 / ray.dir_z;
    rtcOccluded1(scene_, &q, &ray);
  }

protected:
  struct query : RTCIntersectContext {
    std::vector<octant_key>* found;
    float inverse[3];
  };

  static RTCDevice device() {
    static const RTCDevice shared = rtcNewDevice("threads=1");
    return shared;
  }

  void commit(RTCGeometry g) {
    rtcSetGeometryBuildQuality(g, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetGeometryUserData(g, this);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene_, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene_);
  }

  std::vector<std::array<float, 6>> boxes_; ///< lowest and highest corner of each
  std::vector<octant_key> keys_;
  RTCScene scene_;
};

template <bool Robust, bool Tested> class user_boxes final : public scene {
public:
  explicit user_boxes(const occupied_octants& octants) : scene(octants, Robust) {
    RTCGeometry g = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(boxes_.size()));
    rtcSetGeometryBoundsFunction(g, bounds, nullptr);
    rtcSetGeometryOccludedFunction(g, candidate);
    commit(g);
  }

private:
  static void bounds(const RTCBoundsFunctionArguments* a) {
    const auto& b = static_cast<const user_boxes*>(a->geometryUserPtr)->boxes_[a->primID];
    *a->bounds_o = {b[0], b[1], b[2], 0, b[3], b[4], b[5], 0};
  }

  static void candidate(const RTCOccludedFunctionNArguments* a) {
    const auto* self = static_cast<const user_boxes*>(a->geometryUserPtr);
    const auto* q = static_cast<const query*>(a->context);
    if (!Tested ||
        hits(*reinterpret_cast<const RTCRay*>(a->ray), q->inverse, self->boxes_[a->primID]))
      q->found->push_back(self->keys_[a->primID]);
  }

  /// Slabs; rtcOccluded1 gives one ray.
  static bool hits(const RTCRay& r, const float (&inverse)[3], const std::array<float, 6>& b) {
    const float x0 = (b[0] - r.org_x) * inverse[0], x1 = (b[3] - r.org_x) * inverse[0];
    const float y0 = (b[1] - r.org_y) * inverse[1], y1 = (b[4] - r.org_y) * inverse[1];
    const float z0 = (b[2] - r.org_z) * inverse[2], z1 = (b[5] - r.org_z) * inverse[2];
    // what becomes of a NaN, where the ray rests in a face's plane, depends on this order
    const float enter =
        std::max(std::max(std::max(r.tnear, std::min(x0, x1)), std::min(y0, y1)), std::min(z0, z1));
    const float leave =
        std::min(std::min(std::min(r.tfar, std::max(x0, x1)), std::max(y0, y1)), std::max(z0, z1));
    return enter <= leave;
  }
};

template <bool Robust> class triangles final : public scene {
public:
  explicit triangles(const occupied_octants& octants) : scene(octants, Robust) {
    // a corner by its bits x + 2y + 4z; faces of two triangles each
    constexpr unsigned corners[12][3] = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6},
                                         {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6},
                                         {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    RTCGeometry g = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t n = boxes_.size();
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
        g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 8 * n));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 12 * n));
    for (unsigned b = 0; b < n; ++b) {
      for (unsigned c = 0; c < 8; ++c)
        for (unsigned a = 0; a < 3; ++a)
          *vertex++ = boxes_[b][(c >> a & 1) * 3 + a];
      for (const auto& triangle : corners)
        for (const unsigned c : triangle)
          *index++ = 8 * b + c;
    }
    rtcSetGeometryOccludedFilterFunction(g, candidate);
    commit(g);
  }

  /// An octant once, whichever of its triangles are hit.
  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const auto before = static_cast<std::ptrdiff_t>(found.size());
    scene::visit(r, found);
    std::sort(found.begin() + before, found.end());
    found.erase(std::unique(found.begin() + before, found.end()), found.end());
  }

private:
  static void candidate(const RTCFilterFunctionNArguments* a) {
    const auto* self = static_cast<const triangles*>(a->geometryUserPtr);
    static_cast<const query*>(a->context)
        ->found->push_back(self->keys_[RTCHitN_primID(a->hit, a->N, 0) / 12]);
    a->valid[0] = 0;
  }
};

/// Null where a corner is no float.
template <class Scene> std::unique_ptr<structure> built_in_float(const occupied_octants& octants) {
  for (const octant_index& at : octants.indices)
    for (const double side : {0, 1})
      if (const vec3 corner = octants.corner(at, side); to_float(corner) != corner)
        return nullptr;
  return std::make_unique<Scene>(octants);
}

} // namespace

std::vector<variant> embree_variants() {
  return {
      {"embree-boxes", "crossed", timed::yes, "Embree", "Embree, boxes as user geometry (float)",
       built_in_float<user_boxes<false, false>>},
      {"embree-boxes-robust", "crossed", timed::yes, "Embree, robust",
       "the same, RTC_SCENE_FLAG_ROBUST", built_in_float<user_boxes<true, false>>},
      {"embree-boxes-tested", "crossed", timed::yes, "Embree, boxes tested",
       "the boxes that slabs in the callback find", built_in_float<user_boxes<false, true>>},
      {"embree-triangles", "crossed", timed::no, "Embree, triangles",
       "Embree, 12 triangles a voxel (float)", built_in_float<triangles<false>>},
      {"embree-triangles-robust", "crossed", timed::no, "Embree, triangles, robust",
       "the same, RTC_SCENE_FLAG_ROBUST", built_in_float<triangles<true>>},
  };
}

} // namespace graze::peers
