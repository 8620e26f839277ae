#pragma once
/// What casters have in common, whatever finds their first hits.
#include <algorithm>
#include <graze/octree/lane_kernels.hpp>
#include <graze/render/scene.hpp>

namespace graze::render {

expected<std::unique_ptr<caster>> prepare_built_in(const scene& s, int octree_level, int levels);

/// A secondary ray that would have to begin further away from its hit is not cast.
inline double longest_shift(const octree::box& domain) {
  double side = 0;
  for (std::size_t a = 0; a < 3; ++a)
    side = std::max(side, domain.hi[a] - domain.lo[a]);
  return 0x1p-10 * side;
}

template <octree::Surface F> class surface_caster : public caster {
public:
  surface_caster(const F& f, const octree::box& domain)
      : f_(f), domain_(domain), longest_(longest_shift(domain)) {}

  vec3 gradient(const vec3& point) const override { return octree::normal(f_, point); }
  void depart(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
              std::span<departure> departures) const override {
    using backend = octree::kernel_backend;
    [[maybe_unused]] const backend::scope scope;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i].outcome == octree::verdict::hit)
        departures[i] = render::depart<F, backend>(f_, domain_, rays[i], hits[i], longest_);
  }
  std::size_t object_at(const vec3&) const override { return 0; }

protected:
  const F f_;
  const octree::box domain_;

private:
  const double longest_;
};

} // namespace graze::render
