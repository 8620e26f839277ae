#pragma once
/// A case judged again, by rationals.
#include <graze/bounds.hpp>
#include <judge/judge.hpp>
#include <string>
#include <trial/replay_line.hpp>
#include <vector>

namespace graze::fuzz {

/// What exact arithmetic and the traversal say about a case (about the ray that the traversal
/// received). The oracle's part is told by its
/// rational form, which shares nothing with the one that found the case.
struct replay_result {
  octant_set touches = 0, crosses = 0, owns = 0, visited = 0; ///< by cell
  finding_set findings = 0;
  bool oracles_agree = true; ///< the rational answers are those that the campaign judges by
  bool declined = false;     ///< the traversal does not take this case: nothing was judged
  std::string thrown;        ///< what an exception says, where that is the finding
  std::string
      answer; ///< what was answered and is right (answer_text.hpp), where there is a finding
  /// Of each touched cell, by its number: enclosures of the first and last t of the line in it.
  std::vector<std::array<bounds, 2>> passages;
};
replay_result replay(const trial& t, traversal& under_test);

/// One JSON object on one line: line, traversal, touches, crosses, owns, visited, enter and leave (the
/// tightest [lo, hi] about the first and last t in the cell, null where it is not touched), findings,
/// oracles_agree, what an exception says, and for a block or a list the same for each cell.
std::string to_json_line(const replay_case& c, const replay_result& r,
                         std::string_view traversal_name);

} // namespace graze::fuzz
