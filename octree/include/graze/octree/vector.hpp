#pragma once
/// Points and directions: three doubles, indexed by axis 0, 1, 2.
#include <array>

namespace graze::octree {

using vec3 = std::array<double, 3>;

} // namespace graze::octree
