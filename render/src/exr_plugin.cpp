// The plug-in that writes EXR, by OpenImageIO.
#include "exr_plugin.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <fmt/format.h>

namespace graze::render {
namespace {

/// The values of all channels, pixel by pixel.
std::vector<float> interleave(const std::vector<channel>& planes) {
  const std::size_t count = planes.front().values.size();
  std::vector<float> result(count * planes.size());
  for (std::size_t c = 0; c < planes.size(); ++c)
    for (std::size_t p = 0; p < count; ++p)
      result[p * planes.size() + c] = planes[c].values[p];
  return result;
}

unexpected failure(std::string detail) {
  std::replace(detail.begin(), detail.end(), '\n', ' ');
  return unexpected{
      fmt::format("cannot encode as EXR: {}", detail.empty() ? "unknown reason" : detail)};
}

expected<std::vector<unsigned char>> encode_all(const picture& image) {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.x = image.left;
  spec.y = image.top;
  spec.full_x = spec.full_y = 0;
  spec.full_width = image.full_width != 0 ? image.full_width : image.width;
  spec.full_height = image.full_height != 0 ? image.full_height : image.height;
  spec.channelnames.clear();
  for (const channel& c : image.channels)
    spec.channelnames.push_back(c.name);
  for (const auto& [key, value] : image.metadata)
    spec.attribute(key, value);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("DateTime", ""); // or the writer puts in the time of day
  spec.attribute("compression", "zip");

  const auto writer = OIIO::ImageOutput::create("exr");
  if (!writer)
    return failure(OIIO::geterror());
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!writer->set_ioproxy(&memory) || !writer->open("picture.exr", spec) ||
      !writer->write_image(OIIO::TypeDesc::FLOAT, interleave(image.channels).data()) ||
      !writer->close())
    return failure(writer->geterror());
  return bytes;
}

} // namespace
} // namespace graze::render

extern "C" __attribute__((visibility("default"))) const graze::render::exr_plugin graze_exr_plugin;
const graze::render::exr_plugin graze_exr_plugin = {GRAZE_VERSION, graze::render::encode_all};
