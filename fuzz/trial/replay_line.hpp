#pragma once
/// Replay files: JSON lines, one ray or segment and its cells a line.
///
///   {"origin":["0x1p-2","0x0p+0","0x1p-1"],"direction":["0x0p+0","0x1p+0","0x0p+0"],
///    "octant":{"lo":["0x0p+0","0x0p+0","0x0p+0"],"size":"0x1p-1"},
///    "root":{"lo":["0x0p+0","0x0p+0","0x0p+0"],"size":"0x1p+0"}}
///
/// Numbers are hex floats in strings; decimal strings, JSON numbers, and strings of 16 hex digits, which
/// are the bits of a double, are read too. `"end":[3]` in place of `direction` makes it a segment.
/// The cells are one of
///   `octant`, with `root` ([0,1]^3 where it is left out) and `"extent":[x,y,z]`, 1..4 each, which makes
///       it a block whose first octant is `octant` (an order error needs two);
///   `"grid":{"origin":[3],"spacing":[3],"count":[3],"planes":"rounded"}` (a name of plane_rule) or
///       `"grid":{"planes":[[...],[...],[...]]}`, with `"voxel":[i,j,k]` and `extent` as above;
///   `"scene":"FILE"`, a map, with `voxel` and `extent`, of which those count that are occupied in it; or
///       `"scene":{"file":"FILE","voxel_size":"0x1p-3","cell_centred":true}` with what the file leaves open;
///   `"box":{"lo":[3],"hi":[3]}` or `"boxes":[...]`, up to 64 of them.
/// Remarks may be in `comment` and `name`; what graze-fuzz writes besides (`finding`, `missed_by`, `kind`,
/// `traversal`) is left alone; any other member is refused.
#include <string>
#include <trial/trial.hpp>
#include <vector>

namespace graze::fuzz {

/// One line, without its end.
std::string to_json_line(const trial& t);

/// Reads one line; the reason says what is wrong with it. `maps` is asked for those that lines name; without
/// it such lines are refused.
expected<trial> from_json_line(std::string_view line, const map_source& maps = {});

/// A grid alone, as the member `grid` of a line.
std::string grid_text(const grid_planes& grid);
/// Reads it; the reason says what is wrong with it.
expected<grid_planes> grid_from_text(std::string_view text);

struct replay_case {
  std::size_t line; ///< its number in the file, from 1
  trial at;
};

/// Bounds of a replay file: 64 KiB a line, a million lines.
inline constexpr std::size_t longest_replay_line = 1 << 16, most_replay_lines = 1'000'000;

/// Reads a whole file ("-" is standard input); lines of blanks are skipped. Refuses the file if any
/// line is wrong: "FILE:LINE: reason".
expected<std::vector<replay_case>> read_replay_file(const std::string& path,
                                                    const map_source& maps = {});

} // namespace graze::fuzz
