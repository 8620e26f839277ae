// Compiled once, with the library's own flags: a header would meet the user's -ffp-contract.
#include <graze/render/camera.hpp>

#include <algorithm>

namespace graze::render {

camera camera::standard(double scale) {
  return {{scale * 3, scale * 2, scale * 6},
          {-3, -2, -6},
          {0x1.cap+1, 0, -0x1.cap+0},             // 3.578125 = 229/64, 1.7890625 = 229/128
          {-0x1.06p-1, 0x1.eaap+1, -0x1.05cp+0}}; // 131/256, 3925/1024, 1047/1024
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
