#pragma once
/// Trials of what reads files: valid bytes, damaged, must be refused with a reason, or mean what
/// they say. Input ends where readable memory ends, so that reading beyond it is a crash.
#include <graze/octree_file.hpp>
#include <self/subject.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz::self {

using octree_decoder =
    std::function<expected<octree::described_octree>(std::span<const unsigned char>)>;
using line_decoder = std::function<expected<trial>(std::string_view)>;

/// Octree files. `sign_again`: the checksum is made right after the damage. What is accepted must
/// be what encode_octree writes, byte for byte; a change within 32 bits that the checksum was not
/// adapted to must be refused.
part octree_file_loader(std::string name, bool sign_again, octree_decoder under_test);
/// Replay lines. What is accepted must hold the line's own numbers, be fit to be judged, and come
/// back the same from its own spelling.
part replay_line_loader(std::string name, line_decoder under_test);

subject loaders_subject();

} // namespace graze::fuzz::self
