#pragma once
/// What graze-itf1788 prints.
#include <graze/itf1788/run.hpp>

namespace graze::itf1788 {

struct totals {
  int passed = 0, failed = 0, unsupported = 0; ///< passed: tighter results are
};
totals total_of(const file_report& report);
totals total_of(const std::vector<file_report>& reports);

/// The same reports with tighter results counted as failed: nothing but the stated results passes.
std::vector<file_report> strict(std::vector<file_report> reports);

/// A line per failed statement and per tighter result and a line of counts per file, then
/// "total: N passed, N failed, N unsupported". What is unsupported is grouped by operation, or, if
/// `verbose`, listed with the passed statements too.
std::string to_text(const std::vector<file_report>& reports, bool verbose);

/// {"files": [{"file", "passed", "failed", "unsupported"}], "failures": [{"file", "line",
/// "statement", "expected", "got"}], "tighter": [the same], "unsupported": [{"file", "line",
/// "statement", "missing"}], "total": {"passed", "failed", "unsupported"}} in one line.
std::string to_json(const std::vector<file_report>& reports);

} // namespace graze::itf1788
