/// The command line of graze-fuzz. Exit codes: 0 nothing found, 1 a finding, 2 bad input or a failure.
#include <CLI/CLI.hpp>
#include <campaign/store.hpp>
#include <cli/campaign_command.hpp>
#include <cli/self_command.hpp>
#include <cmath>
#include <external/libraries.hpp>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <graze/support/program.hpp>
#include <graze/support/progress.hpp>
#include <graze/support/text.hpp>
#include <judge/replay.hpp>
#include <report/report.hpp>
#include <report/reproducer/reproducer.hpp>

#include <cli/traversal_options.hpp>

namespace {

using namespace graze::fuzz;
using namespace graze::support;

const char* const examples = R"(
Examples:
  graze-fuzz run                                        five seconds on the sound traversal
  graze-fuzz run --traversal published --level 50       finds a ray that misses an octant
  graze-fuzz run --traversal gargantini --save miss.jsonl
  graze-fuzz replay miss.jsonl --traversal gargantini   says again, by rationals, what is missed
  graze-fuzz run --command "python3 my_traversal.py"    a traversal of your own: docs/adapters.md
  graze-fuzz run --traversal published --reproducer out what a maintainer is handed: text, C++, SVG
  graze-fuzz list

Exit code: 0 nothing found, 1 a finding, 2 bad input or a failure (memory, files, output), 130 ended
by a signal before there was a result.)";

struct run_options {
  std::string traversal = "sound";
  std::vector<std::string> generators{"all"};
  std::string level = "50";
  double seconds = 0;
  std::uint64_t rays = 0;
  std::uint64_t first_ray = 0;
  std::string search = "generators";
  bool until_finding = false;
  std::uint64_t seed = 1;
  unsigned threads = default_threads();
  std::string save;
  command_options command;
  std::string reproducer; ///< a folder
  bool json = false;
  bool progress = false;
  bool no_shrink = false;
};

struct replay_options {
  std::string file;
  std::string traversal = "sound";
  command_options command;
  std::string reproducer; ///< a folder
  bool json = false;
};

int run(const run_options& options) {
  campaign_plan plan;
  for (const std::string& name : options.generators) {
    if (name == "all") {
      for (const generator& g : generators())
        plan.generators.push_back(&g);
      continue;
    }
    const generator* g = find_generator(name);
    if (g == nullptr)
      return bad_input(fmt::format("no generator is called \"{}\" (see graze-fuzz list)", name));
    plan.generators.push_back(g);
  }
  if (!read_levels(options.level, plan))
    return bad_input(
        fmt::format("level {} is outside 1..53 (a number, or a range A-B)", options.level));
  if (!std::isfinite(options.seconds) || options.seconds < 0)
    return bad_input("--seconds is not a finite number of seconds, 0 or more");
  if (options.threads < 1 || options.threads > most_threads)
    return bad_input("--threads is outside 1..1024");
  if (!options.save.empty())
    if (const status may = check_writable(options.save); !may)
      return bad_input(may.reason());
  const auto entry = chosen_traversal(options.traversal, options.command, false);
  if (!entry)
    return bad_input(entry.reason());
  plan.under_test = &*entry;
  if (!options.reproducer.empty())
    if (const status may = prepare_folder(options.reproducer); !may)
      return bad_input(may.reason());
  plan.seed = options.seed;
  plan.threads = options.threads;
  plan.rays = options.rays;
  plan.first_ray = options.first_ray;
  plan.by = *search_of(options.search);
  plan.until_finding = options.until_finding;
  plan.seconds = options.seconds == 0 && options.rays == 0 ? 5 : options.seconds;

  listen_for_interrupts();
  progress_line line("rays", options.progress);
  std::function<void(std::uint64_t, double)> show;
  if (line.is_shown())
    show = [&](std::uint64_t rays, double seconds) {
      line.show({rays, plan.rays, seconds, plan.seconds});
    };
  const campaign_result result = run_campaign(plan, stop_wanted, show);
  if (result.worst_finding() && !options.no_shrink)
    line.note("shrinking what was found, for at most 10 s");
  const std::optional<counterexample> found =
      counterexample_of(plan, result, !options.no_shrink, &stop_wanted);
  end_is_orderly();
  line.clear();
  if (options.json) {
    print("{}\n", to_json(plan, result, found));
  } else {
    print("{} at level {}, seed {}: {} rays in {:.2f} s, {:.0f} rays/s{}\n{}",
          shown(plan.under_test->name), options.level, plan.seed, result.total.rays, result.seconds,
          static_cast<double>(result.total.rays) / result.seconds,
          result.interrupted ? " (interrupted)" : "", table(plan, result));
    if (result.first_miss_seconds)
      print("first miss after {:.6f} s\n", *result.first_miss_seconds);
    print("{}", found ? describe(plan, result, *found) : std::string("nothing found\n"));
  }
  if (found && !options.save.empty())
    if (const status written = write_atomically(options.save, to_json_line(found->shrunk) + '\n');
        !written)
      return bad_input(written.reason());
  if (found && !options.reproducer.empty()) {
    const auto written =
        write_reproducer(reproduction_of(found->shrunk, *plan.under_test->guarded(), found->kind,
                                         entry->asked_for()),
                         options.reproducer);
    if (!written)
      return bad_input(written.reason());
    if (!options.json)
      print("reproducer: {}.json .txt .cpp .svg\n", *written);
  }
  return found ? exit_code::found : done;
}

