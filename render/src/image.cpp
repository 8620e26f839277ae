#include <graze/render/image.hpp>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace graze::render {
namespace {

/// The planes `names` interleaved as Value, by convert.
template <class Value, class Convert>
std::vector<Value> interleave(const std::vector<const channel*>& planes, Convert convert) {
  const std::size_t count = planes.empty() ? 0 : planes.front()->values.size();
  std::vector<Value> result(count * planes.size());
  for (std::size_t c = 0; c < planes.size(); ++c)
    for (std::size_t p = 0; p < count; ++p)
      result[p * planes.size() + c] = convert(planes[c]->values[p]);
  return result;
}

unexpected failure(const char* action, std::string detail) {
  std::replace(detail.begin(), detail.end(), '\n', ' ');
  return unexpected{fmt::format("{}: {}", action, detail.empty() ? "unknown reason" : detail)};
}

} // namespace

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
  return unexpected{fmt::format("'{}' ends in neither .png nor .exr", file.string())};
}

std::uint8_t srgb_byte(float linear) {
  const double x = linear > 0 ? std::min(static_cast<double>(linear), 1.0) : 0.0;
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(encoded * 255 + 0.5);
}

expected<std::vector<unsigned char>> encode(const picture& image, file_format format) {
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (pixels == 0)
    return unexpected{"a picture without pixels"};
  std::vector<const channel*> planes;
  if (format == file_format::png)
    planes = {image.find("R"), image.find("G"), image.find("B")};
  else
    for (const channel& c : image.channels)
      planes.push_back(&c);
  for (const channel* c : planes)
    if (c == nullptr || c->values.size() != pixels)
      return unexpected{"a picture lacks a channel, or a channel lacks pixels"};

  const bool png = format == file_format::png;
  const auto type = png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(planes.size()), type);
  if (!png) {
    spec.x = image.left;
    spec.y = image.top;
    spec.full_x = spec.full_y = 0;
    spec.full_width = image.full_width != 0 ? image.full_width : image.width;
    spec.full_height = image.full_height != 0 ? image.full_height : image.height;
  }
  spec.channelnames.clear();
  for (const channel* c : planes)
    spec.channelnames.push_back(c->name);
  for (const auto& [key, value] : image.metadata)
    spec.attribute(key, value);
  spec.attribute("oiio:ColorSpace", png ? "sRGB" : "Linear");
  spec.attribute("DateTime", ""); // or the EXR writer puts in the time of day
  if (!png)
    spec.attribute("compression", "zip");

  const auto writer = OIIO::ImageOutput::create(png ? "png" : "exr");
  if (!writer)
    return failure("no writer for this format", OIIO::geterror());
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!writer->set_ioproxy(&memory))
    return failure("cannot encode into memory", writer->geterror());
  if (!writer->open(png ? "picture.png" : "picture.exr", spec))
    return failure("cannot encode", writer->geterror());
  const bool written =
      png ? writer->write_image(type, interleave<std::uint8_t>(planes, srgb_byte).data())
          : writer->write_image(type, interleave<float>(planes, [](float v) { return v; }).data());
  if (!written || !writer->close())
    return failure("cannot encode", writer->geterror());
  return bytes;
}

expected<picture> read_picture(const std::filesystem::path& file) {
  const auto reader = OIIO::ImageInput::open(file.string());
  if (!reader)
    return failure("cannot read", OIIO::geterror());
  const OIIO::ImageSpec& spec = reader->spec();
  picture result{spec.width,      spec.height,     {}, {}, spec.x, spec.y,
                 spec.full_width, spec.full_height};
  const std::size_t pixels = spec.image_pixels();
  const std::size_t count = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> values(pixels * count);
  if (!reader->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
    return failure("cannot read", reader->geterror());
  for (std::size_t c = 0; c < count; ++c) {
    channel plane{spec.channel_name(static_cast<int>(c)), std::vector<float>(pixels)};
    for (std::size_t p = 0; p < pixels; ++p)
      plane.values[p] = values[p * count + c];
    result.channels.push_back(std::move(plane));
  }
  for (const auto& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeDesc::STRING)
      result.metadata.emplace_back(attribute.name().string(), attribute.get_string());
  return result;
}

} // namespace graze::render
