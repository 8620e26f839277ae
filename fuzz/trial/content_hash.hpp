#pragma once
/// Files that are named by what is in them.
#include <string>
#include <string_view>

namespace graze::fuzz {

/// The name of a file with this content: its UUID (version 5: SHA-1; namespace 0), 32 hex digits.
std::string content_hash(std::string_view content);

} // namespace graze::fuzz
