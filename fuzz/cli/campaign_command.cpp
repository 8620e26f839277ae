#include <algorithm>
#include <array>
#include <campaign/lasting.hpp>
#include <charconv>
#include <cli/check_options.hpp>
#include <cli/commands.hpp>
#include <cli/scene_options.hpp>
#include <cli/traversal_options.hpp>
#include <external/libraries.hpp>
#include <external/maps.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <judge/replay.hpp>
#include <nlohmann/json.hpp>
#include <report/summary.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

using namespace support;

namespace {

struct campaign_options {
  CLI::App* app = nullptr;
  stored_plan plan;
  traversal_options traversal;
  scene_options scene;
  std::string folder;
  std::vector<std::string> generators, except;
  std::string shard = "1/1";
  unsigned threads = default_threads();
  bool json = false;
  bool progress = false;
  check_options checks;
};

struct summary_options {
  check_options checks;
  std::vector<std::string> folders;
  std::string html;
  bool json = false;
};

using json = nlohmann::ordered_json;

/// "i/N", 1 <= i <= N.
bool read_shard(std::string_view text, stored_plan& plan) {
  const char* const end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, plan.shard);
  if (first != std::errc() || slash == end || *slash != '/')
    return false;
  const auto [last, second] = std::from_chars(slash + 1, end, plan.shards);
  return second == std::errc() && last == end && 1 <= plan.shard && plan.shard <= plan.shards;
}

/// The members of the plan that the command line gives.
std::vector<std::string> given_members(const CLI::App& campaign) {
  constexpr std::array<std::pair<const char*, const char*>, 15> members{
      {{"--traversal", "traversal"},
       {"--generator", "generators"},
       {"--except", "generators"},
       {"--tame", "tame"},
       {"--hangs", "hangs"},
       {"--search", "search"},
       {"--level", "level"},
       {"--cells", "cells"},
       {"--segments", "segments"},
       {"--grid", "grid"},
       {"--scene", "scene"},
       {"--seed", "seed"},
       {"--rays", "rays"},
       {"--seconds", "seconds"},
       {"--piece", "piece"}}};
  std::vector<std::string> given;
  for (const auto& [option, member] : members)
    if (campaign.count(option) != 0)
      given.emplace_back(member);
  if (campaign.count("--command") != 0)
    given.insert(given.end(), {"traversal", "external"});
  if (campaign.count("--shard") != 0)
    given.insert(given.end(), {"shard", "shards"});
  return given;
}

/// A check for each kind of finding, with the simplest of its files.
check_report report_of(const merged_campaign& merged, const campaign_plan& plan) {
  const counts total = merged.state.total();
  check_report report = checks_of("campaign", campaign_of(plan, total), merged.state.elapsed);
  for (check_result& c : report.checks)
    for (problem& p : c.problems)
      for (const auto& [hash, known] : merged.state.findings) {
        if (known.kind != p.kind)
          continue;
        const std::string& file = merged.files.at(hash);
        p.details += fmt::format("replay: graze-fuzz replay {} {}\n", shell_word(file),
                                 plan.under_test.asked_for());
        if (!p.file.empty())
          continue;
        p.file = file;
        if (const auto cases = read_replay_file(file))
          p.ray = to_json_line(cases->front().at);
      }
  return report;
}

/// The replay lines of a campaign's findings with all kinds that they show: the traversal is asked again.
expected<std::map<std::string, finding_set>> lines_of(const merged_campaign& merged,
                                                      const campaign_plan& plan) {
  const auto entry = merged.plan.external ? external_traversal(*merged.plan.external)
                                          : expected<traversal_entry>(plan.under_test);
  if (!entry)
    return unexpected{entry.reason()};
  const auto under_test = entry->guarded();
  std::map<std::string, finding_set> lines;
  for (const auto& [hash, known] : merged.state.findings)
    if (const auto cases = read_replay_file(merged.files.at(hash)); cases && !stop_wanted) {
      const trial& t = cases->front().at;
      lines[to_json_line(t)] |= bit(known.kind) | replay(t, *under_test).findings;
    }
  return lines;
}

