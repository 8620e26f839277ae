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
#include <judge/judge.hpp>
#include <string>
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

/// What exact arithmetic and the traversal say about a case (about the ray that the traversal
/// received). The oracle's part is told by its
/// rational form, which shares nothing with the one that found the case.
struct replay_result {
  voxel_set touches = 0, crosses = 0, owns = 0, visited = 0; ///< by octant of the block
  finding_set findings = 0;
  bool oracles_agree = true; ///< the rational answers are those that the campaign judges by
  bool declined = false;     ///< the traversal does not take this case: nothing was judged
  std::string thrown;        ///< what an exception says, where that is the finding
};
replay_result replay(const trial& t, traversal& under_test);

/// One JSON object on one line: line, traversal, touches, crosses, owns, visited, findings,
/// oracles_agree, what an exception says, and for a block the same for each octant.
std::string to_json_line(const replay_case& c, const replay_result& r,
                         std::string_view traversal_name);

} // namespace graze::fuzz
