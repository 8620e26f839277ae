#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <graze/fuzz/campaign_command.hpp>
#include <graze/fuzz/lasting_campaign.hpp>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>

#include "command_options.hpp"
#include "program.hpp"

namespace graze::fuzz {

struct campaign_options {
  CLI::App* campaign = nullptr;
  CLI::App* summary = nullptr;
  stored_plan plan;
  command_options command;
  std::string folder;
  std::vector<std::string> generators;
  std::string shard = "1/1";
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool json = false;
  bool progress = false;

  std::vector<std::string> folders;
  std::string html;
};

namespace {

using json = nlohmann::ordered_json;
using clock = std::chrono::steady_clock;

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

/// Rays a second of this start, and how long the budget still lasts.
std::string progress_of(const campaign_store& store, std::uint64_t rays_before,
                        double seconds_before) {
  const stored_plan& plan = store.plan();
  const std::uint64_t rays = store.state().total().rays;
  const double elapsed = store.state().elapsed;
  const double rate =
      static_cast<double>(rays - rays_before) / std::max(elapsed - seconds_before, 1e-3);
  std::optional<double> left;
  if (plan.rays != 0)
    left = static_cast<double>(plan.shard_rays() - rays) / std::max(rate, 1e-3);
  if (plan.seconds != 0)
    left = std::min(left.value_or(plan.seconds), std::max(plan.seconds - elapsed, 0.0));
  return fmt::format("{} rays, {:.0f} rays/s, {} findings{}", rays, rate,
                     store.state().findings.size(),
                     left ? fmt::format(", {:.0f} s left", *left) : std::string());
}

/// Tells what `folders` hold together, and writes the page.
int tell(const std::vector<std::string>& folders, const std::string& page, bool as_json) {
  const auto merged = merge_campaigns(folders);
  if (!merged)
    return bad_input(merged.reason());
  const auto plan = resolve(merged->plan);
  if (!plan)
    return bad_input(plan.reason());
  const std::string page_folder = std::filesystem::path(page).parent_path();
  if (std::string why =
          write_atomically(page, to_html(*merged, *plan, page_folder.empty() ? "." : page_folder));
      !why.empty())
    return bad_input(std::move(why));
  if (as_json) {
    auto line = json::parse(to_json(*merged, *plan));
    line["event"] = "end";
    line["page"] = page;
    fmt::print("{}\n", line.dump());
  } else {
    fmt::print("{}page: {}\n", to_text(*merged, *plan), page);
  }
  return merged->state.findings.empty() ? 0 : 1;
}

int campaign(campaign_options& options) {
  if (!read_shard(options.shard, options.plan))
    return bad_input(fmt::format("shard {} is not i/N with 1 <= i <= N", options.shard));
  if (options.threads < 1 || options.threads > 1024)
    return bad_input("--threads is outside 1..1024");
  for (const std::string& name : options.generators) {
    if (name != "all") {
      options.plan.generators.push_back(name);
      continue;
    }
    for (const generator& g : generators())
      options.plan.generators.emplace_back(g.name);
  }
  expected<traversal_entry> started = unexpected{std::string()};
  if (options.command.external.command.empty()) {
    if (options.campaign->count("--timeout") != 0)
      return bad_input("--timeout needs --command in a campaign");
  } else {
    auto external = external_of(options.command);
    if (!external)
      return bad_input(external.reason());
    options.plan.traversal = external->command;
    options.plan.external = *external;
    if (started = external_traversal(*external); !started)
      return bad_input(started.reason());
  }
  auto store = campaign_store::open(options.folder, options.plan, given_members(*options.campaign));
  if (!store)
    return bad_input(store.reason());
  auto plan = resolve(store->plan());
  if (!plan)
    return bad_input(plan.reason());
  if (store->plan().external) {
    if (!started)
      started = external_traversal(*store->plan().external);
    if (!started)
      return bad_input(started.reason());
    plan->owned = std::make_shared<const traversal_entry>(*started);
    plan->under_test = plan->owned.get();
  }

  listen_for_interrupts();
  const stored_plan& stored = store->plan();
  const std::uint64_t rays_before = store->state().total().rays;
  const double seconds_before = store->state().elapsed;
  if (options.json)
    fmt::print("{}\n", json{{"event", "start"},
                            {"traversal", stored.traversal},
                            {"level", stored.level},
                            {"seed", stored.seed},
                            {"shard", stored.shard},
                            {"shards", stored.shards},
                            {"rays_done", rays_before},
                            {"rays_planned", stored.rays == 0 ? json() : json(stored.shard_rays())}}
                           .dump());
  else
    fmt::print("{}: {} at level {}, seed {}, shard {}/{}{}\n", store->folder(), stored.traversal,
               stored.level, stored.seed, stored.shard, stored.shards,
               store->resumed() ? fmt::format(", goes on after {} rays", rays_before)
                                : std::string());
  std::fflush(stdout);

  const bool progress = options.progress || isatty(STDERR_FILENO) != 0;
  clock::time_point shown{};
  campaign_listener listener;
  listener.piece = [&](const finished_piece& p) {
    if (options.json) {
      auto line = json::parse(to_json_line(p));
      line.erase("counts");
      line["event"] = "piece";
      line["rays_done"] = store->state().total().rays;
      fmt::print("{}\n", line.dump());
      std::fflush(stdout);
    }
    if (progress && clock::now() - shown >= std::chrono::milliseconds(100)) {
      shown = clock::now();
      fmt::print(stderr, "\r{} \x1b[K", progress_of(*store, rays_before, seconds_before));
      std::fflush(stderr);
    }
  };
  if (options.json)
    listener.new_finding = [](const sighting& s, const finding_file& f) {
      auto line = json::parse(f.line);
      line["event"] = "finding";
      line["hash"] = s.hash;
      line["ray"] = s.ray;
      fmt::print("{}\n", line.dump());
    };
  std::string failure = run_lasting(*store, *plan, options.threads, interrupted, listener);
  if (progress)
    fmt::print(stderr, "\r\x1b[K");
  if (!failure.empty())
    return bad_input(std::move(failure));
  if (interrupted.load() && !options.json)
    fmt::print("interrupted; goes on with: graze-fuzz campaign {}\n", store->folder());
  return tell({store->folder()}, store->folder() + "/summary.html", options.json);
}

} // namespace

campaign_commands::campaign_commands(CLI::App& app)
    : options_(std::make_unique<campaign_options>()) {
  campaign_options& o = *options_;
  CLI::App* c = o.campaign =
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
  add_command_options(*c, *named, o.command);
  c->add_option("--level", o.plan.level, "Level of the octants, 1 to 53, or a range: 1-50")
      ->capture_default_str();
  c->add_option("--generator", o.generators, "Names of generators, or all (the default)")
      ->delimiter(',');
  c->add_option("--search", o.plan.search, "generators, or climb: see graze-fuzz run --help")
      ->capture_default_str();
  c->add_option("--seed", o.plan.seed, "Ray k of a seed is always the same ray")
      ->check(not_negative())
      ->capture_default_str();
  c->add_option("--rays", o.plan.rays, "Budget of rays, all shards together (default: no limit)")
      ->check(not_negative());
  c->add_option("--seconds", o.plan.seconds,
                "Budget of time, all starts together (default: no limit)");
  c->add_option("--shard", o.shard, "i/N: every N-th piece, from the i-th on");
  c->add_option("--piece", o.plan.piece, "Rays of a piece: what a kill can cost a thread")
      ->check(not_negative())
      ->capture_default_str();
  c->add_option("--threads", o.threads, "Threads")->capture_default_str();
  c->add_flag("--json", o.json, "Print JSON lines: start, piece, finding, end");
  c->add_flag("--progress", o.progress, "Show progress even if stderr is not a terminal");

  CLI::App* s = o.summary =
      app.add_subcommand("summary", "What campaigns showed; shards of one are merged");
  s->add_option("folders", o.folders, "Folders of campaigns")->required();
  s->add_option("--html", o.html,
                "The page (default: summary.html in the folder; of several, in this one)");
  s->add_flag("--json", o.json, "Print one JSON object");
}

campaign_commands::~campaign_commands() = default;

std::optional<int> campaign_commands::run() const {
  if (options_->campaign->parsed())
    return campaign(*options_);
  if (!options_->summary->parsed())
    return std::nullopt;
  std::string page = options_->html;
  if (page.empty())
    page = options_->folders.size() == 1 ? options_->folders.front() + "/summary.html"
                                         : "summary.html";
  return tell(options_->folders, page, options_->json);
}

} // namespace graze::fuzz
