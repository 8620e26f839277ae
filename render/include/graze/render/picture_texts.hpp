#pragma once
/// What a picture tells of itself: the texts in an EXR file's header and a PNG file's tEXt chunks. No
/// pixel is looked at, so that a file takes memory and time in proportion to its texts.
#include <graze/expected.hpp>
#include <map>
#include <string>
#include <string_view>

namespace graze::render {

/// Of each name the last text.
using picture_texts = std::map<std::string, std::string, std::less<>>;

/// Bytes that are looked at: an EXR header, or a PNG file up to its pixels. Our scenes' texts fit.
inline constexpr std::size_t longest_picture_head = std::size_t{5} << 20;

/// Of the beginning of a file; any bytes. What is cut off or malformed is refused.
expected<picture_texts> texts_in(std::string_view head);

/// Of a file; the reason names it.
expected<picture_texts> texts_of_picture(const std::string& path);

} // namespace graze::render
