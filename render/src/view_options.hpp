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

  std::vector<CLI::Option*> declare(CLI::App& app);
  /// Refuses what cannot be read, and what contradicts the scene. Gives what an orbit turns.
  [[nodiscard]] expected<framed_camera> apply(scene& s) const;
};

inline constexpr int most_frames = 10000;

} // namespace graze::render
