#pragma once
/// Scenes as JSON text: scene files, and what a picture tells of itself. docs/render.md has the
/// keys.
#include <graze/render/scene.hpp>
#include <string>
#include <string_view>

namespace graze::render {

/// A place in a formula's text.
struct formula_mark {
  std::string text;
  std::size_t column = 0; ///< in bytes, from 1; 0 for none

  /// The text about the place, and below it a caret: two lines, with their ends; empty for none.
  [[nodiscard]] std::string lines() const;
};

/// By name, as a scene has them.
std::vector<octree::parameter> in_order(std::vector<octree::parameter> set);
/// Whether each parameter is part of a formula of the scene: else the reason, which names one.
support::status check_set(const scene& s);

/// Bytes of a scene's text.
inline constexpr std::size_t largest_scene_text = 1 << 21;

/// The scene that a text describes. Any text: refuses what is no scene with a reason that names the
/// line and column (no JSON), or the key, with the formula's column where that does not parse. That
/// there is a surface is not looked at (prepare).
/// `set` comes before the text's own key "set". `where`, if given, is that formula with its column.
expected<scene> scene_from(std::string_view text, std::span<const octree::parameter> set = {},
                           formula_mark* where = nullptr);

/// The text of a scene, on one line, in ASCII, from which scene_from makes the same scene.
std::string text_of(const scene& s);

/// Numbers with commas between; one or more.
expected<std::vector<double>> numbers_from(std::string_view text);

/// "lo,hi" for all axes, or "x0,x1,y0,y1,z0,z1".
expected<octree::box> domain_from(std::string_view text);

} // namespace graze::render
