#pragma once
/// Texts of others, made fit to be shown: what comes from arguments, files and other programs.
#include <string>
#include <string_view>

namespace graze::support {

/// As UTF-8: U+FFFD for each byte that is no part of it.
std::string utf8(std::string_view text);

/// On one line: UTF-8 without control characters and marks of direction, those that end lines as
/// spaces, the others as '?'; cut, with "...", after `most` bytes.
std::string shown(std::string_view text, std::size_t most = 200);

/// A JSON value on one line, whatever bytes its texts hold. Of nlohmann::basic_json.
template <class Json> std::string json_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// 32 hex digits in lower case: the name of a content.
bool is_content_hash(std::string_view text);

} // namespace graze::support
