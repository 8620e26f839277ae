/// Embree 3: the voxels as user geometry, or as 12 triangles each. Reported is every primitive that
/// Embree calls back for, which is its own test and no formula of ours. It works in float.
///
///   graze-adapter-embree boxes|boxes-robust|boxes-tested|triangles|triangles-robust
///
/// robust: with RTC_SCENE_FLAG_ROBUST. tested: only those boxes that slabs in float find on the
/// ray, as a user's callback does.
#include "adapter.hpp"
#include <embree3/rtcore.h>
#include <limits>
#include <string_view>

namespace {

struct scene_data {
  std::vector<adapter::index3> voxels;
  std::vector<std::array<float, 6>> boxes; ///< lowest and highest corner of each
  std::vector<bool> hit;
};

void bounds(const RTCBoundsFunctionArguments* a) {
  const auto& box = static_cast<const scene_data*>(a->geometryUserPtr)->boxes[a->primID];
  *a->bounds_o = {box[0], box[1], box[2], 0, box[3], box[4], box[5], 0};
}

/// Notes the primitive and accepts no hit, so that the ray goes on to all of them.
void box_callback(const RTCOccludedFunctionNArguments* a) {
  static_cast<scene_data*>(a->geometryUserPtr)->hit[a->primID] = true;
}
void tested_callback(const RTCOccludedFunctionNArguments* a) {
  auto* data = static_cast<scene_data*>(a->geometryUserPtr);
  const auto& box = data->boxes[a->primID];
  const auto& ray = *reinterpret_cast<const RTCRay*>(a->ray); // rtcOccluded1: N = 1
  const float from[3] = {ray.org_x, ray.org_y, ray.org_z};
  const float to[3] = {ray.dir_x, ray.dir_y, ray.dir_z};
  float enter = ray.tnear, leave = ray.tfar;
  for (unsigned k = 0; k < 3; ++k) {
    const float inverse = 1 / to[k];
    const float one = (box[k] - from[k]) * inverse, other = (box[k + 3] - from[k]) * inverse;
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  if (enter <= leave)
    data->hit[a->primID] = true;
}
void triangle_callback(const RTCFilterFunctionNArguments* a) {
  static_cast<scene_data*>(a->geometryUserPtr)->hit[RTCHitN_primID(a->hit, a->N, 0) / 12] = true;
  a->valid[0] = 0;
}

RTCGeometry boxes_of(RTCDevice device, scene_data& data, bool tested) {
  RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(data.boxes.size()));
  rtcSetGeometryUserData(g, &data);
  rtcSetGeometryBoundsFunction(g, bounds, nullptr);
  rtcSetGeometryOccludedFunction(g, tested ? tested_callback : box_callback);
  return g;
}

RTCGeometry triangles_of(RTCDevice device, scene_data& data) {
  // a corner by its bits x + 2y + 4z; faces of two triangles each
  constexpr unsigned corners[12][3] = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6},
                                       {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6},
                                       {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
  RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t n = data.boxes.size();
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 8 * n));
  auto* triangle = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 12 * n));
  for (unsigned b = 0; b < n; ++b) {
    for (unsigned c = 0; c < 8; ++c)
      for (unsigned a = 0; a < 3; ++a)
        *vertex++ = data.boxes[b][(c >> a & 1) * 3 + a];
    for (const auto& of : corners)
      for (const unsigned c : of)
        *triangle++ = 8 * b + c;
  }
  rtcSetGeometryUserData(g, &data);
  rtcSetGeometryOccludedFilterFunction(g, triangle_callback);
  return g;
}

struct variant_asked {
  bool triangles, robust, tested;
};

void traverse(RTCDevice device, const variant_asked& variant, const adapter::request& r,
              adapter::answer& a) {
  const adapter::vec3 o = adapter::to_float(r.origin);
  const adapter::vec3 d = adapter::to_float(adapter::scaled(r.direction));
  if (!adapter::is_finite(o))
    return a.skip();
  scene_data data;
  for (const adapter::index3& voxel : r.voxels()) {
    const adapter::vec3 lo = r.corner(voxel, 0), hi = r.corner(voxel, 1);
    if (adapter::to_float(lo) != lo || adapter::to_float(hi) != hi)
      return a.skip();
    data.voxels.push_back(voxel);
    data.boxes.push_back({static_cast<float>(lo[0]), static_cast<float>(lo[1]),
                          static_cast<float>(lo[2]), static_cast<float>(hi[0]),
                          static_cast<float>(hi[1]), static_cast<float>(hi[2])});
  }
  data.hit.resize(data.boxes.size());

  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, variant.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  RTCGeometry g =
      variant.triangles ? triangles_of(device, data) : boxes_of(device, data, variant.tested);
  rtcCommitGeometry(g);
  rtcAttachGeometry(scene, g);
  rtcReleaseGeometry(g);
  rtcCommitScene(scene);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(o[0]), ray.dir_x = static_cast<float>(d[0]);
  ray.org_y = static_cast<float>(o[1]), ray.dir_y = static_cast<float>(d[1]);
  ray.org_z = static_cast<float>(o[2]), ray.dir_z = static_cast<float>(d[2]);
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0u;
  rtcOccluded1(scene, &context, &ray);
  rtcReleaseScene(scene);

  a.received(o, d);
  for (std::size_t i = 0; i < data.voxels.size(); ++i)
    if (data.hit[i])
      a.visit(data.voxels[i]);
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view name = argc > 1 ? argv[1] : "";
  const variant_asked variant{name.starts_with("triangles"), name.ends_with("-robust"),
                              name == "boxes-tested"};
  if (!variant.tested && name != std::string(variant.triangles ? "triangles" : "boxes") +
                                     (variant.robust ? "-robust" : "")) {
    std::fprintf(stderr, "usage: graze-adapter-embree "
                         "boxes|boxes-robust|boxes-tested|triangles|triangles-robust\n");
    return 2;
  }
  RTCDevice device = rtcNewDevice("threads=1");
  return adapter::serve("crossed", [&](const adapter::request& r, adapter::answer& a) {
    traverse(device, variant, r, a);
  });
}
