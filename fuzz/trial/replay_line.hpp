#pragma once
/// Replay files: JSON lines, one ray and one octant (or small block of octants) a line.
///
///   {"origin":["0x1p-2","0x0p+0","0x1p-1"],"direction":["0x0p+0","0x1p+0","0x0p+0"],
///    "octant":{"lo":["0x0p+0","0x0p+0","0x0p+0"],"size":"0x1p-1"},
///    "root":{"lo":["0x0p+0","0x0p+0","0x0p+0"],"size":"0x1p+0"}}
///
/// Numbers are hex floats in strings; decimal strings and JSON numbers are read too. `root` may be
/// left out ([0,1]^3). `"extent":[x,y,z]`, 1..4 each, makes it a block whose first octant is
/// `octant` (an order error needs two). Other members (a comment, a name) are left alone.
#include <string>
#include <trial/trial.hpp>
#include <vector>

namespace graze::fuzz {

/// One line, without its end.
std::string to_json_line(const trial& t);

/// Reads one line; the reason says what is wrong with it.
expected<trial> from_json_line(std::string_view line);

struct replay_case {
  std::size_t line; ///< its number in the file, from 1
  trial at;
};

/// Bounds of a replay file: 64 KiB a line, a million lines.
inline constexpr std::size_t longest_replay_line = 1 << 16, most_replay_lines = 1'000'000;

/// Reads a whole file ("-" is standard input); lines of blanks are skipped. Refuses the file if any
/// line is wrong: "FILE:LINE: reason".
expected<std::vector<replay_case>> read_replay_file(const std::string& path);

} // namespace graze::fuzz
