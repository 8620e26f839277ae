// Compiled once, with the library's own flags: a header would meet the user's -ffp-contract.
#include <graze/render/camera.hpp>

#include <algorithm>
#include <cmath>

namespace graze::render {

camera camera::standard(double scale) {
  return {{scale * 3, scale * 2, scale * 6},
          {-3, -2, -6},
          {0x1.cap+1, 0, -0x1.cap+0},             // 3.578125 = 229/64, 1.7890625 = 229/128
          {-0x1.06p-1, 0x1.eaap+1, -0x1.05cp+0}}; // 131/256, 3925/1024, 1047/1024
}

support::status camera::check() const {
  const auto size = [](const vec3& v) {
    return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  };
  for (const vec3& v : {centre, right, up})
    if (!(size(v) >= 1e-100 && size(v) <= 1e100))
      return unexpected{"centre, right and up must be finite and not 0"};
  if (!(size(eye) <= 1e100))
    return unexpected{"eye must be finite"};
  const auto normalized = [&](const vec3& v) -> vec3 {
    return {v[0] / size(v), v[1] / size(v), v[2] / size(v)};
  };
  const vec3 c = normalized(centre), r = normalized(right), u = normalized(up);
  const double volume = c[0] * (r[1] * u[2] - r[2] * u[1]) + c[1] * (r[2] * u[0] - r[0] * u[2]) +
                        c[2] * (r[0] * u[1] - r[1] * u[0]);
  if (!(std::fabs(volume) > 1e-6))
    return unexpected{"centre, right and up must not lie in one plane"};
  // the direction's part off the plane of right and up is then far above its rounding
  if (!(std::max(size(right), size(up)) < 1e6 * size(centre)))
    return unexpected{"right and up must be less than 1e6 times as long as centre"};
  return {};
}

octree::ray camera::ray_through(int column, int row, int width, int height) const {
  const auto side = static_cast<double>(2 * std::min(width, height));
  const double u = static_cast<double>(2 * column + 1 - width) / side;
  const double v = static_cast<double>(height - 1 - 2 * row) / side;
  vec3 direction;
  for (std::size_t a = 0; a < 3; ++a) {
    const double across = u * right[a];
    const double upward = v * up[a];
    direction[a] = (centre[a] + across) + upward;
  }
  return *octree::ray::make(eye, direction); // finite and not 0: see the header
}

} // namespace graze::render