/// Prints what `folders` hold together, and writes the page.
int summarize(const std::vector<std::string>& folders, const std::string& page, bool as_json,
              const check_options& checks) {
  const auto merged = merge_campaigns(folders);
  if (!merged)
    return bad_input(merged.reason());
  const auto plan = resolve(merged->plan);
  if (!plan)
    return bad_input(plan.reason());
  if (merged->lost != 0)
    complain(fmt::format("{} of {} findings have lost their file in findings/", merged->lost,
                         merged->state.findings.size()));
  const std::string page_folder = std::filesystem::path(page).parent_path();
  const std::string text = to_html(*merged, *plan, page_folder.empty() ? "." : page_folder);
  if (const status written = write_atomically(page, text); !written)
    return bad_input(written.reason());
  check_report report = report_of(*merged, *plan);
  const known_campaign now = campaign_of(*plan, merged->state.total());
  compare_with_known(checks, report, now);
  if (as_json) {
    auto line = json::parse(to_json(*merged, *plan));
    line["event"] = "end";
    if (checks.known)
      line["baseline"] = json::parse(standings_json(report));
    line["page"] = page;
    print("{}\n", json_line(line));
  } else {
    print("{}page: {}\n", to_text(*merged, *plan), shown(page, 1000));
  }
  if (!checks.any())
    return merged->state.findings.empty() ? done : found;
  std::map<std::string, finding_set> lines;
  if (!checks.write_baseline.empty()) {
    auto shown = lines_of(*merged, *plan);
    if (!shown)
      return bad_input(shown.reason());
    lines = *std::move(shown);
  }
  return conclude(checks, report, now, lines, !as_json);
}

int campaign(campaign_options& options) {
  listen_for_interrupts();
  if (!read_shard(options.shard, options.plan))
    return bad_input(fmt::format("shard {} is not i/N with 1 <= i <= N", options.shard));
  if (const status well = check({.workers = options.threads}); !well)
    return bad_input(well.reason());
  if (options.generators.empty() && !options.except.empty())
    options.generators = {"all"};
  auto generators = all_named(options.generators, options.except);
  if (!generators)
    return bad_input(generators.reason());
  options.plan.generators = *std::move(generators);
  if (const status may = prepare(options.checks); !may)
    return bad_input(may.reason());
  if (const status well = take_scene(options.scene, options.plan, options.traversal.external);
      !well)
    return bad_input(well.reason());
  if (options.plan.scene) { // a folder is gone on with from any other
    options.plan.scene->path = whole_path(*options.plan.scene);
    const auto map = known_map(*options.plan.scene);
    if (!map)
      return bad_input(map.reason());
    options.traversal.external.map = *map;
    options.traversal.external.usual_cells = cell_kind::grid;
  }
  expected<traversal_entry> started = unexpected{std::string()};
  if (options.traversal.external.command.empty()) {
    if (options.app->count("--timeout") != 0)
      return bad_input("--timeout needs --command in a campaign");
  } else {
    auto external = external_of(options.traversal);
    if (!external)
      return bad_input(external.reason());
    if (utf8(external->command) != external->command)
      return bad_input("the command is not UTF-8, in which plan.json would hold it");
    options.plan.traversal = external->command;
    options.plan.external = *external;
    if (started = tried_traversal(*external); !started)
      return bad_input(started.reason());
    take_scene_of(*started->guarded(), options.scene, options.plan);
  }
  auto store = campaign_store::open(options.folder, options.plan, given_members(*options.app));
  if (!store)
    return bad_input(store.reason());
  auto plan = resolve(store->plan());
  if (!plan)
    return bad_input(plan.reason());
  external_options like = store->plan().external.value_or(external_options{});
  if (const status read = load_map(store->plan(), *plan, like); !read)
    return bad_input(read.reason());
  if (store->plan().scene && !store->plan().external) {
    const auto named = named_traversal(store->plan().traversal, like);
    if (!named)
      return bad_input(named.reason());
    plan->under_test = *named;
    if (const status may = check(*named->guarded(), plan->scene); !may)
      return bad_input(may.reason());
  }
  if (store->plan().external) {
    if (!started)
      started = tried_traversal(like);
    if (!started)
      return bad_input(started.reason());
    plan->under_test = *started;
    if (const status may = check(*started->guarded(), plan->scene); !may)
      return bad_input(may.reason());
  }
  plan->workers = options.threads;
  const stored_plan& stored = store->plan();
  const std::uint64_t rays_before = store->state().total().rays;
  const double seconds_before = store->state().elapsed;
  if (options.json)
    print("{}\n",
          json_line(json{{"event", "start"},
                         {"traversal", stored.traversal},
                         {"level", stored.level},
                         {"seed", stored.seed},
                         {"shard", stored.shard},
                         {"shards", stored.shards},
                         {"rays_done", rays_before},
                         {"rays_planned", stored.rays == 0 ? json() : json(stored.shard_rays())}}));
  else
    print("{}: {} at level {}, seed {}, shard {}/{}{}\n", shown(store->folder(), 1000),
          shown(stored.traversal), stored.level, stored.seed, stored.shard, stored.shards,
          store->resumed() ? fmt::format(", goes on after {} rays", rays_before) : std::string());
  flush_output();

  progress_line progress("rays", options.progress);
  campaign_listener listener;
  listener.piece = [&](const finished_piece& p) {
    if (options.json) {
      auto line = json::parse(to_json_line(p));
      line.erase("counts");
      line["event"] = "piece";
      line["rays_done"] = store->state().total().rays;
      print("{}\n", json_line(line));
      flush_output();
    }
    const campaign_state& state = store->state();
    if (progress.is_shown())
      progress.show({state.total().rays, stored.shard_rays(), state.elapsed, stored.seconds,
                     rays_before, seconds_before},
                    {}, fmt::format("  {} findings", state.findings.size()));
  };
  if (options.json)
    listener.new_finding = [](const sighting& s, const finding_file& f) {
      auto line = json::parse(f.line);
      line["event"] = "finding";
      line["hash"] = s.hash;
      line["ray"] = s.ray;
      print("{}\n", json_line(line));
    };
  const status ran = run_lasting(*store, *plan, stop_wanted, listener);
  end_is_orderly();
  progress.clear();
  if (!ran)
    return bad_input(ran.reason());
  if (interrupted() && !options.json)
    print("interrupted; goes on with: graze-fuzz campaign {}\n", shown(store->folder(), 1000));
  return summarize({store->folder()}, store->folder() + "/summary.html", options.json,
                   options.checks);
}

} // namespace

