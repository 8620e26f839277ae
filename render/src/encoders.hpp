#pragma once
/// The writers of pictures, one a format; image.cpp has looked at the picture before.
#include <graze/render/image.hpp>

namespace graze::render {

/// The channels R, G, B as bytes, and the metadata, by libpng.
expected<std::vector<unsigned char>> encode_png(const picture& image);

/// Loads the plug-in that writes EXR, once; every call says how that went. OpenImageIO's libraries
/// start threads and abort where there are none, so this asks for threads and memory first.
support::status load_exr_encoder();

/// All channels and the metadata, by OpenImageIO in the plug-in.
expected<std::vector<unsigned char>> encode_exr(const picture& image);

} // namespace graze::render
