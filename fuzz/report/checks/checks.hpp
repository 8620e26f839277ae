#pragma once
/// What a command has looked at, for those who show results: a check is a kind of finding of a campaign, or a
/// replay line; a problem is a finding of it.
#include <judge/judge.hpp>
#include <string>
#include <vector>

namespace graze::fuzz {

/// A finding beside the baseline. Without a baseline all are `fresh`.
enum class standing : std::uint8_t {
  known, ///< it is in the baseline
  fresh, ///< it is not
  more,  ///< it is, on fewer rays
  gone,  ///< it is, and was not found again
};
/// "known", "new", "more", "gone".
std::string_view name_of(standing s);
constexpr bool fails(standing s) { return s == standing::fresh || s == standing::more; }

struct problem {
  finding kind;
  standing how = standing::fresh;
  std::string sentence{}; ///< what happened, and how often: one line
  std::string details{};  ///< how it is seen again: lines
  std::string ray{};      ///< its replay line, where there is one
  std::string file{};     ///< where it is shown; empty: nowhere
  std::uint64_t file_line = 1;
};

struct check_result {
  std::string name;
  std::vector<problem> problems{};
  std::string declined{}; ///< why it was not judged; empty: it was
  std::string ray{};      ///< the replay line that was asked, of a replay
};

struct check_report {
  std::string command; ///< "run", "replay", "campaign"
  std::string traversal;
  double seconds = 0;
  std::vector<check_result> checks{};
  bool compared = false; ///< with a baseline
};

/// Something in it is new or more than it was.
[[nodiscard]] bool fails(const check_report& report);

/// "baseline: 3 known, 1 new, 0 more, 1 gone", and a line for each that is not just known.
std::string standings_text(const check_report& report);

/// {"known": [...], "new": [...], "more": [...], "gone": [...]}: checks and their kinds, as JSON.
std::string standings_json(const check_report& report);

/// JUnit's XML: a test case a check; what is known is skipped with a word.
std::string to_junit(const check_report& report);

/// SARIF 2.1.0: a result a problem, with its standing as baselineState.
std::string to_sarif(const check_report& report, std::string_view version);

/// GitHub's workflow commands: ::error for what fails, ::notice for the others.
std::string to_annotations(const check_report& report);

/// A path as a URI: relative ones as they are, absolute ones as file://.
std::string uri_of(const std::string& path);

/// As text and as an attribute of XML 1.0, whatever bytes it holds.
std::string xml_escaped(std::string_view text);

} // namespace graze::fuzz
