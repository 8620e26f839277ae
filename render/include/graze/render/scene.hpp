#pragma once
/// Scenes: a surface, its domain, a camera, lights and materials, and nothing that the picture does
/// not need.
#include <cstdint>
#include <graze/expected.hpp>
#include <graze/octree/box.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree_formula.hpp>
#include <graze/render/camera.hpp>
#include <graze/render/proof.hpp>
#include <graze/render/secondary.hpp>
#include <graze/render/shading.hpp>
#include <graze/render/view.hpp>
#include <graze/support/status.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace graze::render {

/// The ray/surface work of one scene, whatever the type of its surface. Safe to be used
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
  /// What is proven of each ray and its end. As many of each.
  virtual void prove(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
                     std::span<proof> proofs) const = 0;
  /// Leaves of the octree in which the surface may be; 0 where there is none.
  virtual std::uint64_t octree_leaves() const = 0;
};

/// A part of the surface that has its own material.
struct object {
  std::string name;
  std::optional<octree::formula> formula; ///< none where the surface is built in
  material look;
};

/// What is made of the objects f_i <= 0: one of them, or a combination of other solids.
struct solid {
  enum class kind : std::uint8_t { single, unite, intersect, subtract };
  kind form = kind::single;
  std::size_t single = 0;   ///< index of the object
  std::vector<solid> parts; ///< two or more; of `subtract` the first, less the others
};

struct scene {
  std::string name;
  std::string built_in; ///< the compiled surface's name; empty where formulas are evaluated
  octree::box domain;   ///< the surface is cut off at its faces
  camera view;
  std::vector<light> lights;   ///< at most most_lights
  std::vector<object> objects; ///< at least one
  solid shape;
  colour background = default_background;
  std::vector<octree::parameter> set{}; ///< of the formulas, in order; each is used by one at least
  /// The picture has an alpha channel, 0 where no ray hit; `background` is what mirrors show.
  bool transparent = false;
  /// What is asked of the camera where it is to fit the surface; until then (settle_view) it fits the
  /// domain. None where `view` is all that is asked.
  std::optional<framing> fitted = framing{};
  /// Who has chosen `lights`: nobody, the scene, or they are a headlight, which goes with the eye.
  enum class lamps : std::uint8_t { usual, given, headlight };
  lamps lit = lamps::usual;
};
inline constexpr std::size_t most_lights = 64, most_objects = 1000;

/// How a ray's first hit is found.
enum class method : std::uint8_t {
  descent,   ///< down to the octants of level NL, the paper's way
  certified, ///< along the ray, to the precision of doubles; without octree and levels
};

/// Makes the octree, if the method has one, and the traversal. Refuses, with the reason, levels
/// outside of 1..53, and what with_surface (scene_surface.hpp) refuses.
expected<std::unique_ptr<caster>> prepare(const scene& s, int octree_level, int levels,
                                          method search = method::descent);

/// The text of the whole, of which f = 0 is the surface: min for a union, max for an intersection.
/// For a surface that is built in, what it is.
std::string formula_text(const scene& s);

/// One line on powers of which the formulas are made and which are not defined all over the domain,
/// though another spelling may be (formula::notes); empty if there is nothing to be said.
std::string note_on(const scene& s);

/// Which of the scene's objects the surface belongs to near `point`.
std::size_t object_at(const scene& s, const vec3& point);

/// The camera and the lights that show a domain: those of the six scenes, at the scale that fits,
/// about its middle.
camera fitting_camera(const octree::box& domain);
std::vector<light> fitting_lights(const octree::box& domain);

/// One light, at the eye.
std::vector<light> headlight(const camera& view);

/// A ball about the parts of the domain in which the surface may be: octants of its domain in which f
/// is not proven to have no zero, in halves of halves, the last 1/64 as long as the box that holds them.
/// Where there are none, or f could not be looked at, about the domain. A function of f and the domain.
ball surface_extent(const scene& s);

/// The camera as the scene and `asked`, which goes before, ask for: changed from the scene's own, or
/// fitted to `shown` where it has none, or without that to the surface. Where the camera turns and the scene has chosen no lights,
/// they become a headlight (scene::lit). Gives what orbits turn.
expected<framed_camera> settle_view(scene& s, const framing& asked,
                                    const std::optional<ball>& shown = {});

/// Whether something can be seen in a domain: it is not empty, and finite.
support::status check_domain(const octree::box& domain);

/// A scene for each surface that is built in (graze/octree/surfaces.hpp).
std::span<const scene> scenes();
/// nullptr where there is none of this name.
const scene* find_scene(std::string_view name);
/// "spheres, quartdef, ...".
std::string scene_names();

} // namespace graze::render
