#pragma once
/// Pictures read back by OpenImageIO, which has not written the PNG ones.
#include <graze/render/image.hpp>

/// exr as it was written; png as R, G, B in [0, 1] without undoing the sRGB curve.
graze::expected<graze::render::picture> read_picture(const std::string& file);
