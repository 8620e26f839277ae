#pragma once
/// What graze-render is asked for, and the settings that a picture tells of itself.
#include <graze/render/render.hpp>
#include <graze/support/status.hpp>
#include <string>
#include <string_view>

namespace graze::render {

/// All on which the bytes of a picture depend, beside the scene and the version.
struct picture_settings {
  render::mode mode = render::mode::cast;
  render::method method = render::method::certified;
  int levels = 30;
  int octree_level = 9;
  extent size = 512;
  std::optional<window> crop;
  int spp = 1;
  bool show_gaps = false;

  /// Whether a picture can be made so.
  [[nodiscard]] support::status check() const;
  /// As JSON on one line; and back, where any text is refused that is none.
  [[nodiscard]] std::string text() const;
  static expected<picture_settings> parse(std::string_view text);
};

/// The file of frame i of several: of a pattern with one %d (%4d, %04d) its number there, from 0 on; of
/// another name with _%04d before its extension. Refuses a % that is no such pattern.
expected<std::string> frame_file(const std::string& output, int i);

/// "512" or "640x480".
expected<extent> extent_from(std::string_view text);
/// "x,y,w,h": first column, first row, width, height.
expected<window> window_from(std::string_view text);
/// The side of the square of `spp` rays; 0 if it is none.
int side_of(int spp);

} // namespace graze::render
