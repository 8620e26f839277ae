#include <algorithm>
#include <campaign/hint.hpp>
#include <chrono>
#include <external/maps.hpp>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>
#include <report/report.hpp>
#include <report/reproducer/reproducer.hpp>
#include <shrink/shrink.hpp>
#include <trial/number.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;

std::string row(std::string_view name, const counts& c) {
  return fmt::format("{:<15}{:>12}{:>12}{:>9}{:>9}{:>8}{:>9}{:>9}{:>11}{:>10.4f}{:>8}{:>8}{:>9}\n",
                     name, c.rays, c.touched, c.misses, c.crossed_missed, c.gross_missed, c.gaps,
                     c.seams, c.spurious, 100 * c.spurious_rate(), c.far_spurious, c.order_errors,
                     c.revisits);
}

void add_counts(json& object, const counts& c) {
  object["rays"] = c.rays;
  object["touched"] = c.touched;
  object["misses"] = c.misses;
  object["rays_with_miss"] = c.rays_with_miss;
  object["crossed_missed"] = c.crossed_missed;
  object["gross_missed"] = c.gross_missed;
  object["touched_missed"] = c.touched_missed;
  object["gaps"] = c.gaps;
  object["seams"] = c.seams;
  object["visited"] = c.visited;
  object["spurious"] = c.spurious;
  object["spurious_rate"] = c.spurious_rate();
  object["far_spurious"] = c.far_spurious;
  object["order_errors"] = c.order_errors;
  object["revisits"] = c.revisits;
  object["wrong_remarks"] = c.wrong_remarks;
  object["rays_with_finding"] = c.findings;
  object["faults"] = c.faults;
  object["declined"] = c.declined;
  object["unsent"] = c.unsent;
  object["rays_with"] = json::object();
  for (unsigned k = 0; k < finding_kinds; ++k)
    if (c.rays_with[k] != 0)
      object["rays_with"][name_of(static_cast<finding>(k))] = c.rays_with[k];
}

std::string spelled(const vec3& v) {
  return fmt::format("({}, {}, {})", hex(v[0]), hex(v[1]), hex(v[2]));
}

} // namespace

std::string table(const campaign_plan& plan, const campaign_result& result) {
  std::string text =
      fmt::format("{:<15}{:>12}{:>12}{:>9}{:>9}{:>8}{:>9}{:>9}{:>11}{:>10}{:>8}{:>8}{:>9}\n",
                  "generator", "rays", "touched", "misses", "crossed", "gross", "gaps", "seams",
                  "spurious", "% visits", "far", "order", "revisit");
  for (std::size_t g = 0; g < plan.generators.size(); ++g)
    text += row(plan.generators[g]->name, result.by_generator[g]);
  text += row("all", result.total);
  if (result.total.wrong_remarks != 0)
    text += fmt::format("{} rays with a wrong distance, face or number of crossings\n",
                        result.total.wrong_remarks);
  if (result.total.faults != 0)
    text += fmt::format("{} rays without an answer (crash, hang, exception, NaN or malformed)\n",
                        result.total.faults);
  if (result.total.declined != 0)
    text += fmt::format("{} rays declined, not judged\n", result.total.declined);
  if (result.total.unsent != 0) {
    std::string names;
    for (std::size_t g = 0; g < plan.generators.size(); ++g)
      if (result.by_generator[g].unsent != 0)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", plan.generators[g]->name);
    text += fmt::format("{} rays not sent, after {} that hung of each of: {} (--hangs)\n",
                        result.total.unsent, plan.hangs, names);
  }
  return text;
}

std::string kinds_of(const campaign_result& result) {
  std::string text;
  std::vector<finding> kinds = result.kinds_found();
  if (result.seams_lead())
    std::stable_partition(kinds.begin(), kinds.end(), [](finding f) { return f == finding::seam; });
  for (const finding kind : kinds) {
    const std::uint64_t rays = result.total.rays_with[static_cast<unsigned>(kind)];
    text +=
        fmt::format("{:<13}{:>10} of {} judged{}: {}\n", name_of(kind), rays, result.total.judged(),
                    result.is_on_tame_ray(kind) ? "" : ", none of them tame", sentence_of(kind));
  }
  return text;
}

namespace {

std::string spelled(const trial& t) {
  if (t.end || t.cells() != cell_kind::cube)
    return scene_lines(t, "  ");
  std::string text = fmt::format("  origin    {}\n  direction {}\n  octant    {} size {}, level {}",
                                 spelled(t.origin), spelled(t.direction), spelled(t.octant(0).lo),
                                 hex(t.size()), t.level);
  if (std::popcount(t.all()) > 1)
    text += fmt::format(", the first of {} x {} x {}", t.extent[0], t.extent[1], t.extent[2]);
  return text + "\n";
}

} // namespace

