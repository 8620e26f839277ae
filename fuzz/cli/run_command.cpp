#include <campaign/counterexample.hpp>
#include <campaign/store.hpp>
#include <cli/check_options.hpp>
#include <cli/commands.hpp>
#include <cli/scene_options.hpp>
#include <cli/traversal_options.hpp>
#include <filesystem>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <report/report.hpp>
#include <report/reproducer/reproducer.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

namespace {

using namespace support;

struct run_options {
  named_plan plan;
  traversal_options traversal;
  scene_options scene;
  std::uint64_t first_ray = 0;
  bool until_finding = false;
  unsigned threads = default_threads();
  std::vector<std::string> except;
  std::string save;
  std::string save_all;   ///< a folder
  std::string reproducer; ///< a folder
  std::string language;
  bool json = false;
  bool progress = false;
  bool no_shrink = false;
  check_options checks;
};

/// Of the foremost kind, or of every kind.
std::vector<counterexample> examples_of(const campaign_plan& plan, const campaign_result& result,
                                        bool shrink_them, bool every_kind) {
  if (every_kind)
    return counterexamples_of(plan, result, shrink_them, &stop_wanted);
  const auto one = counterexample_of(plan, result, shrink_them, &stop_wanted);
  return one ? std::vector{*one} : std::vector<counterexample>();
}

std::string saved_file(const std::string& folder, finding kind) {
  return (std::filesystem::path(folder) / fmt::format("{}.jsonl", name_of(kind))).string();
}

/// A check for each kind of finding, with what shows it.
check_report report_of(const run_options& options, const campaign_plan& plan,
                       const campaign_result& result, const std::vector<counterexample>& examples) {
  check_report report = checks_of("run", campaign_of(plan, result.total), result.seconds);
  const std::string source = file_of_command(options.traversal.external.command);
  for (check_result& c : report.checks)
    for (problem& p : c.problems) {
      p.details = fmt::format("again: {}\n", command_of(plan, *first_ray(result, p.kind)));
      p.file = source;
      if (!options.save_all.empty())
        p.file = saved_file(options.save_all, p.kind);
      for (const counterexample& e : examples)
        if (e.kind == p.kind) {
          p.ray = to_json_line(e.shrunk);
          p.details += fmt::format("replay: {}\n", replay_command(plan, e));
          if (options.save_all.empty() && !options.save.empty())
            p.file = options.save;
        }
    }
  return report;
}

int run(run_options& options) {
  listen_for_interrupts(); // an adapter may take long to begin
  named_plan named = options.plan;
  auto generators = all_named(named.generators, options.except);
  if (!generators)
    return bad_input(generators.reason());
  named.generators = *std::move(generators);
  if (const status well = take_scene(options.scene, named, options.traversal.external); !well)
    return bad_input(well.reason());
  auto plan = resolve_rays(named);
  if (!plan)
    return bad_input(plan.reason());
  plan->workers = options.threads;
  if (const status well = check(*plan); !well)
    return bad_input(well.reason());
  if (!options.save.empty())
    if (const status may = check_writable(options.save); !may)
      return bad_input(may.reason());
  if (const status may = prepare(options.checks); !may)
    return bad_input(may.reason());
  if (const status read = load_map(named, *plan, options.traversal.external); !read)
    return bad_input(read.reason());
  if (plan->scene.map && !options.json)
    print("{}: {}\n", shown(named.scene->path), plan->scene.map->about);
  const auto under_test = chosen_traversal(named.traversal, options.traversal, false);
  if (!under_test)
    return bad_input(under_test.reason());
  plan->under_test = *under_test;
  {
    const auto tried = under_test->guarded();
    take_scene_of(*tried, options.scene, named);
    plan->scene = resolve_rays(named)->scene;
    if (const status read = load_map(named, *plan, options.traversal.external); !read)
      return bad_input(read.reason());
    if (const status may = check(*tried, plan->scene); !may)
      return bad_input(may.reason());
  }
  for (const std::string& folder : {options.save_all, options.reproducer})
    if (!folder.empty())
      if (const status may = prepare_folder(folder); !may)
        return bad_input(may.reason());
  plan->first = options.first_ray;
  plan->grid_file = options.scene.grid;
  plan->until_finding = options.until_finding;
  limit(*plan);

  progress_line line("rays", options.progress);
  const campaign_result result = run_campaign(*plan, stop_wanted, shown_on(line, *plan));
  const bool any = result.foremost().has_value();
  if (any && !options.no_shrink)
    line.note(options.save_all.empty() ? "shrinking what was found, for at most 10 s"
                                       : "shrinking what was found, for at most 10 s a kind");
  const std::vector<counterexample> examples =
      examples_of(*plan, result, !options.no_shrink, !options.save_all.empty());
  const std::optional<counterexample> example =
      any ? std::optional(examples.front()) : std::nullopt;
  end_is_orderly();
  line.clear();
  check_report report = report_of(options, *plan, result, examples);
  compare_with_known(options.checks, report, campaign_of(*plan, result.total));
  if (options.json) {
    print("{}\n", to_json(*plan, result, example, options.checks.known ? &report : nullptr));
  } else {
    print("{}{}, seed {}: {} rays in {:.2f} s, {:.0f} rays/s{}\n{}", shown(plan->under_test.name),
          plan->scene.cells == cell_kind::cube ? fmt::format(" at level {}", named.level) : "",
          plan->seed, result.total.rays, result.seconds,
          static_cast<double>(result.total.rays) / result.seconds,
          result.interrupted ? " (interrupted)" : "", table(*plan, result));
    if (result.first_miss_seconds)
      print("first miss after {:.6f} s\n", *result.first_miss_seconds);
    print("{}", example ? describe(*plan, result, *example) : std::string("nothing found\n"));
  }
  if (example && !options.save.empty())
    if (const status written = write_atomically(options.save, to_json_line(example->shrunk) + '\n');
        !written)
      return bad_input(written.reason());
  if (!options.save_all.empty())
    for (const counterexample& c : examples)
      if (const status written =
              write_atomically(saved_file(options.save_all, c.kind),
                               file_of(c.kind, plan->under_test.name, c.shrunk).line + '\n');
          !written)
        return bad_input(written.reason());
  if (!options.reproducer.empty())
    for (const counterexample& c : examples) {
      const reader_of_test reader =
          reader_of(options.language, options.traversal, plan->under_test);
      reproduction shown_again = reproduction_of(c.shrunk, *plan->under_test.guarded(), c.kind,
                                                 plan->under_test.asked_for());
      shown_again.external = reader.external;
      const auto written = write_reproducer(shown_again, options.reproducer, reader.written);
      if (!written)
        return bad_input(written.reason());
      if (!options.json)
        print("reproducer: {}\n", written->spelled());
      tell_of_test(*written);
    }
  if (!options.checks.any())
    return example ? found : done;
  std::map<std::string, finding_set> lines;
  if (!options.checks.write_baseline.empty()) {
    const auto again = plan->under_test.guarded();
    for (const counterexample& c : examples)
      lines[to_json_line(c.shrunk)] = bit(c.kind) | replay(c.shrunk, *again).findings;
  }
  return conclude(options.checks, report, campaign_of(*plan, result.total), lines, !options.json);
}

} // namespace

