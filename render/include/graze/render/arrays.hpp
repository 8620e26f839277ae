#pragma once
/// What is proven of a picture's rays as NumPy's arrays.
#include <graze/render/render.hpp>
#include <string>
#include <utility>
#include <vector>

namespace graze::render {

/// A .npz file, which numpy.load reads without pickles, of a rendering with facts. Arrays of the
/// picture's height and width: verdict (int8) and object (int32), as in EXR; depth_lower and depth_upper
/// (float64); with a third axis x, y, z point_lower, point_upper, normal_lower, normal_upper (float64):
/// struct proof; direction, of the pixel's ray, and eye, its origin (float64, 3). Of each text, an array of no axes, its bytes; "graze:scene" is named scene. The same
/// rendering gives the same bytes.
expected<std::vector<unsigned char>>
encode_npz(const rendering& result, const std::vector<std::pair<std::string, std::string>>& texts);

} // namespace graze::render
