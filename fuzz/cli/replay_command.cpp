#include <cli/commands.hpp>
#include <cli/traversal_options.hpp>
#include <external/maps.hpp>
#include <graze/support/text.hpp>
#include <judge/replay.hpp>
#include <report/reproducer/reproducer.hpp>

namespace graze::fuzz {

namespace {

using namespace support;

struct replay_options {
  std::string file;
  std::string name = "sound";
  traversal_options traversal;
  std::string reproducer; ///< a folder
  bool json = false;
};

std::string yes_or_no(bool b) { return b ? "yes" : "no"; }

int replay_file(const replay_options& options) {
  listen_for_interrupts();
  const auto cases = read_replay_file(options.file, known_map);
  if (!cases)
    return bad_input(cases.reason());
  traversal_options chosen = options.traversal;
  chosen.external.map = cases->front().at.map; // all cases of one map
  for (const replay_case& c : *cases)
    if (c.at.map != chosen.external.map)
      return bad_input(fmt::format("line {}: it is of another map than the first: ask about one at "
                                   "a time",
                                   c.line));
  if (chosen.external.map)
    chosen.external.usual_cells = cell_kind::grid;
  const auto entry = chosen_traversal(options.name, chosen, true);
  if (!entry)
    return bad_input(entry.reason());
  if (!options.reproducer.empty())
    if (const status may = prepare_folder(options.reproducer); !may)
      return bad_input(may.reason());
  const auto under_test = entry->guarded();
  bool any = false;
  schedule stretches({.trials = cases->size()}, 1, stop_wanted);
  while (const auto taken = stretches.take()) {
    stretches.count(1);
    const replay_case& c = (*cases)[taken->begin];
    const replay_result r = replay(c.at, *under_test);
    any = any || r.findings != 0 || !r.oracles_agree;
    if (!r.oracles_agree)
      complain(fmt::format("line {}: the two oracles disagree: a bug of graze", c.line));
    std::string written;
    if (r.findings != 0 && !options.reproducer.empty()) {
      const auto path = write_reproducer(c.at, *under_test, worst(r.findings), entry->asked_for(),
                                         options.reproducer);
      if (!path)
        return bad_input(path.reason());
      written = fmt::format("; reproducer: {}.json .txt .cpp .svg", *path);
    }
    if (options.json) {
      print("{}\n", to_json_line(c, r, entry->name));
      continue;
    }
    std::string findings;
    for (unsigned k = 0; k < finding_kinds; ++k)
      if ((r.findings >> k & 1) != 0)
        findings += fmt::format(" {}", name_of(static_cast<finding>(k)));
    if (r.declined) {
      print("line {}: declined by {}, not judged\n", c.line, shown(entry->name));
      continue;
    }
    if (!r.thrown.empty())
      findings += fmt::format(" ({})", r.thrown);
    print("line {}: touches {}, crosses {}, owns {}; {} visited {}; finding:{}{}\n", c.line,
          yes_or_no(r.touches != 0), yes_or_no(r.crosses != 0), yes_or_no(r.owns != 0),
          shown(entry->name), yes_or_no(r.visited != 0), findings.empty() ? " none" : findings,
          written);
  }
  if (stretches.done() < cases->size())
    return interrupted() ? ended_by_signal : refused;
  return any ? found : done;
}

} // namespace

subcommand replay_command(CLI::App& app) {
  const auto options = std::make_shared<replay_options>();
  replay_options& o = *options;
  CLI::App* c = app.add_subcommand("replay", "Judge the rays of a file again, by rationals");
  c->add_option("file", o.file, "JSON lines; - is standard input")->required();
  CLI::Option* named =
      c->add_option("--traversal", o.name, "What is under test")->capture_default_str();
  add_traversal_options(*c, *named, o.traversal);
  c->add_option("--reproducer", o.reproducer, reproducer_option);
  c->add_flag("--json", o.json, "Print one JSON object a line");
  return {c, [options] { return replay_file(*options); }};
}

} // namespace graze::fuzz