subcommand run_command(CLI::App& app) {
  const auto options = std::make_shared<run_options>();
  run_options& o = *options;
  o.plan.generators = {"all"};
  CLI::App* c = app.add_subcommand("run", "Search for missed octants");
  c->footer(R"(
Examples:
  graze-fuzz run --level 10 --command "python3 mine.py" --tame     rays as an owner has them
  graze-fuzz run --level 10 --command "python3 mine.py" --except huge,subnormal
  graze-fuzz run ... --rays 100000 --seed 1 --write-baseline known.json     what is known to be wrong
  graze-fuzz run ... --rays 100000 --seed 1 --baseline known.json --github  fails on what is new or more
  graze-fuzz run ... --save-all DIR --reproducer DIR               each kind that was found
  (in a CI: docs/ci.md)

Exit code: 0 nothing found (nothing new or more, with --baseline), 1 a finding, 2 bad input or a failure,
130 ended by a signal before there was a result.)");
  CLI::Option* named =
      c->add_option("--traversal", o.plan.traversal, "What is under test")->capture_default_str();
  add_traversal_options(*c, *named, o.traversal);
  add_scene_options(*c, o.scene);
  c->add_option("--level", o.plan.level,
                "Level of the octants, 1 to 53, or a range taken in turn: 1-50")
      ->capture_default_str();
  c->add_option("--generator", o.plan.generators, "Names of generators, or all")
      ->delimiter(',')
      ->capture_default_str();
  c->add_option("--except", o.except, except_option)->delimiter(',');
  c->add_flag("--tame", o.plan.tame, tame_option);
  c->add_option("--hangs", o.plan.hangs, hangs_option)
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--search", o.plan.search,
                "generators: their rays; climb: from their rays towards the smallest margin")
      ->check(CLI::IsMember({"generators", "climb"}))
      ->capture_default_str();
  c->add_flag("--until-finding", o.until_finding, "End at the first finding");
  c->add_option("--seconds", o.plan.seconds, "Budget of time (5, if no budget is given)");
  c->add_option("--rays", o.plan.rays, "Budget of rays")->check(whole_number());
  c->add_option("--first-ray", o.first_ray, "Number of the first ray")
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--seed", o.plan.seed, "Ray k of a seed is always the same ray")
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--threads", o.threads, "Threads")->capture_default_str();
  c->add_option("--save", o.save, "Write the shrunk counterexample to this replay file");
  c->add_option(
      "--save-all", o.save_all,
      "Write a shrunk counterexample of each kind to this folder: KIND.jsonl; with --reproducer, "
      "a reproducer of each kind as well");
  c->add_option("--reproducer", o.reproducer, reproducer_option);
  add_language_option(*c, o.language);
  c->add_flag("--no-shrink", o.no_shrink,
              "Tell the ray as it was found: at once, where asking again takes long");
  CLI::Option* json = c->add_flag("--json", o.json, "Print one JSON object");
  add_check_options(*c, *json, o.checks);
  c->add_flag("--progress", o.progress, "Show progress even if stderr is not a terminal");

  return {c, [options] { return run(*options); }};
}

} // namespace graze::fuzz