std::string command_of(const campaign_plan& plan, std::uint64_t ray) {
  std::string command = fmt::format("graze-fuzz run {}", plan.under_test.asked_for());
  if (plan.scene.cells == cell_kind::cube)
    command += fmt::format(" --level {}", plan.level);
  if (plan.scene.cells == cell_kind::cube && plan.last_level != plan.level)
    command += fmt::format("-{}", plan.last_level);
  if (!plan.grid_file.empty())
    command += " --grid " + shell_word(plan.grid_file);
  else if (plan.scene.cells != cell_kind::cube)
    command += fmt::format(" --cells {}", name_of(plan.scene.cells));
  if (plan.scene.segments)
    command += " --segments";
  if (plan.generators.size() != generators().size()) {
    std::string names;
    for (const generator* g : plan.generators)
      names += fmt::format("{}{}", names.empty() ? "" : ",", g->name);
    command += " --generator " + names;
  }
  if (plan.method != search::generators)
    command += fmt::format(" --search {}", name_of(plan.method));
  if (plan.tame)
    command += " --tame";
  if (plan.scene.map) {
    const map_file& file = plan.scene.map->file();
    command += fmt::format(" --scene {}{}", shell_word(file.path), adapter_options(file));
  }
  return command + fmt::format(" --seed {} --first-ray {} --rays 1", plan.seed, ray);
}

std::optional<std::uint64_t> first_ray(const campaign_result& result, finding kind) {
  std::optional<std::uint64_t> lowest;
  for (const auto& ray : result.first_rays(kind))
    if (ray && (!lowest || *ray < *lowest))
      lowest = ray;
  return lowest;
}

std::string replay_command(const campaign_plan& plan, const counterexample& c) {
  return fmt::format("echo '{}' | graze-fuzz replay - {}", to_json_line(c.shrunk),
                     plan.under_test.asked_for());
}

std::string describe(const campaign_plan& plan, const campaign_result& result,
                     const counterexample& c) {
  std::string text;
  if (const auto hint = hint_of(plan, result))
    text += fmt::format("{}\n", advice_on(*hint));
  text += kinds_of(result) + fmt::format("{} by {}, ray {} of seed {} ({}):\n{}", name_of(c.kind),
                                         support::shown(plan.under_test.name), c.ray, plan.seed,
                                         plan.generators[generator_of(plan, c.ray)]->name,
                                         spelled(c.found));
  if (c.shrunk != c.found)
    text += "shrunk:\n" + spelled(c.shrunk);
  if (!c.answer.empty())
    text += support::shown(c.answer, 1000) + "\n";
  text += fmt::format("replay: {}\n", replay_command(plan, c));
  for (const finding kind : result.kinds_found()) {
    if (kind != c.kind)
      text += fmt::format("also {}: again: {}\n", name_of(kind),
                          command_of(plan, *first_ray(result, kind)));
  }
  return text;
}

std::string to_json(const campaign_plan& plan, const campaign_result& result,
                    const std::optional<counterexample>& c, const check_report* compared) {
  json object;
  object["traversal"] = plan.under_test.name;
  object["promise"] = name_of(plan.under_test.guarded()->promises());
  object["level"] = plan.level;
  object["last_level"] = plan.last_level;
  object["search"] = name_of(plan.method);
  object["seed"] = plan.seed;
  object["tame"] = plan.tame;
  object["threads"] = plan.workers;
  add_counts(object, result.total);
  object["seconds"] = result.seconds;
  object["rays_per_second"] =
      result.seconds > 0 ? static_cast<double>(result.total.rays) / result.seconds : 0;
  object["first_miss_seconds"] =
      result.first_miss_seconds ? json(*result.first_miss_seconds) : json(nullptr);
  object["interrupted"] = result.interrupted;
  const auto hint = hint_of(plan, result);
  object["hint"] = hint ? json(name_of(*hint)) : json(nullptr);
  object["finding"] = c ? json(name_of(c->kind)) : json(nullptr);
  object["counterexample"] = c ? json::parse(to_json_line(c->shrunk)) : json(nullptr);
  object["found_as"] = c ? json::parse(to_json_line(c->found)) : json(nullptr);
  object["ray"] = c ? json(c->ray) : json(nullptr);
  object["generators"] = json::array();
  for (std::size_t g = 0; g < plan.generators.size(); ++g) {
    json counted{{"generator", plan.generators[g]->name}};
    add_counts(counted, result.by_generator[g]);
    object["generators"].push_back(std::move(counted));
  }
  if (compared != nullptr)
    object["baseline"] = json::parse(standings_json(*compared));
  return object.dump(2, ' ', false, json::error_handler_t::replace);
}

} // namespace graze::fuzz
