#pragma once
/// Pictures as named channels of floats, and their files: PNG by libpng, EXR by OpenImageIO in a plug-in.
#include <cstdint>
#include <filesystem>
#include <graze/support/status.hpp>
#include <string>
#include <utility>
#include <vector>

namespace graze::render {

/// One plane of values, row by row from the top.
struct channel {
  /// "R", "G", "B", "Z"; "A", by which R, G and B are multiplied; of a layer "normal.X" and so on
  std::string name;
  std::vector<float> values;
};

/// Linear values, all channels of one size.
struct picture {
  int width = 0;
  int height = 0;
  std::vector<channel> channels;
  std::vector<std::pair<std::string, std::string>> metadata{};
  /// The picture that this is a part of: its first column and row there, and the size of the whole,
  /// 0 where this is the whole. exr keeps it, png does not.
  int left = 0, top = 0, full_width = 0, full_height = 0;

  [[nodiscard]] const channel* find(const std::string& name) const;
};

enum class file_format { png, exr, npz };

/// By extension, in any case of letters; refuses others and says which there are.
expected<file_format> format_of(const std::filesystem::path& file);

/// The sRGB byte of a linear value (IEC 61966-2-1, rounded to nearest); clamps to [0, 1], NaN is 0.
std::uint8_t srgb_byte(float linear);

/// Loads what the format needs, if that is not done yet; or why it cannot be had. Asked before the work,
/// and before threads are started. exr: the plug-in graze_exr.so; png: nothing.
support::status prepare_to_encode(file_format format);

/// The bytes of the file. png: the channels R, G, B as 8-bit sRGB; with A, these divided by it, and it. exr: every channel as a 32-bit
/// float, lossless. npz is no picture: arrays.hpp. The same picture gives the same bytes: no date is written.
expected<std::vector<unsigned char>> encode(const picture& image, file_format format);

} // namespace graze::render