std::string yes(bool b) { return b ? "yes" : "no"; }

int replay_file(const replay_options& options) {
  const auto cases = read_replay_file(options.file);
  if (!cases)
    return bad_input(cases.reason());
  const auto entry = chosen_traversal(options.traversal, options.command, true);
  if (!entry)
    return bad_input(entry.reason());
  if (!options.reproducer.empty())
    if (const status may = prepare_folder(options.reproducer); !may)
      return bad_input(may.reason());
  listen_for_interrupts();
  const auto under_test = entry->guarded();
  bool any = false;
  for (const replay_case& c : *cases) {
    if (stop_wanted)
      return interrupted() ? ended_by_signal : refused;
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
          yes(r.touches != 0), yes(r.crosses != 0), yes(r.owns != 0), shown(entry->name),
          yes(r.visited != 0), findings.empty() ? " none" : findings, written);
  }
  return any ? found : done;
}

int list() {
  print("traversals\n");
  for (const traversal_entry& e : traversals())
    print("  {:<31} {}\n", e.name, e.summary);
  print("traversals of others\n");
  const std::vector<traversal_entry> libraries = library_traversals();
  for (const auto* entries : {&adapters(), &linked_traversals(), &libraries})
    for (const traversal_entry& e : *entries)
      print("  {:<31} {}\n", e.name, e.summary);
  print("traversals that are wrong on purpose\n");
  for (const traversal_entry& e : mutants())
    print("  {:<31} {}\n", e.name, e.summary);
  print("generators\n");
  for (const generator& g : generators())
    print("  {:<31} {}\n", g.name, g.summary);
  return 0;
}

int start(int argc, char** argv) {
  CLI::App app{"Finds octants that a ray traversal misses, with an exact oracle."};
  app.footer(examples);
  app.require_subcommand(1);

  run_options run_with;
  CLI::App* run_command = app.add_subcommand("run", "Search for missed octants");
  CLI::Option* run_named =
      run_command->add_option("--traversal", run_with.traversal, "What is under test")
          ->capture_default_str();
  add_command_options(*run_command, *run_named, run_with.command);
  run_command
      ->add_option("--level", run_with.level,
                   "Level of the octants, 1 to 53, or a range taken in turn: 1-50")
      ->capture_default_str();
  run_command->add_option("--generator", run_with.generators, "Names of generators, or all")
      ->delimiter(',')
      ->capture_default_str();
  run_command
      ->add_option("--search", run_with.search,
                   "generators: their rays; climb: from their rays towards the smallest margin")
      ->check(CLI::IsMember({"generators", "climb"}))
      ->capture_default_str();
  run_command->add_flag("--until-finding", run_with.until_finding, "End at the first finding");
  run_command->add_option("--seconds", run_with.seconds,
                          "Budget of time (5, if no budget is given)");
  run_command->add_option("--rays", run_with.rays, "Budget of rays")->check(whole_number());
  run_command->add_option("--first-ray", run_with.first_ray, "Number of the first ray")
      ->check(whole_number())
      ->capture_default_str();
  run_command->add_option("--seed", run_with.seed, "Ray k of a seed is always the same ray")
      ->check(whole_number())
      ->capture_default_str();
  run_command->add_option("--threads", run_with.threads, "Threads")->capture_default_str();
  run_command->add_option("--save", run_with.save,
                          "Write the shrunk counterexample to this replay file");
  const char* const folder =
      "Write the shrunk counterexample to this folder: replay line, text, C++ snippet, picture";
  run_command->add_option("--reproducer", run_with.reproducer, folder);
  run_command->add_flag("--no-shrink", run_with.no_shrink,
                        "Tell the ray as it was found: at once, where asking again takes long");
  run_command->add_flag("--json", run_with.json, "Print one JSON object");
  run_command->add_flag("--progress", run_with.progress,
                        "Show progress even if stderr is not a terminal");

  replay_options replay_with;
  CLI::App* replay_command =
      app.add_subcommand("replay", "Judge the rays of a file again, by rationals");
  replay_command->add_option("file", replay_with.file, "JSON lines; - is standard input")
      ->required();
  CLI::Option* replay_named =
      replay_command->add_option("--traversal", replay_with.traversal, "What is under test")
          ->capture_default_str();
  add_command_options(*replay_command, *replay_named, replay_with.command);
  replay_command->add_option("--reproducer", replay_with.reproducer, folder);
  replay_command->add_flag("--json", replay_with.json, "Print one JSON object a line");

  const campaign_commands campaigns(app);
  const self_command self(app);

  CLI::App* list_command = app.add_subcommand("list", "Names of traversals and generators");

  if (const auto code = parse_arguments(app, argc, argv))
    return *code;
  if (run_command->parsed())
    return run(run_with);
  if (replay_command->parsed())
    return replay_file(replay_with);
  if (const auto code = campaigns.run())
    return *code;
  if (const auto code = self.run())
    return *code;
  if (list_command->parsed())
    return list();
  return refused;
}

} // namespace

int main(int argc, char** argv) { return run_program("graze-fuzz", argc, argv, start); }
