#include <campaign/counterexample.hpp>
#include <cli/commands.hpp>
#include <cli/traversal_options.hpp>
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
  map_choice scene;
  std::uint64_t first_ray = 0;
  bool until_finding = false;
  unsigned threads = default_threads();
  std::string save;
  std::string reproducer; ///< a folder
  bool json = false;
  bool progress = false;
  bool no_shrink = false;
};

int run(const run_options& options) {
  listen_for_interrupts(); // an adapter may take long to begin
  named_plan named = options.plan;
  named.generators = all_named(named.generators);
  const auto scene = map_of(options.scene);
  if (!scene)
    return bad_input(scene.reason());
  named.scene = *scene;
  auto plan = resolve_rays(named);
  if (!plan)
    return bad_input(plan.reason());
  plan->workers = options.threads;
  if (const status well = check(*plan); !well)
    return bad_input(well.reason());
  if (!options.save.empty())
    if (const status may = check_writable(options.save); !may)
      return bad_input(may.reason());
  traversal_options chosen = options.traversal;
  if (const status read = load_map(named, *plan, chosen.external); !read)
    return bad_input(read.reason());
  if (plan->scene.map && !options.json)
    print("{}: {}\n", shown(options.scene.path), plan->scene.map->about);
  const auto under_test = chosen_traversal(named.traversal, chosen, false);
  if (!under_test)
    return bad_input(under_test.reason());
  plan->under_test = *under_test;
  if (plan->scene.map)
    if (const status takes = check(*under_test->make(), plan->scene); !takes)
      return bad_input(takes.reason());
  if (!options.reproducer.empty())
    if (const status may = prepare_folder(options.reproducer); !may)
      return bad_input(may.reason());
  plan->first = options.first_ray;
  plan->until_finding = options.until_finding;
  limit(*plan);

  progress_line line("rays", options.progress);
  const campaign_result result = run_campaign(*plan, stop_wanted, shown_on(line, *plan));
  if (result.worst_finding() && !options.no_shrink)
    line.note("shrinking what was found, for at most 10 s");
  const std::optional<counterexample> example =
      counterexample_of(*plan, result, !options.no_shrink, &stop_wanted);
  end_is_orderly();
  line.clear();
  if (options.json) {
    print("{}\n", to_json(*plan, result, example));
  } else {
    print("{} at level {}, seed {}: {} rays in {:.2f} s, {:.0f} rays/s{}\n{}",
          shown(plan->under_test.name), named.level, plan->seed, result.total.rays, result.seconds,
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
  if (example && !options.reproducer.empty()) {
    const auto written =
        write_reproducer(reproduction_of(example->shrunk, *plan->under_test.guarded(),
                                         example->kind, plan->under_test.asked_for()),
                         options.reproducer);
    if (!written)
      return bad_input(written.reason());
    if (!options.json)
      print("reproducer: {}.json .txt .cpp .svg\n", *written);
  }
  return example ? found : done;
}

} // namespace

subcommand run_command(CLI::App& app) {
  const auto options = std::make_shared<run_options>();
  run_options& o = *options;
  o.plan.generators = {"all"};
  CLI::App* c = app.add_subcommand("run", "Search for missed octants");
  CLI::Option* named =
      c->add_option("--traversal", o.plan.traversal, "What is under test")->capture_default_str();
  add_traversal_options(*c, *named, o.traversal);
  add_map_options(*c, o.scene);
  c->add_option("--level", o.plan.level,
                "Level of the octants, 1 to 53, or a range taken in turn: 1-50")
      ->capture_default_str();
  c->add_option("--generator", o.plan.generators, "Names of generators, or all")
      ->delimiter(',')
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
  c->add_option("--reproducer", o.reproducer, reproducer_option);
  c->add_flag("--no-shrink", o.no_shrink,
              "Tell the ray as it was found: at once, where asking again takes long");
  c->add_flag("--json", o.json, "Print one JSON object");
  c->add_flag("--progress", o.progress, "Show progress even if stderr is not a terminal");

  return {c, [options] { return run(*options); }};
}

} // namespace graze::fuzz
