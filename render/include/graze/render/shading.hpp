#pragma once
/// Light. Colours are linear, in Rec. 709 primaries.
#include <array>
#include <cmath>
#include <graze/expected.hpp>
#include <graze/octree/vector.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace graze::render {

using octree::vec3;
using colour = std::array<double, 3>;

/// A point light of constant strength: it does not weaken with distance.
struct light {
  vec3 position;
  double intensity;
};

/// Lambert and a little Blinn-Phong:
///   ambient B + sum over lights of I (diffuse B max(0, n.l) + specular max(0, n.h)^32)
/// with B the body's colour, l towards the light, h halfway between l and the eye.
struct material {
  colour body;
  double ambient = 0.15;
  double diffuse = 0.9;
  double specular = 0.25;
  double reflection = 0.2; ///< the part of the colour that the reflected ray brings (tracing only)
  /// Instead of `body` where the surface is seen from f < 0: where f's gradient, rounded, points away
  /// from the eye.
  std::optional<colour> inside{};
};

/// Of a surface that names no colour.
inline constexpr colour default_body = {0.45, 0.40, 0.72};
/// The names of colours that are known, #rrggbb or #rgb (sRGB, made linear), or r,g,b (linear, 0 to
/// 100 as in scene files).
expected<colour> colour_from(std::string_view text);

/// What no ray hit.
inline constexpr colour default_background = {0.84, 0.87, 0.91};
/// A pixel whose ray could be neither shown to hit nor to miss.
inline constexpr colour undecided_colour = {1, 0, 1};
/// Where it is asked for: a pixel whose ray meets no root, but a pole, a jump or a gap.
inline constexpr colour gap_colour = {1, 0.5, 0};
/// A pixel whose ray was not cast, since the picture was interrupted.
inline constexpr colour unfinished_colour = {0, 0, 0};

/// The six scenes' two lights (docs/definitions.md) at scale S.
inline std::vector<light> standard_lights(double scale) {
  return {light{{scale * 10, scale * 12, scale * 4}, 0.8},
          light{{scale * -8, scale * 6, scale * 10}, 0.5}};
}

namespace detail {
inline double dot(const vec3& a, const vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// v / |v|, or `otherwise` where v is 0 or not finite (a surface's singular point has no normal).
inline vec3 unit(const vec3& v, const vec3& otherwise) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 0) || !std::isfinite(length))
    return otherwise;
  return {v[0] / length, v[1] / length, v[2] / length};
}
} // namespace detail

/// The unit vector normal to the surface on the side from which `direction` comes; against
/// `direction` where the gradient is 0.
inline vec3 facing_normal(const vec3& gradient, const vec3& direction) {
  const vec3 back = detail::unit({-direction[0], -direction[1], -direction[2]}, {0, 0, 1});
  vec3 normal = detail::unit(gradient, back);
  if (detail::dot(normal, back) < 0)
    for (double& n : normal)
      n = -n;
  return normal;
}

/// `direction` mirrored in the plane normal to the unit vector.
inline vec3 reflected(const vec3& direction, const vec3& normal) {
  const double twice = 2 * detail::dot(direction, normal);
  return {direction[0] - twice * normal[0], direction[1] - twice * normal[1],
          direction[2] - twice * normal[2]};
}

/// The colour at `point` of a body of that colour, with the unit normal of the side that is seen, along `direction` (any
/// length). Lights for which `shadowed(index)` is true do not count. Not clamped to 1.
template <class Lights, class Shadowed>
colour shade(const material& m, const colour& body, const vec3& point, const vec3& normal,
             const vec3& direction, const Lights& lights, const Shadowed& shadowed) {
  const vec3 to_eye = detail::unit({-direction[0], -direction[1], -direction[2]}, {0, 0, 1});
  colour result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = m.ambient * body[c];
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const light& lamp = lights[i];
    const vec3 to_light = detail::unit(
        {lamp.position[0] - point[0], lamp.position[1] - point[1], lamp.position[2] - point[2]},
        normal);
    const double lambert = detail::dot(normal, to_light);
    if (!(lambert > 0) || shadowed(i))
      continue;
    const vec3 halfway = detail::unit(
        {to_light[0] + to_eye[0], to_light[1] + to_eye[1], to_light[2] + to_eye[2]}, normal);
    double shine = std::fmax(0.0, detail::dot(normal, halfway));
    for (int square = 0; square < 5; ++square)
      shine *= shine; // to the 32nd, without a libm
    for (std::size_t c = 0; c < 3; ++c)
      result[c] += lamp.intensity * (m.diffuse * body[c] * lambert + m.specular * shine);
  }
  return result;
}

} // namespace graze::render
