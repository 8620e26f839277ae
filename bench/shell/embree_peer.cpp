// Embree 3: the voxels as user geometry. The callback tests a box by slabs, in single precision as
// all of Embree is, records it, and never accepts a hit, so that the ray goes on: the fastest way
// to all boxes on a ray (one call a candidate, no hit structure written, no second geometry
// lookup).
// Medium build quality was no slower than high.
#include "peer.hpp"
#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>
#include <memory>

namespace graze::bench::shell {

namespace {

struct embree_scene {
  std::vector<std::array<float, 6>> boxes;
  std::vector<std::uint64_t> voxels;
  RTCDevice device = nullptr;
  RTCScene rtc = nullptr;
  ~embree_scene() {
    rtcReleaseScene(rtc);
    rtcReleaseDevice(device);
  }
};

struct context : RTCIntersectContext {
  findings* out;
  float inverse[3];
};

void bounds(const RTCBoundsFunctionArguments* a) {
  const auto& b = static_cast<const embree_scene*>(a->geometryUserPtr)->boxes[a->primID];
  a->bounds_o->lower_x = b[0], a->bounds_o->lower_y = b[1], a->bounds_o->lower_z = b[2];
  a->bounds_o->upper_x = b[3], a->bounds_o->upper_y = b[4], a->bounds_o->upper_z = b[5];
}

void occluded(const RTCOccludedFunctionNArguments* a) {
  const auto* s = static_cast<const embree_scene*>(a->geometryUserPtr);
  auto* c = static_cast<context*>(a->context);
  const auto* r = reinterpret_cast<const RTCRay*>(a->ray); // rtcOccluded1: N = 1
  const auto& b = s->boxes[a->primID];
  const float x0 = (b[0] - r->org_x) * c->inverse[0], x1 = (b[3] - r->org_x) * c->inverse[0];
  const float y0 = (b[1] - r->org_y) * c->inverse[1], y1 = (b[4] - r->org_y) * c->inverse[1];
  const float z0 = (b[2] - r->org_z) * c->inverse[2], z1 = (b[5] - r->org_z) * c->inverse[2];
  const float in = std::max({std::min(x0, x1), std::min(y0, y1), std::min(z0, z1), r->tnear});
  const float out = std::min({std::max(x0, x1), std::max(y0, y1), std::max(z0, z1), r->tfar});
  if (in <= out)
    c->out->voxels.push_back(s->voxels[a->primID]);
}

} // namespace

peer embree_peer(const scene& s) {
  auto e = std::make_shared<embree_scene>();
  const auto collect = [&](auto&& self, std::uint32_t node, const octree::cube& c,
                           int level) -> void {
    if (level == s.tree.level()) {
      e->boxes.push_back({static_cast<float>(c.lo[0]), static_cast<float>(c.lo[1]),
                          static_cast<float>(c.lo[2]), static_cast<float>(c.hi(0)),
                          static_cast<float>(c.hi(1)), static_cast<float>(c.hi(2))});
      e->voxels.push_back(packed(s.root, c));
      return;
    }
    for (unsigned i = 0; i < 8; ++i)
      if ((s.tree.child_mask(node, c, 0xff) >> i & 1) != 0)
        self(self, s.tree.child(node, i), c.child(i), level + 1);
  };
  collect(collect, s.tree.root(), s.tree.box(), 0);
  e->device = rtcNewDevice("threads=1");
  e->rtc = rtcNewScene(e->device);
  rtcSetSceneBuildQuality(e->rtc, RTC_BUILD_QUALITY_MEDIUM);
  RTCGeometry g = rtcNewGeometry(e->device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryBuildQuality(g, RTC_BUILD_QUALITY_MEDIUM);
  rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(e->boxes.size()));
  rtcSetGeometryUserData(g, e.get());
  rtcSetGeometryBoundsFunction(g, [](const RTCBoundsFunctionArguments* a) { bounds(a); }, nullptr);
  rtcSetGeometryOccludedFunction(g, occluded);
  rtcCommitGeometry(g);
  rtcAttachGeometry(e->rtc, g);
  rtcReleaseGeometry(g);
  rtcCommitScene(e->rtc);
  return {"embree3", [e, &s](std::size_t first, std::size_t last, findings& out) {
            context c;
            rtcInitIntersectContext(&c);
            c.out = &out;
            for (std::size_t i = first; i < last; ++i) {
              const std::size_t before = out.voxels.size();
              const octree::vec3 &o = s.rays[i].origin(), &d = s.rays[i].direction();
              RTCRay r{};
              r.org_x = static_cast<float>(o[0]), r.org_y = static_cast<float>(o[1]);
              r.org_z = static_cast<float>(o[2]), r.dir_x = static_cast<float>(d[0]);
              r.dir_y = static_cast<float>(d[1]), r.dir_z = static_cast<float>(d[2]);
              r.tfar = std::numeric_limits<float>::infinity();
              r.mask = 0xffffffff;
              c.inverse[0] = 1 / r.dir_x, c.inverse[1] = 1 / r.dir_y, c.inverse[2] = 1 / r.dir_z;
              rtcOccluded1(e->rtc, &c, &r);
              out.counts.push_back(static_cast<std::uint32_t>(out.voxels.size() - before));
            }
          }};
}

} // namespace graze::bench::shell