subcommand campaign_command(CLI::App& app) {
  const auto options = std::make_shared<campaign_options>();
  campaign_options& o = *options;
  CLI::App* c = o.app =
      app.add_subcommand("campaign", "Search for long; killed at any time, goes on where it was");
  c->footer(R"(
Examples:
  graze-fuzz campaign DIR --traversal plain --level 1-50 --rays 1000000000 --seed 2026
  graze-fuzz campaign DIR                               goes on where it was
  graze-fuzz campaign DIR1 --command "python3 my_traversal.py" --float
  graze-fuzz campaign DIR2 --shard 2/8 ...              every eighth piece, on another machine
  graze-fuzz summary DIR DIR2...                        shards together, and a page
  graze-fuzz campaign DIR --baseline known.json         fails on what is new or more (docs/ci.md)

Exit code: 0 nothing found (nothing new or more, with --baseline), 1 a finding, 2 bad input or a folder that cannot be written.)");
  c->add_option("folder", o.folder, "The campaign's folder; made, or gone on with")->required();
  CLI::Option* named =
      c->add_option("--traversal", o.plan.traversal, "What is under test")->capture_default_str();
  add_traversal_options(*c, *named, o.traversal);
  add_scene_options(*c, o.scene);
  c->add_option("--level", o.plan.level, "Level of the octants, 1 to 53, or a range: 1-50")
      ->capture_default_str();
  c->add_option("--generator", o.generators, "Names of generators, or all (the default)")
      ->delimiter(',');
  c->add_option("--except", o.except, except_option)->delimiter(',');
  c->add_flag("--tame", o.plan.tame, tame_option);
  c->add_option("--hangs", o.plan.hangs, hangs_option)
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--search", o.plan.search, "generators, or climb: see graze-fuzz run --help")
      ->capture_default_str();
  c->add_option("--seed", o.plan.seed, "Ray k of a seed is always the same ray")
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--rays", o.plan.rays, "Budget of rays, all shards together (default: no limit)")
      ->check(whole_number());
  c->add_option("--seconds", o.plan.seconds,
                "Budget of time, all starts together (default: no limit)");
  c->add_option("--shard", o.shard, "i/N: every N-th piece, from the i-th on");
  c->add_option("--piece", o.plan.piece, "Rays of a piece: what a kill can cost a thread")
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--threads", o.threads, "Threads")->capture_default_str();
  CLI::Option* json = c->add_flag("--json", o.json, "Print JSON lines: start, piece, finding, end");
  add_check_options(*c, *json, o.checks);
  c->add_flag("--progress", o.progress, "Show progress even if stderr is not a terminal");

  return {c, [options] { return campaign(*options); }};
}

subcommand summary_command(CLI::App& app) {
  const auto options = std::make_shared<summary_options>();
  summary_options& o = *options;
  CLI::App* s = app.add_subcommand("summary", "What campaigns showed; shards of one are merged");
  s->add_option("folders", o.folders, "Folders of campaigns")->required();
  s->add_option("--html", o.html,
                "The page (default: summary.html in the folder; of several, in this one)");
  CLI::Option* json = s->add_flag("--json", o.json, "Print one JSON object");
  add_check_options(*s, *json, o.checks);
  return {s, [options] {
            std::string page = options->html;
            if (page.empty())
              page = options->folders.size() == 1 ? options->folders.front() + "/summary.html"
                                                  : "summary.html";
            if (const status may = prepare(options->checks); !may)
              return bad_input(may.reason());
            return summarize(options->folders, page, options->json, options->checks);
          }};
}

} // namespace graze::fuzz
