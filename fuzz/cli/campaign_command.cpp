#include <algorithm>
#include <array>
#include <campaign/lasting.hpp>
#include <charconv>
#include <cli/commands.hpp>
#include <cli/traversal_options.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>
#include <report/summary.hpp>

namespace graze::fuzz {

using namespace support;

namespace {

struct campaign_options {
  CLI::App* app = nullptr;
  stored_plan plan;
  traversal_options traversal;
  std::string folder;
  std::vector<std::string> generators;
  std::string shard = "1/1";
  unsigned threads = default_threads();
  bool json = false;
  bool progress = false;
};

struct summary_options {
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
  constexpr std::array<std::pair<const char*, const char*>, 8> members{
      {{"--traversal", "traversal"},
       {"--generator", "generators"},
       {"--search", "search"},
       {"--level", "level"},
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

/// Prints what `folders` hold together, and writes the page.
int summarize(const std::vector<std::string>& folders, const std::string& page, bool as_json) {
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
  if (as_json) {
    auto line = json::parse(to_json(*merged, *plan));
    line["event"] = "end";
    line["page"] = page;
    print("{}\n", json_line(line));
  } else {
    print("{}page: {}\n", to_text(*merged, *plan), shown(page, 1000));
  }
  return merged->state.findings.empty() ? done : found;
}

int campaign(campaign_options& options) {
  listen_for_interrupts();
  if (!read_shard(options.shard, options.plan))
    return bad_input(fmt::format("shard {} is not i/N with 1 <= i <= N", options.shard));
  if (const status well = check({.workers = options.threads}); !well)
    return bad_input(well.reason());
  options.plan.generators = all_named(options.generators);
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
  }
  auto store = campaign_store::open(options.folder, options.plan, given_members(*options.app));
  if (!store)
    return bad_input(store.reason());
  auto plan = resolve(store->plan());
  if (!plan)
    return bad_input(plan.reason());
  if (store->plan().external) {
    if (!started)
      started = tried_traversal(*store->plan().external);
    if (!started)
      return bad_input(started.reason());
    plan->under_test = *started;
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
  return summarize({store->folder()}, store->folder() + "/summary.html", options.json);
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

Exit code: 0 nothing found, 1 a finding, 2 bad input or a folder that cannot be written.)");
  c->add_option("folder", o.folder, "The campaign's folder; made, or gone on with")->required();
  CLI::Option* named =
      c->add_option("--traversal", o.plan.traversal, "What is under test")->capture_default_str();
  add_traversal_options(*c, *named, o.traversal);
  c->add_option("--level", o.plan.level, "Level of the octants, 1 to 53, or a range: 1-50")
      ->capture_default_str();
  c->add_option("--generator", o.generators, "Names of generators, or all (the default)")
      ->delimiter(',');
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
  c->add_flag("--json", o.json, "Print JSON lines: start, piece, finding, end");
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
  s->add_flag("--json", o.json, "Print one JSON object");
  return {s, [options] {
            std::string page = options->html;
            if (page.empty())
              page = options->folders.size() == 1 ? options->folders.front() + "/summary.html"
                                                  : "summary.html";
            return summarize(options->folders, page, options->json);
          }};
}

} // namespace graze::fuzz
