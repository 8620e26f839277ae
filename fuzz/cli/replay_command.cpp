#include <algorithm>
#include <cli/check_options.hpp>
#include <cli/commands.hpp>
#include <cli/traversal_options.hpp>
#include <external/maps.hpp>
#include <filesystem>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <judge/replay.hpp>
#include <nlohmann/json.hpp>
#include <report/reproducer/reproducer.hpp>

namespace graze::fuzz {

namespace {

using namespace support;

struct replay_options {
  std::vector<std::string> files; ///< and folders
  std::string name = "sound";
  traversal_options traversal;
  std::string reproducer; ///< a folder
  std::string language;
  check_options checks;
  bool json = false;
};

struct named_case {
  std::string file;
  replay_case replayed;
};

/// The replay files of a folder, sorted: *.jsonl and *.json but for baselines; of a campaign's folder its
/// findings.
expected<std::vector<std::string>> files_in(const std::string& folder) {
  namespace files = std::filesystem;
  const std::string within = is_there(folder + "/plan.json") ? folder + "/findings" : folder;
  std::vector<std::string> found;
  std::error_code error;
  files::directory_iterator entry(within, error);
  for (const files::directory_iterator end; !error && entry != end; entry.increment(error)) {
    const files::path& path = entry->path();
    const std::string ending = path.extension();
    std::error_code ignored;
    if ((ending != ".jsonl" && ending != ".json") || entry->is_directory(ignored))
      continue;
    if (entry->is_regular_file(ignored)) // another is refused when it is read
      if (auto file = input_file::open(path); file)
        if (const auto head = file->read(100); head && is_baseline(*head))
          continue;
    found.push_back(path);
  }
  if (error)
    return failed("read", within, error.value());
  if (found.empty())
    return unexpected{fmt::format("{} holds no replay file (.jsonl, .json)", in_quotes(within))};
  std::sort(found.begin(), found.end());
  return found;
}

expected<std::vector<named_case>> cases_of(const std::vector<std::string>& arguments) {
  std::vector<named_case> cases;
  for (const std::string& argument : arguments) {
    std::error_code ignored;
    std::vector<std::string> files{argument};
    if (argument != "-" && std::filesystem::is_directory(argument, ignored)) {
      auto within = files_in(argument);
      if (!within)
        return unexpected{within.reason()};
      files = *std::move(within);
    }
    for (const std::string& file : files) {
      const auto read = read_replay_file(file, known_map);
      if (!read)
        return unexpected{read.reason()};
      for (const replay_case& c : *read)
        cases.push_back({file, c});
    }
  }
  return cases;
}

/// The map of all cases, if they are of one: of several, one has to be asked about at a time.
status take_map_of(const std::vector<named_case>& cases, external_options& external) {
  external.map = cases.front().replayed.at.map;
  for (const named_case& c : cases)
    if (c.replayed.at.map != external.map)
      return unexpected{
          fmt::format("{}:{}: it is of another map than the first line: ask about one map "
                      "at a time",
                      shown(c.file), c.replayed.line)};
  if (external.map)
    external.usual_cells = cell_kind::grid;
  return {};
}

/// The kinds of a set, most serious first.
std::vector<finding> kinds_in(finding_set findings) {
  std::vector<finding> kinds;
  for (unsigned k = 0; k < finding_kinds; ++k)
    if ((findings >> k & 1) != 0)
      kinds.push_back(static_cast<finding>(k));
  return kinds;
}

check_result check_of(const named_case& c, const replay_result& r, const traversal_entry& entry,
                      const std::string& reproducer) {
  check_result result{fmt::format("{}:{}", c.file, c.replayed.line)};
  result.ray = to_json_line(c.replayed.at);
  if (r.declined)
    result.declined = "declined, not judged";
  for (const finding kind : kinds_in(r.findings)) {
    problem p{kind, standing::fresh, std::string(sentence_of(kind))};
    if (kind == finding::exception && !r.thrown.empty())
      p.sentence += fmt::format(" ({})", r.thrown);
    p.details =
        fmt::format("replay: echo '{}' | graze-fuzz replay - {}\n", result.ray, entry.asked_for());
    if (!reproducer.empty())
      p.details += fmt::format("reproducer: {}\n", reproducer);
    p.ray = result.ray;
    if (c.file != "-") {
      p.file = c.file;
      p.file_line = c.replayed.line;
    }
    result.problems.push_back(std::move(p));
  }
  return result;
}

std::string yes_or_no(bool b) { return b ? "yes" : "no"; }

int replay_files(replay_options& options) {
  listen_for_interrupts();
  const auto cases = cases_of(options.files);
  if (!cases)
    return bad_input(cases.reason());
  if (const status may = prepare(options.checks); !may)
    return bad_input(may.reason());
  const trial& first = cases->front().replayed.at;
  options.traversal.external.usual_cells = first.cells();
  options.traversal.external.usual_segments = first.end.has_value();
  if (const status one = take_map_of(*cases, options.traversal.external); !one)
    return bad_input(one.reason());
  const auto entry = chosen_traversal(options.name, options.traversal, true);
  if (!entry)
    return bad_input(entry.reason());
  if (!options.reproducer.empty())
    if (const status may = prepare_folder(options.reproducer); !may)
      return bad_input(may.reason());
  // a line of one file is known by its number
  const bool several = options.files.size() > 1 || cases->front().file != options.files.front();
  const auto under_test = entry->guarded();
  const reader_of_test reader = reader_of(options.language, options.traversal, *entry);
  bool any = false, disagreed = false;
  check_report report{"replay", std::string(entry->name)};
  std::map<std::string, finding_set> lines;
  schedule stretches({.trials = cases->size()}, 1, stop_wanted);
  while (const auto taken = stretches.take()) {
    stretches.count(1);
    const named_case& named = (*cases)[taken->begin];
    const replay_case& c = named.replayed;
    const std::string place = several ? fmt::format("{}:{}", shown(named.file, 1000), c.line)
                                      : fmt::format("line {}", c.line);
    const replay_result r = replay(c.at, *under_test);
    disagreed = disagreed || !r.oracles_agree;
    any = any || r.findings != 0 || !r.oracles_agree;
    if (!r.oracles_agree)
      complain(fmt::format("{}: the two oracles disagree: a bug of graze", place));
    std::string written, reproducer;
    if (r.findings != 0 && !options.reproducer.empty()) {
      const auto path = write_reproducer(c.at, *under_test, worst(r.findings), entry->asked_for(),
                                         options.reproducer, reader);
      if (!path)
        return bad_input(path.reason());
      reproducer = path->spelled();
      written = fmt::format("; reproducer: {}", reproducer);
      tell_of_test(*path);
    }
    if (options.checks.any()) {
      report.checks.push_back(check_of(named, r, *entry, reproducer));
      if (r.findings != 0)
        lines[to_json_line(c.at)] |= r.findings;
    }
    if (options.json) {
      const std::string line = to_json_line(c, r, entry->name);
      print("{}\n", several ? fmt::format("{{\"file\":{},{}",
                                          nlohmann::json(utf8(named.file)).dump(), line.substr(1))
                            : line);
      continue;
    }
    std::string findings;
    for (const finding kind : kinds_in(r.findings))
      findings += fmt::format(" {}", name_of(kind));
    if (r.declined) {
      print("{}: declined by {}, not judged\n", place, shown(entry->name));
      continue;
    }
    if (!r.thrown.empty())
      findings += fmt::format(" ({})", r.thrown);
    const std::string owns = // boxes may overlap
        c.at.boxes ? "" : fmt::format(", owns {}", yes_or_no(r.owns != 0));
    print("{}: touches {}, crosses {}{}; {} visited {}; finding:{}{}{}\n", place,
          yes_or_no(r.touches != 0), yes_or_no(r.crosses != 0), owns, shown(entry->name),
          yes_or_no(r.visited != 0), findings.empty() ? " none" : findings,
          r.answer.empty() || !r.thrown.empty() ? "" : "; " + r.answer, written);
  }
  if (stretches.done() < cases->size())
    return interrupted() ? ended_by_signal : refused;
  if (!options.checks.any())
    return any ? found : done;
  report.seconds = stretches.seconds();
  compare_with_known(options.checks, report, std::nullopt);
  if (options.json && options.checks.known)
    print("{{\"baseline\":{}}}\n", standings_json(report));
  const int code = conclude(options.checks, report, std::nullopt, lines, !options.json);
  return code == done && disagreed ? static_cast<int>(found) : code;
}

} // namespace

subcommand replay_command(CLI::App& app) {
  const auto options = std::make_shared<replay_options>();
  replay_options& o = *options;
  CLI::App* c = app.add_subcommand("replay", "Judge the rays of files again, by rationals");
  c->footer(R"(
Examples:
  graze-fuzz replay miss.jsonl --command "python3 mine.py"
  graze-fuzz replay rays/ more.jsonl --command ./mine --junit results.xml
  graze-fuzz replay rays/ --command ./mine --write-baseline known.json   what is known to be wrong
  graze-fuzz replay rays/ --command ./mine --baseline known.json         fails on what is new
  (in a CI: docs/ci.md)

Exit code: 0 no finding (no new one, with --baseline), 1 a finding, 2 bad input or a failure, 130 ended
by a signal.)");
  c->add_option(
       "files", o.files,
       "JSON lines; - is standard input; of a folder its .jsonl and .json files, in the order of "
       "their names; of a campaign's folder its findings")
      ->required();
  CLI::Option* named =
      c->add_option("--traversal", o.name, "What is under test")->capture_default_str();
  add_traversal_options(*c, *named, o.traversal);
  c->add_option("--reproducer", o.reproducer, reproducer_option);
  add_language_option(*c, o.language);
  CLI::Option* json = c->add_flag("--json", o.json, "Print one JSON object a line");
  add_check_options(*c, *json, o.checks);
  return {c, [options] { return replay_files(*options); }};
}

} // namespace graze::fuzz
