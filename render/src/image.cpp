#include "encoders.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace graze::render {
const channel* picture::find(const std::string& name) const {
  for (const channel& c : channels)
    if (c.name == name)
      return &c;
  return nullptr;
}

expected<file_format> format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (extension == ".png")
    return file_format::png;
  if (extension == ".exr")
    return file_format::exr;
  if (extension == ".npz")
    return file_format::npz;
  return unexpected{fmt::format("'{}' ends in none of .png, .exr, .npz", file.string())};
}

std::uint8_t srgb_byte(float linear) {
  const double x = linear > 0 ? std::min(static_cast<double>(linear), 1.0) : 0.0;
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(encoded * 255 + 0.5);
}

support::status prepare_to_encode(file_format format) {
  return format == file_format::exr ? load_exr_encoder() : support::status();
}

expected<std::vector<unsigned char>> encode(const picture& image, file_format format) {
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (pixels == 0)
    return unexpected{"a picture without pixels"};
  bool whole = !image.channels.empty();
  for (const channel& c : image.channels)
    whole = whole && c.values.size() == pixels;
  for (const char* name : {"R", "G", "B"})
    whole = whole && (format == file_format::exr || image.find(name) != nullptr);
  if (!whole)
    return unexpected{"a picture lacks a channel, or a channel lacks pixels"};
  switch (format) {
  case file_format::png:
    return encode_png(image);
  case file_format::exr:
    return encode_exr(image);
  case file_format::npz:
    break;
  }
  return unexpected{"a picture is no NPZ file"};
}

} // namespace graze::render
