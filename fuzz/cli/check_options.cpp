#include <cli/check_options.hpp>
#include <cli/commands.hpp>
#include <filesystem>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <sstream>

namespace graze::fuzz {

using namespace support;

void add_check_options(CLI::App& app, CLI::Option& json, check_options& options) {
  app.add_option("--baseline", options.baseline,
                 "What is known to be wrong: exit code 1 only for what is new, or more");
  app.add_option("--write-baseline", options.write_baseline,
                 "Write what is found to this file; exit code 0, unless --baseline says otherwise");
  app.add_option("--junit", options.junit, "Write the results to this file as JUnit's XML");
  app.add_option("--sarif", options.sarif, "Write the findings to this file as SARIF 2.1.0");
  app.add_flag("--github", options.github,
               "Print the findings as annotations of GitHub's workflows")
      ->excludes(&json);
}

status prepare(check_options& options) {
  if (!options.baseline.empty()) {
    auto known = read_baseline(options.baseline);
    if (!known)
      return unexpected{known.reason()};
    options.known = *std::move(known);
  }
  for (const std::string& file : {options.write_baseline, options.junit, options.sarif})
    if (!file.empty())
      if (status may = check_writable(file); !may)
        return may;
  return {};
}

void compare_with_known(const check_options& options, check_report& report,
                        const std::optional<known_campaign>& now) {
  if (!options.known)
    return;
  if (const std::string note = compare(report, *options.known, now); !note.empty())
    complain(note);
}

int conclude(const check_options& options, check_report& report,
             const std::optional<known_campaign>& now,
             const std::map<std::string, finding_set>& lines, bool text) {
  if (options.known && text)
    print_text(standings_text(report));
  if (options.github)
    print_text(to_annotations(report));
  const std::array<std::pair<const std::string*, std::string (*)(const check_report&)>, 2> files{
      {{&options.junit, to_junit},
       {&options.sarif, [](const check_report& r) { return to_sarif(r, version()); }}}};
  for (const auto& [path, written] : files)
    if (!path->empty())
      if (const status s = write_atomically(*path, written(report)); !s)
        return bad_input(s.reason());
  if (!options.write_baseline.empty())
    if (const status s = write_atomically(options.write_baseline, to_json(baseline{now, lines}));
        !s)
      return bad_input(s.reason());
  if (!options.write_baseline.empty() && !options.known)
    return done;
  return fails(report) ? found : done;
}

std::string file_of_command(const std::string& command) {
  std::istringstream words(command);
  for (std::string word; words >> word;) {
    std::erase_if(word, [](char c) { return c == '\'' || c == '"'; });
    std::error_code error;
    if (!word.empty() && word[0] != '/' && word.find("..") == std::string::npos &&
        std::filesystem::is_regular_file(word, error))
      return word;
  }
  return {};
}

} // namespace graze::fuzz
