#pragma once
/// Texts of others, made fit to be shown: what comes from arguments, files and other programs.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace graze::support {

/// As UTF-8: U+FFFD for each byte that is no part of it.
std::string utf8(std::string_view text);

/// On one line: UTF-8 without control characters and marks of direction, those that end lines as
/// spaces, the others as '?'; cut, with "...", after `most` bytes.
std::string shown(std::string_view text, std::size_t most = 200);

/// As text in an element or attribute of XML or HTML: UTF-8, the marks & < > " and the ends of lines as
/// references, other control characters as '?', since XML 1.0 has none.
std::string markup(std::string_view text);

/// A JSON value on one line, whatever bytes its texts hold. Of nlohmann::basic_json.
template <class Json> std::string json_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The whole number that a JSON value is, where Integer holds it; nothing for any other value. A JSON
/// number with a point or an exponent is none, and neither is one that Integer does not hold: a
/// conversion of these is undefined. Of nlohmann::basic_json.
template <class Integer, class Json> std::optional<Integer> whole_number(const Json& value) {
  if (value.is_number_unsigned()) {
    const auto x = value.template get<std::uint64_t>();
    return std::in_range<Integer>(x) ? std::optional(static_cast<Integer>(x)) : std::nullopt;
  }
  if (value.is_number_integer()) {
    const auto x = value.template get<std::int64_t>();
    return std::in_range<Integer>(x) ? std::optional(static_cast<Integer>(x)) : std::nullopt;
  }
  return std::nullopt;
}

/// 32 hex digits in lower case: the name of a content.
bool is_content_hash(std::string_view text);

} // namespace graze::support
