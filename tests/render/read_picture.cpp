#include "read_picture.hpp"

#include <OpenImageIO/imageio.h>

using namespace graze::render;

graze::expected<picture> read_picture(const std::string& file) {
  OIIO::ImageSpec as_written; // or it multiplies a PNG picture's colours by its alpha
  as_written.attribute("oiio:UnassociatedAlpha", 1);
  const auto reader = OIIO::ImageInput::open(file, &as_written);
  if (!reader)
    return graze::unexpected{OIIO::geterror()};
  const OIIO::ImageSpec& spec = reader->spec();
  picture result{spec.width,      spec.height,     {}, {}, spec.x, spec.y,
                 spec.full_width, spec.full_height};
  const std::size_t pixels = spec.image_pixels();
  const std::size_t count = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> values(pixels * count);
  if (!reader->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
    return graze::unexpected{reader->geterror()};
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
