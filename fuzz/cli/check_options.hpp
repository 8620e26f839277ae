#pragma once
/// The options of graze-fuzz for other people's CI: what is known to be wrong, and results for machines.
#include <CLI/CLI.hpp>
#include <report/checks/baseline.hpp>

namespace graze::fuzz {

struct check_options {
  std::string baseline, write_baseline, junit, sarif;
  bool github = false;
  std::optional<fuzz::baseline> known{}; ///< once it was read

  [[nodiscard]] bool any() const {
    return github ||
           !(baseline.empty() && write_baseline.empty() && junit.empty() && sarif.empty());
  }
};

/// `json` is the option that --github excludes: both print to standard output.
void add_check_options(CLI::App& app, CLI::Option& json, check_options& options);

/// Reads the baseline, and asks whether the files could be written; before the work.
support::status prepare(check_options& options);

/// With the baseline, if there is one; a note on standard error where plans differ.
void compare_with_known(const check_options& options, check_report& report,
                        const std::optional<known_campaign>& now);

/// Prints and writes; gives the exit code. What a campaign has counted is `now`, and `lines` are what replay
/// lines show: both are what a new baseline holds. `text`: standard output is for people.
int conclude(const check_options& options, check_report& report,
             const std::optional<known_campaign>& now,
             const std::map<std::string, finding_set>& lines, bool text);

/// The first word of a command that is the name of a regular file below this folder: where annotations point.
std::string file_of_command(const std::string& command);

} // namespace graze::fuzz
