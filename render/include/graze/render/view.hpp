#pragma once
/// Cameras in the words of people: where the eye is, at what it looks, how much of it fits.
#include <graze/octree/box.hpp>
#include <graze/render/camera.hpp>
#include <optional>
#include <string_view>

namespace graze::render {

/// What is asked of a camera; what is not is taken from another camera, or fits what is shown. Angles
/// in degrees, lengths in scene length. Directions are about `up`: azimuth 0 is the axis after that to
/// which up is nearest (x, y, z, x: for up = z it is x, for up = y it is z), 90 a quarter turn of the
/// right hand further; elevation 90 is up.
struct framing {
  std::optional<vec3> eye, look_at, up;
  std::optional<double> azimuth, elevation;
  std::optional<double> fov;  ///< across the picture's shorter side
  std::optional<double> zoom; ///< divides the width of what is seen

  [[nodiscard]] bool empty() const { return *this == framing{}; }
  /// The camera looks from somewhere else, or to somewhere else, than it would.
  [[nodiscard]] bool turns() const { return eye || look_at || up || azimuth || elevation; }
  /// Each is finite and within its range, and no two say the same; or the reason, with the way out.
  [[nodiscard]] support::status check() const;
  /// This, and of `other` what this does not ask for and does not contradict.
  [[nodiscard]] framing over(const framing& other) const;
  friend bool operator==(const framing&, const framing&) = default;
};

/// A camera, at what it looks, and about which axis, of length 1, its azimuth turns.
struct framed_camera {
  camera view;
  vec3 look_at, axis;
};

/// What is to be seen.
struct ball {
  vec3 middle;
  double radius; ///< greater than 0
};
/// The smallest about the box's middle, but for rounding.
ball ball_about(const octree::box& b);
/// The smallest about both, but for rounding.
ball ball_about(const ball& a, const ball& b);

/// The camera that shows the ball, as asked for. Without more: from the direction of the six scenes'
/// camera, azimuth 26.57 and elevation 16.60 about y, looking at the middle, with their angle, from as
/// far as the ball fits, seen from where `look_at` is. Where the eye is given, the angle fits: at most
/// 120 degrees. Refuses what check() refuses, an eye at look_at, and up along the view if it is given.
expected<framed_camera> frame(const framing& asked, const ball& shown);

/// `from`, changed as asked for. It looks at the point of its middle ray that is nearest to `middle`, or
/// at eye + centre where that is behind it. Without more: its direction, this point, its width there.
/// `fov` moves the eye, so that this width stays, unless the eye is given; zoom alone changes nothing
/// but right and up. Its axis is the coordinate axis to which its up is nearest.
expected<framed_camera> frame(const framing& asked, const camera& from, const vec3& middle);

/// Turned by degrees of the right hand about the axis through look_at. 0 degrees: the same camera.
/// Quarter turns about a coordinate axis permute coordinates, exactly but for sums with look_at.
camera turned(const framed_camera& from, double degrees);

/// "x,y,z", finite; or for directions also "x", "y", "z", "-x", "-y", "-z".
expected<vec3> vector_from(std::string_view text);
expected<vec3> direction_from(std::string_view text);

} // namespace graze::render
