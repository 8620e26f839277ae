#pragma once
/// The words of a plain line.
#include <algorithm>
#include <string>
#include <string_view>

namespace graze::fuzz {

/// The next word of a line, which is taken off it; empty at its end.
inline std::string next_word(std::string_view& line) {
  const std::size_t from = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t to = std::min(line.find_first_of(" \t", from), line.size());
  std::string word(line.substr(from, to - from));
  line.remove_prefix(to);
  return word;
}

} // namespace graze::fuzz
