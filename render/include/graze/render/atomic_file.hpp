#pragma once
/// Files that appear whole or not at all.
#include <cstddef>
#include <filesystem>
#include <graze/expected.hpp>
#include <span>

namespace graze::render {

/// Whether `file` could be written: its folder is there and may be written to, and `file` itself is
/// absent or a regular file. Empty if so, otherwise the reason. Asked before the work is done.
std::string why_not_writable(const std::filesystem::path& file);

/// Writes the bytes under a temporary name beside `file`, flushes them to the disk and renames. On
/// any failure nothing new is left and an older `file` is untouched. Gives the number of bytes.
expected<std::size_t> write_atomically(const std::filesystem::path& file,
                                       std::span<const unsigned char> bytes);

} // namespace graze::render
