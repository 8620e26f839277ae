#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>
#include <report/checks/baseline.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;
/// What is read: its keys are looked up by a tree, so that many of them take no time.
using read_json = nlohmann::json;

constexpr std::uint64_t largest = 1 << 26;
constexpr std::string_view mark = "\"graze_baseline\"";

finding kind_of(const std::string& name) {
  const auto kind = finding_of(name);
  if (!kind)
    throw std::invalid_argument(
        fmt::format("no finding is called \"{}\"", support::shown(name, 40)));
  return *kind;
}

std::uint64_t number(const read_json& value, const char* what) {
  if (!value.is_number_unsigned())
    throw std::invalid_argument(fmt::format("\"{}\" is not a number, 0 or more", what));
  return value.get<std::uint64_t>();
}

/// Throws what is wrong with it.
baseline read_members(const read_json& object) {
  baseline b;
  if (!object.is_object() || object.value("graze_baseline", read_json()) != 1)
    throw std::invalid_argument("this is not a baseline of graze-fuzz");
  if (const read_json& c = object.at("campaign"); !c.is_null()) {
    known_campaign campaign;
    campaign.traversal = c.at("traversal").get<std::string>();
    if (!c.at("plan").is_object())
      throw std::invalid_argument("\"plan\" is not an object");
    campaign.plan = c.at("plan").dump();
    campaign.rays = number(c.at("rays"), "rays");
    for (const auto& [name, rays] : c.at("rays_with").items())
      campaign.rays_with[static_cast<unsigned>(kind_of(name))] = number(rays, "rays_with");
    b.campaign = std::move(campaign);
  }
  for (const read_json& line : object.at("lines")) {
    const auto t = from_json_line(line.at("ray").dump());
    if (!t)
      throw std::invalid_argument(t.reason());
    finding_set findings = 0;
    for (const read_json& name : line.at("findings"))
      findings |= bit(kind_of(name.get<std::string>()));
    b.lines[to_json_line(*t)] |= findings;
  }
  return b;
}

json kinds(finding_set findings) {
  json list = json::array();
  for (unsigned k = 0; k < finding_kinds; ++k)
    if ((findings >> k & 1) != 0)
      list.push_back(name_of(static_cast<finding>(k)));
  return list;
}

/// "seed is 2, not 1; ...": what differs between two plans.
std::string difference(const std::string& now, const std::string& known) {
  const auto a = read_json::parse(now), b = read_json::parse(known);
  std::string text;
  for (const auto& [member, value] : a.items())
    if (const read_json other = b.value(member, read_json()); other != value)
      text += fmt::format("{}{} is {}, not {}", text.empty() ? "" : "; ", member,
                          support::shown(value.dump(), 100), support::shown(other.dump(), 100));
  return text;
}

/// More rays than are known, beyond what another number of rays brings with it.
bool is_more(std::uint64_t rays, std::uint64_t of, std::uint64_t known_rays,
             std::uint64_t known_of) {
  if (of == known_of)
    return rays > known_rays;
  if (known_of == 0)
    return rays > 0;
  const double share = static_cast<double>(known_rays) / static_cast<double>(known_of);
  const double expected = share * static_cast<double>(of);
  return static_cast<double>(rays) > expected + 4 * std::sqrt(expected + 1);
}

void compare_kinds(check_report& report, const known_campaign& known, const known_campaign& now,
                   bool same_plan) {
  for (check_result& c : report.checks) {
    const auto kind = finding_of(c.name);
    if (!kind)
      continue;
    const std::uint64_t rays = now.rays_with[static_cast<unsigned>(*kind)];
    const std::uint64_t before = known.rays_with[static_cast<unsigned>(*kind)];
    const std::string was = fmt::format("{} of {} rays in the baseline", before, known.rays);
    for (problem& p : c.problems) {
      p.how = before == 0                                                ? standing::fresh
              : same_plan && is_more(rays, now.rays, before, known.rays) ? standing::more
                                                                         : standing::known;
      if (before != 0)
        p.sentence += "; " + was;
    }
    if (rays == 0 && before != 0)
      c.problems.push_back({*kind, standing::gone, "it was on " + was});
  }
}

