#include <graze/render/view.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <graze/render/scene_text.hpp>
#include <graze/render/shading.hpp>
#include <numbers>

namespace graze::render {
namespace {

using detail::dot;

constexpr double farthest = 1e90;           // as scene files
constexpr double usual_half_width = 2 / 7.; // of the six scenes' picture, at distance 1

vec3 sum(const vec3& a, double s, const vec3& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
vec3 times(double s, const vec3& v) { return {s * v[0], s * v[1], s * v[2]}; }
vec3 cross(const vec3& a, const vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double greatest(const vec3& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}
/// A power of two that makes the greatest component 1 to 2. Of a vector that is not 0.
double towards_1(const vec3& v) { return std::ldexp(1.0, -std::ilogb(greatest(v))); }
double length(const vec3& v) {
  if (greatest(v) == 0)
    return 0;
  const double scale = towards_1(v);
  const vec3 near_1 = times(scale, v);
  return std::sqrt(dot(near_1, near_1)) / scale;
}
/// Of a vector that is not 0.
vec3 unit(const vec3& v) {
  const vec3 near_1 = times(towards_1(v), v);
  return times(1 / std::sqrt(dot(near_1, near_1)), near_1);
}
std::size_t steepest(const vec3& v) {
  std::size_t a = 0;
  for (const std::size_t b : {1u, 2u})
    if (std::fabs(v[b]) > std::fabs(v[a]))
      a = b;
  return a;
}
vec3 along(std::size_t axis, double to = 1) {
  vec3 v{};
  v[axis % 3] = to;
  return v;
}

/// The cosine and the sine of an angle; exact at quarter turns.
struct turn {
  double cosine, sine;
  static turn of(double degrees) {
    int quarters = 0;
    const double rest = std::remquo(degrees, 90.0, &quarters) * (std::numbers::pi / 180);
    const double c = std::cos(rest), s = std::sin(rest);
    switch (quarters & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
    }
  }
};
double degrees_of(double radians) { return radians * (180 / std::numbers::pi); }
double half_width_of(double fov) { return std::tan(fov / 2 * (std::numbers::pi / 180)); }

/// The directions of azimuth 0 and 90 about an axis of length 1.
struct horizon {
  vec3 ahead, aside;
  explicit horizon(const vec3& axis) {
    const vec3 next = along(steepest(axis) + 1);
    ahead = unit(sum(next, -dot(next, axis), axis));
    aside = cross(axis, ahead);
  }
};

/// Of length 1, at right angles: to the eye, and to the picture's right and top.
struct orientation {
  vec3 back, right, up;
};

orientation oriented(const vec3& axis, double azimuth, double elevation) {
  const horizon h(axis);
  const turn a = turn::of(azimuth), e = turn::of(elevation);
  const vec3 outward = sum(times(a.cosine, h.ahead), a.sine, h.aside);
  return {sum(times(e.cosine, outward), e.sine, axis),
          sum(times(a.cosine, h.aside), -a.sine, h.ahead),
          sum(times(e.cosine, axis), -e.sine, outward)};
}

/// Nothing where `back` is along the axis.
std::optional<orientation> oriented(const vec3& axis, const vec3& back) {
  const vec3 right = cross(axis, back);
  if (!(length(right) > 1e-6))
    return std::nullopt;
  return orientation{back, unit(right), unit(cross(back, right))};
}

camera placed(const vec3& eye, const orientation& to, double distance, double half_width) {
  return {eye, times(-distance, to.back), times(2 * distance * half_width, to.right),
          times(2 * distance * half_width, to.up)};
}

/// What a camera is where nothing is asked of it.
struct stance {
  vec3 look_at, axis;
  double azimuth, elevation;
  /// tan of half the angle, for an eye at this place; and how far away it is, for such an angle and
  /// this point.
  std::function<double(const vec3& eye)> half_width;
  std::function<double(double half_width, const vec3& look_at)> distance;
};

expected<framed_camera> frame_from(const framing& asked, const stance& usual) {
  if (const support::status may = asked.check(); !may)
    return unexpected{may.reason()};
  const vec3 look_at = asked.look_at.value_or(usual.look_at);
  const double zoom = asked.zoom.value_or(1);
  framed_camera made{{}, look_at, asked.up ? unit(*asked.up) : usual.axis};
  if (asked.eye) {
    const vec3 offset = sum(*asked.eye, -1, look_at);
    if (!(greatest(offset) >= 1 / farthest))
      return unexpected{"the eye is at the point at which it looks: move one of them"};
    const vec3 back = unit(offset);
    auto to = oriented(made.axis, back);
    if (!to && asked.up)
      return unexpected{"up is along the view: give another axis, such as " +
                        std::string(1, "yzx"[steepest(*asked.up)])};
    if (!to) {
      made.axis = along(steepest(made.axis) + 1);
      to = oriented(made.axis, back);
    }
    const double half = asked.fov ? half_width_of(*asked.fov) : usual.half_width(*asked.eye);
    made.view = placed(*asked.eye, *to, length(offset), half / zoom);
    made.view.centre = times(-1, offset);
  } else {
    const orientation to = oriented(made.axis, asked.azimuth.value_or(usual.azimuth),
                                    asked.elevation.value_or(usual.elevation));
    const double half = asked.fov ? half_width_of(*asked.fov) : usual.half_width(look_at);
    const double distance = usual.distance(half, look_at);
    made.view = placed(sum(look_at, distance, to.back), to, distance, half / zoom);
  }
  if (const support::status may = made.view.check(); !may)
    return unexpected{"the view is out of reach: " + may.reason()};
  return made;
}

} // namespace

support::status framing::check() const {
  const auto within = [](const char* name, const std::optional<double>& x, double least,
                         double most) -> support::status {
    if (x && !(*x >= least && *x <= most))
      return unexpected{fmt::format("{} must be {} to {}, not {}", name, least, most, *x)};
    return {};
  };
  for (const support::status& may :
       {within("azimuth", azimuth, -1e6, 1e6), within("elevation", elevation, -90, 90),
        within("fov", fov, 0.001, 170), within("zoom", zoom, 0.001, 1e6)})
    if (!may)
      return may;
  for (const auto& [name, v] : {std::pair{"eye", eye}, {"look-at", look_at}, {"up", up}})
    if (v && !(greatest(*v) <= farthest && !std::isnan((*v)[0] + (*v)[1] + (*v)[2])))
      return unexpected{fmt::format("{} must be finite, and within {}", name, farthest)};
  if (up && !(greatest(*up) >= 1 / farthest))
    return unexpected{"up must not be 0: it is a direction, such as 0,0,1 or z"};
  if (eye && (azimuth || elevation))
    return unexpected{
        "eye and azimuth or elevation both say where the eye is: leave out one of them"};
  return {};
}

framing framing::over(const framing& other) const {
  framing both = *this;
  const auto take = [](auto& to, const auto& from) {
    if (!to)
      to = from;
  };
  if (!azimuth && !elevation)
    take(both.eye, other.eye);
  if (!both.eye) {
    take(both.azimuth, other.azimuth);
    take(both.elevation, other.elevation);
  }
  take(both.look_at, other.look_at);
  take(both.up, other.up);
  take(both.fov, other.fov);
  take(both.zoom, other.zoom);
  return both;
}

ball ball_about(const octree::box& b) {
  ball r{};
  vec3 half;
  for (std::size_t a = 0; a < 3; ++a) {
    r.middle[a] = b.lo[a] / 2 + b.hi[a] / 2;
    half[a] = b.hi[a] / 2 - b.lo[a] / 2;
  }
  r.radius = length(half);
  return r;
}

ball ball_about(const ball& a, const ball& b) {
  const vec3 between = sum(b.middle, -1, a.middle);
  const double apart = length(between);
  if (apart + b.radius <= a.radius)
    return a;
  if (apart + a.radius <= b.radius)
    return b;
  const double radius = (a.radius + apart + b.radius) / 2;
  return {sum(a.middle, (radius - a.radius) / apart, between), radius};
}

expected<framed_camera> frame(const framing& asked, const ball& shown) {
  return frame_from(
      asked,
      {shown.middle, along(1), degrees_of(std::atan2(3.0, 6.0)), degrees_of(std::asin(2 / 7.)),
       [&](const vec3& eye) {
         if (!asked.eye)
           return usual_half_width;
         // what looks beside the middle sees the ball on one side: the angle between is added
         const vec3 to_middle = sum(shown.middle, -1, eye),
                    to_point = sum(asked.look_at.value_or(shown.middle), -1, eye);
         const double far = length(to_middle);
         constexpr double widest = std::numbers::pi / 3;
         if (!(far > shown.radius))
           return std::tan(widest);
         const double aside = std::atan2(length(cross(unit(to_middle), unit(to_point))),
                                         dot(unit(to_middle), unit(to_point)));
         return std::tan(std::min(widest, std::asin(shown.radius / far) + aside));
       },
       [&](double half, const vec3& look_at) {
         const double reach = shown.radius + length(sum(look_at, -1, shown.middle));
         return reach * std::sqrt(1 + half * half) / half;
       }});
}

expected<framed_camera> frame(const framing& asked, const camera& from, const vec3& middle) {
  const std::size_t top = steepest(from.up);
  const vec3 axis = along(top, from.up[top] < 0 ? -1 : 1);
  const double scale = towards_1(from.centre); // exact where the camera's numbers are short
  const vec3 ahead = times(scale, from.centre);
  const double nearest = dot(sum(middle, -1, from.eye), ahead) / dot(ahead, ahead) * scale;
  const vec3 look_at = sum(from.eye, nearest > 0 ? nearest : 1, from.centre);
  if (framing others = asked; others.zoom.reset(), others.empty()) {
    if (const support::status may = asked.check(); !may)
      return unexpected{may.reason()};
    framed_camera same{from, look_at, axis};
    if (asked.zoom)
      for (vec3* side : {&same.view.right, &same.view.up})
        *side = times(1 / *asked.zoom, *side);
    if (const support::status may = same.view.check(); !may)
      return unexpected{"the view is out of reach: " + may.reason()};
    return same;
  }
  if (const support::status may = asked.check(); !may)
    return unexpected{may.reason()};
  const vec3 about = asked.up ? unit(*asked.up) : axis;
  const vec3 back = unit(times(-1, from.centre));
  const horizon h(about);
  const double distance = length(sum(look_at, -1, from.eye)),
               half = length(from.up) / 2 / length(from.centre);
  return frame_from(asked,
                    {look_at, axis, degrees_of(std::atan2(dot(back, h.aside), dot(back, h.ahead))),
                     degrees_of(std::asin(std::clamp(dot(back, about), -1.0, 1.0))),
                     [=](const vec3&) { return half; },
                     [=](double new_half, const vec3&) { return distance * half / new_half; }});
}

camera turned(const framed_camera& from, double degrees) {
  const turn by = turn::of(degrees);
  if (by.cosine == 1)
    return from.view;
  const vec3& u = from.axis;
  const auto about_axis = [&](const vec3& v) { // Rodrigues' formula
    return sum(sum(times(by.cosine, v), by.sine, cross(u, v)), (1 - by.cosine) * dot(u, v), u);
  };
  const camera& c = from.view;
  return {sum(from.look_at, 1, about_axis(sum(c.eye, -1, from.look_at))), about_axis(c.centre),
          about_axis(c.right), about_axis(c.up)};
}

expected<vec3> vector_from(std::string_view text) {
  const auto numbers = numbers_from(text);
  if (!numbers)
    return unexpected{numbers.reason()};
  if (numbers->size() != 3)
    return unexpected{fmt::format("needs x,y,z, not {} numbers", numbers->size())};
  return vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

expected<vec3> direction_from(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view name = text.substr(negative ? 1 : 0);
  if (name.size() == 1)
    if (const auto axis = std::string_view("xyz").find(name); axis != std::string_view::npos)
      return along(axis, negative ? -1 : 1);
  return vector_from(text);
}

} // namespace graze::render
