#pragma once
/// How a scene is looked at: camera, colours, light and background, by options that go before what the
/// scene says. docs/view.md.
#include <CLI/CLI.hpp>
#include <graze/render/scene.hpp>
#include <string>
#include <vector>

namespace graze::render {

struct view_options {
  std::string eye, look_at, up, colour, inside_colour, background;
  std::vector<std::string> lights;
  std::optional<double> azimuth, elevation, fov, zoom;
  int orbit = 0; ///< pictures around; 0: one, as the camera stands
  std::string animate;
  int frames = 0; ///< of `animate`; 0: it says nothing

  std::vector<CLI::Option*> declare(CLI::App& app);
  /// Refuses what cannot be read, and what contradicts the scene. Gives what an orbit turns.
  /// A camera that fits, fits `shown`, or without that the surface.
  [[nodiscard]] expected<framed_camera> apply(scene& s,
                                              const std::optional<ball>& shown = {}) const;

  /// The pictures of `orbit` or `animate`; 1 without them. What contradicts itself is refused.
  [[nodiscard]] expected<int> pictures() const;
  /// Of `animate`, as --set takes it: "a=0.25". The name's values go from the first to the last in even
  /// steps, each the shortest decimal of its double. pictures() has looked at it.
  [[nodiscard]] std::string value_of(int picture) const;
};

inline constexpr int most_frames = 10000;

} // namespace graze::render
