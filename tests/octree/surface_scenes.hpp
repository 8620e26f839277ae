#pragma once
/// The four polynomial scenes of docs/definitions.md: formula, camera scale and domain.
#include <graze/octree/box.hpp>
#include <graze/octree/ray.hpp>
#include <graze/octree/surfaces.hpp>

namespace scenes {
template <class F> struct scene {
  F surface;
  double scale, reach;
  [[nodiscard]] graze::octree::box domain() const {
    return {{-reach, -reach, -reach}, {reach, reach, reach}};
  }
  /// The camera ray through the middle of pixel (i, j) of 512 x 512.
  [[nodiscard]] graze::octree::ray pixel(int i, int j) const {
    const double u = (i + 0.5) / 512 - 0.5, v = 0.5 - (j + 0.5) / 512;
    return *graze::octree::ray::make({3 * scale, 2 * scale, 6 * scale},
                                     {-3 + u * 3.578125 + v * -0.51171875, -2 + v * 3.8330078125,
                                      -6 + u * -1.7890625 + v * -1.0224609375});
  }
};
inline constexpr scene<graze::octree::spheres> spheres{{}, 1.5, 2.5};
inline constexpr scene<graze::octree::quartdef> quartdef{{}, 1.125, 1.5};
inline constexpr scene<graze::octree::tanglecube> tanglecube{{}, 2, 2.5};
inline constexpr scene<graze::octree::holesrot> holesrot{{}, 2, 2};

/// Calls check(scene) for each of the four.
template <class Check> void for_each(Check check) {
  check(spheres);
  check(quartdef);
  check(tanglecube);
  check(holesrot);
}
} // namespace scenes
