#pragma once
/// The scenes of docs/definitions.md whose surfaces are algebraic.
#include <graze/octree/box.hpp>
#include <graze/octree/ray.hpp>
#include <graze/octree/surfaces.hpp>
#include <type_traits>

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
template <class F>
inline constexpr scene<F> scene_of{
    {}, graze::octree::built_in<F>.scale, graze::octree::built_in<F>.reach};

/// Calls check(scene) for each surface that is built in and has exact roots along lines.
template <class Check> void for_each(Check check) {
  graze::octree::for_each_built_in([&]<class F>(const graze::octree::built_in_surface<F>&) {
    if constexpr (graze::octree::is_algebraic<F>())
      check(scene_of<F>);
  });
}
/// The same but for the spheres, whose polynomials have more zeros than the least of them, seen from
/// inside.
template <class Check> void for_each_from_inside(Check check) {
  for_each([&](const auto& scene) {
    if constexpr (!std::is_same_v<decltype(scene.surface), graze::octree::spheres>)
      check(scene);
  });
}
} // namespace scenes
