#include <cli/commands.hpp>
#include <cmath>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <self/campaign.hpp>

namespace graze::fuzz {

using namespace support;

namespace {

struct self_options {
  std::vector<std::string> names;
  self::plan plan;
  bool list = false, json = false, progress = false;
};

int list(bool as_json) {
  for (const self::subject& s : self::subjects()) {
    std::vector<std::string> parts;
    for (const self::part& p : s.parts)
      parts.push_back(p.name);
    if (as_json)
      print("{}\n", nlohmann::ordered_json{{"subject", s.name}, {"parts", parts}}.dump());
    else
      support::print("{:<15} {}\n{:<15} {}\n", s.name, s.summary, "", fmt::join(parts, " "));
  }
  return 0;
}

int run_subjects(const self_options& o) {
  if (o.list)
    return list(o.json);
  std::vector<const self::subject*> chosen;
  for (const std::string& name : o.names) {
    const self::subject* s = self::find_subject(name);
    if (s == nullptr)
      return bad_input(
          fmt::format("no subject is called \"{}\" (see graze-fuzz self --list)", name));
    chosen.push_back(s);
  }
  if (o.names.empty())
    for (const self::subject& s : self::subjects())
      chosen.push_back(&s);
  self::plan plan = o.plan;
  if (const status well = check(plan); !well)
    return bad_input(well.reason());
  if (!std::isfinite(plan.seconds_a_trial) || plan.seconds_a_trial <= 0)
    return bad_input("--timeout is not a finite number of seconds above 0");
  if (plan.trials > ~std::uint64_t{0} - plan.first)
    return bad_input("--first and --trials together exceed 64 bits");
  limit(plan);

  listen_for_interrupts();
  progress_line line("trials", o.progress);
  bool any = false;
  for (const self::subject* s : chosen) {
    if (stop_wanted)
      break;
    plan.under_test = s;
    const auto r = self::run(plan, stop_wanted, shown_on(line, plan, s->name + ": "));
    if (stop_wanted)
      end_is_orderly();
    line.clear();
    if (!r)
      return bad_input(r.reason());
    print("{}{}", o.json ? to_json(plan, *r) : to_text(plan, *r), o.json ? "\n" : "");
    flush_output();
    any = any || !r->findings.empty();
  }
  return any ? found : done;
}

} // namespace

subcommand self_command(CLI::App& app) {
  const auto options = std::make_shared<self_options>();
  self_options& o = *options;
  o.plan.workers = default_threads();
  CLI::App* c = app.add_subcommand("self", "Search for flaws of graze itself, not of rays");
  c->footer(R"(
Examples:
  graze-fuzz self                                         each subject for five seconds
  graze-fuzz self functions control-words --seconds 600
  graze-fuzz self functions --seed 1 --first 4711 --trials 1   one trial again
  graze-fuzz self --list

Exit code: 0 nothing found, 1 a finding, 2 bad input.)");
  c->add_option("subjects", o.names, "Names of subjects (default: all, one after the other)");
  c->add_option("--seconds", o.plan.seconds,
                "Budget of time of each subject (5, if none is given)");
  c->add_option("--trials", o.plan.trials, "Budget of trials of each subject")
      ->check(whole_number());
  c->add_option("--first", o.plan.first, "Number of the first trial")
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--seed", o.plan.seed, "Trial k of a seed is always the same trial")
      ->check(whole_number())
      ->capture_default_str();
  c->add_option("--threads", o.plan.workers, "Processes at a time")->capture_default_str();
  c->add_option("--timeout", o.plan.seconds_a_trial, "Seconds after which a trial counts as a hang")
      ->capture_default_str();
  c->add_flag("--list", o.list, "Print the subjects and their parts");
  c->add_flag("--json", o.json, "Print one JSON object a subject, on a line");
  c->add_flag("--progress", o.progress, "Show progress even if stderr is not a terminal");
  return {c, [options] { return run_subjects(*options); }};
}

} // namespace graze::fuzz
