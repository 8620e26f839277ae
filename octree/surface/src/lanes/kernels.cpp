// The kernels of the surfaces that are built in, compiled for each path.
#include "tables.hpp"
#include <graze/octree/asterisk_eight.hpp>
#include <graze/octree/lane_kernels_of_path.hpp>

namespace graze::octree::detail {
namespace {

template <class Path, class... F>
consteval built_in_kernels make_kernels(const std::tuple<built_in_surface<F>...>&) {
  return {make_lane_kernels<Path, F>()...};
}

} // namespace

constinit const built_in_kernels
    GRAZE_ON_PATH(surface_kernels) = make_kernels<batch::this_path>(built_in_surfaces);

} // namespace graze::octree::detail
