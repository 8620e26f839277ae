#pragma once
/// Scenes: a surface, its domain, a camera, lights and materials, and nothing that the picture does
/// not need.
#include <functional>
#include <graze/expected.hpp>
#include <graze/octree/box.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/render/camera.hpp>
#include <graze/render/secondary.hpp>
#include <graze/render/shading.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace graze::render {

/// The ray/surface work of one scene at one NL, whatever the type of its surface. Safe to be used
/// by several threads at once. The virtual call is once a batch of rays.
class caster {
public:
  virtual ~caster() = default;
  /// The first intersection of each ray with the surface, in the ray's own t; as many hits as
  /// rays. Adds to `counts`.
  virtual void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                          octree::traversal_counts* counts) const = 0;
  /// The surface's gradient near `point`, rounded to nearest; for light only. 0 at singular points.
  virtual vec3 gradient(const vec3& point) const = 0;
  /// Where rays leave the hits that are proven (secondary.hpp); the others are passed over. As many
  /// departures as hits.
  virtual void depart(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
                      std::span<departure> departures) const = 0;
  /// Which of the scene's objects the surface belongs to near `point`.
  virtual std::size_t object_at(const vec3& point) const = 0;
  /// Leaves of the octree in which the surface may be.
  virtual std::uint64_t octree_leaves() const = 0;
};

/// A part of the surface that has its own material.
struct object {
  std::string name;
  material look;
};

struct scene {
  std::string name;
  std::string formula;
  octree::box domain; ///< the surface is cut off at its faces
  camera view;
  std::vector<light> lights;
  std::vector<object> objects; ///< at least one
  colour background = default_background;
  /// Makes the octree and the traversal; refuses levels outside of 1..53 with the reason.
  std::function<expected<std::unique_ptr<caster>>(const scene&, int octree_level, int levels)>
      prepare;
};

/// The scenes of DESIGN's table that are built in.
std::span<const scene> scenes();
/// nullptr where there is none of this name.
const scene* find_scene(std::string_view name);
/// "spheres, quartdef, ...".
std::string scene_names();

} // namespace graze::render
