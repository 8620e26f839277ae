#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <self/campaign.hpp>

namespace graze::fuzz::self {

std::string command_of(const plan& p, const finding& f) {
  const std::string command = fmt::format("graze-fuzz self {} --seed {} --first {} --trials 1",
                                          p.under_test->name, p.seed, f.trial);
  return p.seconds_a_trial == plan{}.seconds_a_trial
             ? command
             : command + fmt::format(" --timeout {}", p.seconds_a_trial);
}

std::string to_text(const plan& p, const result& r) {
  std::string text =
      fmt::format("{}, seed {}: {} trials in {:.2f} s, {:.0f} trials/s{}\n", p.under_test->name,
                  p.seed, r.trials, r.seconds, static_cast<double>(r.trials) / r.seconds,
                  r.interrupted ? " (interrupted)" : "");
  for (std::size_t i = 0; i < r.parts.size(); ++i) {
    if (r.parts[i].trials == 0)
      continue;
    text += fmt::format("  {:<24}{:>12}", p.under_test->parts[i].name, r.parts[i].trials);
    for (unsigned k = 0; k < flaw_kinds; ++k)
      if (r.parts[i].flawed[k] != 0)
        text += fmt::format("  {} {}", name_of(static_cast<flaw>(k)), r.parts[i].flawed[k]);
    text += '\n';
  }
  for (const finding& f : r.findings)
    text +=
        fmt::format("{}: {}: {}\n  again: {}\n", name_of(f.kind), f.part, f.what, command_of(p, f));
  return text + (r.findings.empty() ? "nothing found\n" : "");
}

std::string to_json(const plan& p, const result& r) {
  using json = nlohmann::ordered_json;
  json object{{"subject", p.under_test->name},
              {"seed", p.seed},
              {"first", p.first},
              {"trials", r.trials},
              {"seconds", r.seconds},
              {"trials_per_second", static_cast<double>(r.trials) / r.seconds},
              {"interrupted", r.interrupted}};
  object["parts"] = json::array();
  for (std::size_t i = 0; i < r.parts.size(); ++i) {
    json counted{{"part", p.under_test->parts[i].name}, {"trials", r.parts[i].trials}};
    for (unsigned k = 0; k < flaw_kinds; ++k)
      if (r.parts[i].flawed[k] != 0)
        counted["flaws"][name_of(static_cast<flaw>(k))] = r.parts[i].flawed[k];
    object["parts"].push_back(std::move(counted));
  }
  object["findings"] = json::array();
  for (const finding& f : r.findings)
    object["findings"].push_back({{"flaw", name_of(f.kind)},
                                  {"part", f.part},
                                  {"trial", f.trial},
                                  {"what", f.what},
                                  {"again", command_of(p, f)}});
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace graze::fuzz::self
