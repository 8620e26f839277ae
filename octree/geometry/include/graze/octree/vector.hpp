#pragma once
/// Points and directions: three doubles, indexed by axis 0, 1, 2.
#include <graze/needs_cxx20.hpp>

#include <array>

namespace graze::octree {

using vec3 = std::array<double, 3>;

} // namespace graze::octree