void compare_lines(check_report& report, const baseline& known) {
  for (check_result& c : report.checks) {
    const auto line = known.lines.find(c.ray);
    if (line == known.lines.end() || !c.declined.empty())
      continue;
    finding_set gone = line->second;
    for (problem& p : c.problems) {
      p.how = (line->second & bit(p.kind)) != 0 ? standing::known : standing::fresh;
      gone &= ~bit(p.kind);
    }
    for (unsigned k = 0; k < finding_kinds; ++k)
      if ((gone >> k & 1) != 0)
        c.problems.push_back(
            {static_cast<finding>(k), standing::gone, "it is in the baseline", "", c.ray});
  }
}

} // namespace

known_campaign campaign_of(const campaign_plan& plan, const counts& total) {
  json generators = json::array();
  for (const generator* g : plan.generators)
    generators.push_back(g->name);
  const std::string level = plan.last_level == plan.level
                                ? fmt::format("{}", plan.level)
                                : fmt::format("{}-{}", plan.level, plan.last_level);
  const json object{
      {"level", level},    {"generators", generators}, {"search", name_of(plan.method)},
      {"seed", plan.seed}, {"tame", plan.tame},        {"first_ray", plan.first}};
  return {std::string(plan.under_test.name), support::json_line(object), total.rays,
          total.rays_with};
}

expected<baseline> read_baseline(const std::string& path) {
  const auto text = support::read_file(path, largest);
  if (!text)
    return unexpected{text.reason()};
  const read_json object = read_json::parse(*text, nullptr, false);
  if (object.is_discarded())
    return unexpected{fmt::format("{} is not JSON", support::in_quotes(path))};
  try {
    return read_members(object);
  } catch (const std::exception& e) {
    return unexpected{fmt::format("{}: {}", support::in_quotes(path), support::shown(e.what()))};
  }
}

bool is_baseline(std::string_view text) {
  return text.substr(0, 100).find(mark) != std::string_view::npos;
}

std::string to_json(const baseline& b) {
  json object{{"graze_baseline", 1}, {"campaign", nullptr}, {"lines", json::array()}};
  if (b.campaign) {
    json found = json::object();
    for (unsigned k = 0; k < finding_kinds; ++k)
      if (b.campaign->rays_with[k] != 0)
        found[name_of(static_cast<finding>(k))] = b.campaign->rays_with[k];
    object["campaign"] = {{"traversal", support::utf8(b.campaign->traversal)},
                          {"plan", json::parse(b.campaign->plan)},
                          {"rays", b.campaign->rays},
                          {"rays_with", found}};
  }
  for (const auto& [line, findings] : b.lines)
    object["lines"].push_back({{"ray", json::parse(line)}, {"findings", kinds(findings)}});
  return object.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

check_report checks_of(std::string command, const known_campaign& now, double seconds) {
  check_report report{std::move(command), now.traversal, seconds};
  for (unsigned k = 0; k < finding_kinds; ++k) {
    const auto kind = static_cast<finding>(k);
    check_result c{std::string(name_of(kind))};
    if (now.rays_with[k] != 0)
      c.problems.push_back(
          {kind, standing::fresh,
           fmt::format("{}, on {} of {} rays", sentence_of(kind), now.rays_with[k], now.rays)});
    report.checks.push_back(std::move(c));
  }
  return report;
}

std::string compare(check_report& report, const baseline& known,
                    const std::optional<known_campaign>& now) {
  report.compared = true;
  if (!now) {
    compare_lines(report, known);
    return {};
  }
  if (!known.campaign) {
    compare_kinds(report, {}, *now, false);
    return "the baseline was written by a replay: it knows of no campaign";
  }
  std::string other = difference(now->plan, known.campaign->plan);
  compare_kinds(report, *known.campaign, *now, other.empty());
  if (!other.empty())
    other =
        "the baseline is of another plan (" + other + "): kinds are compared, and not how often";
  if (known.campaign->traversal != now->traversal)
    other += fmt::format("{}the baseline is of {}", other.empty() ? "" : "; ",
                         support::shown(known.campaign->traversal));
  return other;
}

} // namespace graze::fuzz
