/// Embree 3: the octants as user geometry, an octant a primitive. What is reported is each
/// primitive whose callback Embree calls: its own test of the bounds, and no formula of ours. Its
/// rays and boxes are in single precision; boxes are exact to level 23.
#include "../../../bench/peers/rounded_ray.hpp"
#include "libraries.hpp"
#include <embree3/rtcore.h>
#include <limits>

namespace graze::fuzz {

namespace {

struct context : RTCIntersectContext {
  visited* out;
};

class embree final : public traversal {
public:
  embree(std::string_view name, RTCSceneFlags flags) : name_(name), flags_(flags) {}
  ~embree() override { rtcReleaseDevice(device_); }
  embree(const embree&) = delete;
  embree& operator=(const embree&) = delete;

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }

  void visit(const trial& t, visited& out) override {
    const vec3 o = bench::single(t.origin), d = bench::single(t.direction);
    voxels_.clear();
    for (voxel_set left = t.all(); left != 0; left &= left - 1)
      voxels_.push_back(static_cast<voxel>(std::countr_zero(left)));
    if (!bench::ray_if_any(o, d) || !fits(t))
      return out.decline();
    out.receive({o, d});
    trial_ = &t;

    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, flags_);
    RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(voxels_.size()));
    rtcSetGeometryUserData(g, this);
    rtcSetGeometryBoundsFunction(g, bounds, nullptr);
    rtcSetGeometryOccludedFunction(g, occluded);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene);

    context c;
    rtcInitIntersectContext(&c);
    c.out = &out;
    RTCRay r{};
    r.org_x = static_cast<float>(o[0]), r.org_y = static_cast<float>(o[1]);
    r.org_z = static_cast<float>(o[2]), r.dir_x = static_cast<float>(d[0]);
    r.dir_y = static_cast<float>(d[1]), r.dir_z = static_cast<float>(d[2]);
    r.tfar = std::numeric_limits<float>::infinity();
    r.mask = 0xffffffff;
    rtcOccluded1(scene, &c, &r);
    rtcReleaseScene(scene);
  }

private:
  static bool fits(const trial& t) {
    for (int a = 0; a < 3; ++a)
      for (unsigned k = 0; k <= t.extent[static_cast<unsigned>(a)]; ++k)
        if (bench::single(t.plane(a, k)) != t.plane(a, k))
          return false;
    return true;
  }

  static void bounds(const RTCBoundsFunctionArguments* a) {
    const auto* self = static_cast<const embree*>(a->geometryUserPtr);
    const cube box = self->trial_->octant(self->voxels_[a->primID]);
    RTCBounds& b = *a->bounds_o;
    b.lower_x = static_cast<float>(box.lo[0]), b.upper_x = static_cast<float>(box.hi(0));
    b.lower_y = static_cast<float>(box.lo[1]), b.upper_y = static_cast<float>(box.hi(1));
    b.lower_z = static_cast<float>(box.lo[2]), b.upper_z = static_cast<float>(box.hi(2));
  }

  /// Accepts no hit, so that the ray goes on to all boxes.
  static void occluded(const RTCOccludedFunctionNArguments* a) {
    const auto* self = static_cast<const embree*>(a->geometryUserPtr);
    static_cast<context*>(a->context)->out->push(self->voxels_[a->primID]);
  }

  std::string_view name_;
  RTCSceneFlags flags_;
  RTCDevice device_ = rtcNewDevice("threads=1");
  std::vector<voxel> voxels_;
  const trial* trial_ = nullptr;
};

} // namespace

std::unique_ptr<traversal> make_embree() {
  return std::make_unique<embree>("embree", RTC_SCENE_FLAG_NONE);
}
std::unique_ptr<traversal> make_embree_robust() {
  return std::make_unique<embree>("embree-robust", RTC_SCENE_FLAG_ROBUST);
}

} // namespace graze::fuzz
