#include <campaign/plan.hpp>
#include <charconv>
#include <cmath>
#include <external/libraries.hpp>
#include <external/maps.hpp>
#include <fmt/format.h>
#include <graze/support/threads.hpp>
#include <judge/judge.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

namespace {

/// "A" or "A-B", 1 <= A <= B <= 53; false when it is neither.
bool read_levels(std::string_view text, campaign_plan& plan) {
  const auto number = [&text](int& n) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc();
  };
  if (!number(plan.level))
    return false;
  plan.last_level = plan.level;
  if (text.starts_with('-')) {
    text.remove_prefix(1);
    if (!number(plan.last_level))
      return false;
  }
  return text.empty() && 1 <= plan.level && plan.level <= plan.last_level &&
         plan.last_level <= octree::max_level;
}

} // namespace

support::status check(const trial_plan& p) {
  if (!std::isfinite(p.seconds) || p.seconds < 0)
    return unexpected{"--seconds is not a finite number of seconds, 0 or more"};
  if (p.workers < 1 || p.workers > support::most_threads)
    return unexpected{"--threads is outside 1..1024"};
  return {};
}

void limit(trial_plan& p) {
  if (p.seconds == 0 && p.trials == 0)
    p.seconds = 5;
}

std::string_view name_of(search s) { return s == search::climb ? "climb" : "generators"; }

std::optional<search> search_of(std::string_view name) {
  for (const search s : {search::generators, search::climb})
    if (name_of(s) == name)
      return s;
  return std::nullopt;
}

std::vector<std::string> all_named(const std::vector<std::string>& generators) {
  std::vector<std::string> names;
  for (const std::string& name : generators) {
    if (name != "all") {
      names.push_back(name);
      continue;
    }
    for (const generator& g : fuzz::generators())
      names.emplace_back(g.name);
  }
  return names;
}

support::status check(const traversal& under_test, const scene_choice& scene) {
  if (!under_test.takes(scene.cells, scene.segments))
    return unexpected{
        fmt::format("{} takes no {} through {}: see graze-fuzz list for those that do",
                    under_test.name(), scene.segments ? "segments" : "rays",
                    scene.cells == cell_kind::cube   ? "octants"
                    : scene.cells == cell_kind::grid ? "grids"
                                                     : "boxes")};
  return judgeable(under_test.promises(), scene.cells);
}

expected<std::vector<std::string>> all_named(const std::vector<std::string>& generators,
                                             const std::vector<std::string>& except) {
  std::vector<std::string> names = all_named(generators);
  for (const std::string& name : except) {
    if (find_generator(name) == nullptr)
      return unexpected{fmt::format("no generator is called \"{}\" (see graze-fuzz list)", name)};
    std::erase(names, name);
  }
  if (names.empty() && !except.empty())
    return unexpected{"--except leaves no generator"};
  return names;
}

expected<campaign_plan> resolve_rays(const named_plan& named) {
  campaign_plan plan;
  for (const std::string& name : named.generators) {
    plan.generators.push_back(find_generator(name));
    if (plan.generators.back() == nullptr)
      return unexpected{fmt::format("no generator is called \"{}\" (see graze-fuzz list)", name)};
  }
  if (plan.generators.empty())
    return unexpected{"there is no generator"};
  const auto method = search_of(named.search);
  if (!method)
    return unexpected{fmt::format("no search is called \"{}\"", named.search)};
  plan.method = *method;
  if (!read_levels(named.level, plan))
    return unexpected{
        fmt::format("level {} is outside 1..53 (a number, or a range A-B)", named.level)};
  const auto cells = cell_kind_of(named.cells);
  if (!cells)
    return unexpected{fmt::format("cells \"{}\" are none of cube, grid, boxes", named.cells)};
  plan.scene = {*cells, named.segments, nullptr, nullptr};
  if (!named.grid.empty()) {
    if (*cells != cell_kind::grid)
      return unexpected{
          fmt::format("a grid is given, but the cells are {}: take cells grid", named.cells)};
    auto grid = grid_from_text(named.grid);
    if (!grid)
      return unexpected{"the grid: " + grid.reason()};
    plan.scene.grid = std::make_shared<const grid_planes>(*std::move(grid));
  }
  plan.seed = named.seed;
  plan.trials = named.rays;
  plan.seconds = named.seconds;
  plan.tame = named.tame;
  plan.hangs = named.hangs;
  if (const auto well = check(plan); !well)
    return unexpected{well.reason()};
  return plan;
}

expected<campaign_plan> resolve(const named_plan& named) {
  auto under_test = named.external || named.scene
                        ? expected<traversal_entry>(traversal_entry{
                              named.traversal, "a traversal in another process", nullptr,
                              named.external ? spelled(*named.external) : std::string()})
                        : named_traversal(named.traversal);
  if (!under_test)
    return unexpected{under_test.reason()};
  auto plan = resolve_rays(named);
  if (!plan)
    return plan;
  if (under_test->make)
    if (const auto well = check(*under_test->make(), plan->scene); !well)
      return unexpected{well.reason()};
  plan->under_test = *std::move(under_test);
  return plan;
}

support::status load_map(const named_plan& named, campaign_plan& plan, external_options& like) {
  if (!named.scene)
    return {};
  auto map = known_map(*named.scene);
  if (!map)
    return unexpected{map.reason()};
  plan.scene.map = *std::move(map);
  plan.scene.grid = plan.scene.map->grid();
  plan.scene.cells = cell_kind::grid;
  like.usual_cells = cell_kind::grid;
  like.map = plan.scene.map;
  return {};
}

} // namespace graze::fuzz
