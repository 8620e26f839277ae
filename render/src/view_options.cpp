#include "view_options.hpp"

#include <cmath>
#include <fmt/format.h>
#include <graze/render/scene_text.hpp>
#include <graze/support/text.hpp>

namespace graze::render {
namespace {

/// What `text` is read as by `from`; nothing where it is empty.
template <class T>
support::status read(const char* option, const std::string& text,
                     expected<T> (*from)(std::string_view), std::optional<T>& to) {
  if (text.empty())
    return {};
  auto found = from(text);
  if (!found)
    return unexpected{fmt::format("{}: {}", option, found.reason())};
  to = *std::move(found);
  return {};
}

expected<light> light_from(std::string_view text) {
  const auto numbers = numbers_from(text);
  if (!numbers)
    return unexpected{numbers.reason() + ", or headlight"};
  if (numbers->size() != 3 && numbers->size() != 4)
    return unexpected{
        fmt::format("needs x,y,z or x,y,z,intensity, not {} numbers", numbers->size())};
  const light l = {{(*numbers)[0], (*numbers)[1], (*numbers)[2]},
                   numbers->size() == 4 ? (*numbers)[3] : 0.8};
  for (const double x : l.position)
    if (!(x >= -1e100 && x <= 1e100))
      return unexpected{"a light must be finite, and within 1e100"};
  if (!(l.intensity >= 0 && l.intensity <= 1e6))
    return unexpected{"a light's intensity must be 0 to 1e6"};
  return l;
}

support::status add_lights(const std::vector<std::string>& texts, scene& s) {
  if (texts.empty())
    return {};
  if (texts.size() > most_lights)
    return unexpected{fmt::format("--light: at most {} lights", most_lights)};
  s.lights.clear();
  s.lit = texts.front() == "headlight" ? scene::lamps::headlight : scene::lamps::given;
  if (s.lit == scene::lamps::headlight && texts.size() > 1)
    return unexpected{"--light: headlight or positions, not both"};
  if (s.lit == scene::lamps::headlight)
    return {};
  for (const std::string& text : texts) {
    const auto l = light_from(text);
    if (!l)
      return unexpected{"--light: " + l.reason()};
    s.lights.push_back(*l);
  }
  return {};
}

struct named_range {
  std::string name;
  double first, last;
};

/// "a=0..1".
expected<named_range> range_from(std::string_view text) {
  const unexpected wrong{fmt::format("'{}' must be as a=0..1", support::shown(text))};
  const auto sign = text.find('='), dots = text.find("..");
  if (sign == text.npos || sign == 0 || dots == text.npos || dots < sign)
    return wrong;
  const auto first = numbers_from(text.substr(sign + 1, dots - sign - 1)),
             last = numbers_from(text.substr(dots + 2));
  if (!first || !last || first->size() != 1 || last->size() != 1 ||
      !(std::fabs(first->front()) <= 1e100 && std::fabs(last->front()) <= 1e100))
    return wrong;
  return named_range{std::string(text.substr(0, sign)), first->front(), last->front()};
}

} // namespace

std::vector<CLI::Option*> view_options::declare(CLI::App& app) {
  const char* const group = "View (docs/view.md)";
  std::vector<CLI::Option*> all = {
      app.add_option("--azimuth", azimuth,
                     "Degrees about up: where the eye stands around the point that it looks at"),
      app.add_option("--elevation", elevation, "Degrees above it, -90 to 90"),
      app.add_option("--eye", eye, "x,y,z: where the eye is"),
      app.add_option("--look-at", look_at,
                     "x,y,z: the picture's centre; without it the surface's middle"),
      app.add_option("--up", up,
                     "x, y or z (also -z), or x,y,z: upwards in the picture; y without it"),
      app.add_option("--zoom", zoom, "2: twice as large"),
      app.add_option("--fov", fov,
                     "Degrees across the shorter side, 0.001 to 170; the eye comes nearer or goes\n"
                     "away, so that as much is seen, unless --eye is given"),
      app.add_option("--colour,--color", colour,
                     "The surface's: a name, #rrggbb, or r,g,b (linear, from 0 on)"),
      app.add_option("--inside-colour,--inside-color", inside_colour,
                     "Its colour seen from where the formula is less than 0"),
      app.add_option("--background", background, "A colour, or transparent"),
      app.add_option(
             "--light", lights,
             "x,y,z or x,y,z,intensity, again for each; or headlight, at the eye, as it is\n"
             "wherever the camera is turned")
          ->take_all(),
      app.add_option(
          "--orbit", orbit,
          fmt::format("Pictures around the surface, 2 to {}: name_0000.png and so on, or\n"
                      "by a pattern as in -o name-%03d.png",
                      most_frames)),
      app.add_option("--animate", animate,
                     "a=0..1: pictures with --set a=..., from the first value to the last"),
      app.add_option("--frames", frames, fmt::format("Of --animate, 2 to {}", most_frames)),
  };
  for (CLI::Option* option : all)
    option->group(group);
  return all;
}

expected<int> view_options::pictures() const {
  const auto count = [](const char* name, int n) -> expected<int> {
    if (n < 2 || n > most_frames)
      return unexpected{fmt::format("{} must be 2 to {}, not {}", name, most_frames, n)};
    return n;
  };
  if (animate.empty()) {
    if (frames != 0)
      return unexpected{"--frames is of --animate"};
    return orbit == 0 ? expected<int>(1) : count("--orbit", orbit);
  }
  if (orbit != 0)
    return unexpected{"--orbit and --animate exclude each other"};
  if (frames == 0)
    return unexpected{"--animate needs --frames"};
  if (const auto range = range_from(animate); !range)
    return unexpected{"--animate: " + range.reason()};
  return count("--frames", frames);
}

std::string view_options::value_of(int picture) const {
  const auto range = range_from(animate);
  const double part = static_cast<double>(picture) / (frames - 1);
  return fmt::format("{}={}", range->name, range->first * (1 - part) + range->last * part);
}

expected<framed_camera> view_options::apply(scene& s, const std::optional<ball>& shown) const {
  framing asked{{}, {}, {}, azimuth, elevation, fov, zoom};
  std::optional<render::colour> body, inside, behind;
  const bool transparent = background == "transparent";
  for (const support::status& may :
       {read("--eye", eye, vector_from, asked.eye),
        read("--look-at", look_at, vector_from, asked.look_at),
        read("--up", up, direction_from, asked.up), read("--colour", colour, colour_from, body),
        read("--inside-colour", inside_colour, colour_from, inside),
        read("--background", transparent ? "" : background, colour_from, behind),
        add_lights(lights, s)})
    if (!may)
      return unexpected{may.reason()};
  if (s.objects.size() > 1 && (body || inside))
    return unexpected{"--colour and --inside-colour are of one surface; this scene's objects have "
                      "their own (body, inside)"};
  if (body)
    s.objects[0].look.body = *body;
  if (inside)
    s.objects[0].look.inside = *inside;
  if (!background.empty())
    s.transparent = transparent;
  if (behind)
    s.background = *behind;
  if (orbit != 0 && s.lit == scene::lamps::usual)
    s.lit = scene::lamps::headlight;
  const auto settled = settle_view(s, asked, shown);
  if (!settled)
    return unexpected{"the view: " + settled.reason()};
  return settled;
}

} // namespace graze::render
