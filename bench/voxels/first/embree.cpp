// Embree: rtcIntersect1 over boxes as user geometry, whose callback tests slabs in float and keeps
// the nearest.
#include "first_hits.hpp"
#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>

namespace graze::bench {
namespace {

class boxes {
public:
  boxes(const occupied_octants& octants, bool robust)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    for (const peers::octant_index& at : octants.indices) {
      const octree::vec3 lo = octants.corner(at, 0), hi = octants.corner(at, 1);
      boxes_.push_back({static_cast<float>(lo[0]), static_cast<float>(lo[1]),
                        static_cast<float>(lo[2]), static_cast<float>(hi[0]),
                        static_cast<float>(hi[1]), static_cast<float>(hi[2])});
      keys_.push_back(peers::key_of(at));
    }
    rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(boxes_.size()));
    rtcSetGeometryUserData(g, this);
    rtcSetGeometryBoundsFunction(g, bounds, nullptr);
    rtcSetGeometryIntersectFunction(g, intersect);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene_, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene_);
  }
  ~boxes() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  boxes(const boxes&) = delete;
  boxes& operator=(const boxes&) = delete;

  octant_key first(const octree::ray& r) const {
    query q;
    rtcInitIntersectContext(&q);
    const auto &o = r.origin(), &d = r.direction();
    RTCRayHit h{};
    h.ray.org_x = static_cast<float>(o[0]), h.ray.dir_x = static_cast<float>(d[0]);
    h.ray.org_y = static_cast<float>(o[1]), h.ray.dir_y = static_cast<float>(d[1]);
    h.ray.org_z = static_cast<float>(o[2]), h.ray.dir_z = static_cast<float>(d[2]);
    h.ray.tfar = std::numeric_limits<float>::infinity();
    h.ray.mask = ~0u;
    h.hit.geomID = h.hit.primID = RTC_INVALID_GEOMETRY_ID;
    q.inverse[0] = 1 / h.ray.dir_x, q.inverse[1] = 1 / h.ray.dir_y, q.inverse[2] = 1 / h.ray.dir_z;
    rtcIntersect1(scene_, &q, &h);
    return h.hit.geomID == RTC_INVALID_GEOMETRY_ID ? no_octant : keys_[h.hit.primID];
  }

private:
  struct query : RTCIntersectContext {
    float inverse[3];
  };
  static void bounds(const RTCBoundsFunctionArguments* a) {
    const auto& b = static_cast<const boxes*>(a->geometryUserPtr)->boxes_[a->primID];
    *a->bounds_o = {b[0], b[1], b[2], 0, b[3], b[4], b[5], 0};
  }
  static void intersect(const RTCIntersectFunctionNArguments* a) {
    if (a->valid[0] == 0)
      return;
    const auto* self = static_cast<const boxes*>(a->geometryUserPtr);
    const auto* q = static_cast<const query*>(a->context);
    auto& h = *reinterpret_cast<RTCRayHit*>(a->rayhit);
    const RTCRay& r = h.ray;
    const auto& b = self->boxes_[a->primID];
    const float x0 = (b[0] - r.org_x) * q->inverse[0], x1 = (b[3] - r.org_x) * q->inverse[0];
    const float y0 = (b[1] - r.org_y) * q->inverse[1], y1 = (b[4] - r.org_y) * q->inverse[1];
    const float z0 = (b[2] - r.org_z) * q->inverse[2], z1 = (b[5] - r.org_z) * q->inverse[2];
    const float enter =
        std::max(std::max(std::max(r.tnear, std::min(x0, x1)), std::min(y0, y1)), std::min(z0, z1));
    const float leave =
        std::min(std::min(std::min(r.tfar, std::max(x0, x1)), std::max(y0, y1)), std::max(z0, z1));
    if (!(enter <= leave) || !(enter < r.tfar))
      return;
    h.ray.tfar = enter;
    h.hit.geomID = a->geomID;
    h.hit.primID = a->primID;
  }

  std::vector<std::array<float, 6>> boxes_;
  std::vector<octant_key> keys_;
  RTCDevice device_;
  RTCScene scene_;
};

} // namespace

std::vector<first_hit_contestant> embree_first_hits(const occupied_octants& octants) {
  std::vector<first_hit_contestant> all;
  for (const bool robust : {true, false}) {
    const auto scene = std::make_shared<const boxes>(octants, robust);
    all.push_back({robust ? "Embree rtcIntersect1, robust" : "Embree rtcIntersect1", "library",
                   one_by_one([scene](const octree::ray& r) { return scene->first(r); })});
  }
  return all;
}

} // namespace graze::bench
