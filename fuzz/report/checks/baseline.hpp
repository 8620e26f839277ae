#pragma once
/// A baseline: what is known to be wrong with a traversal, so that only what is new or more fails.
///
///   {"graze_baseline": 1,
///    "campaign": {"traversal": ..., "plan": {"level", "generators", "search", "seed", "tame", "first_ray"},
///                 "rays": N, "rays_with": {"gross-miss": 1203}},
///    "lines": [{"ray": {a replay line}, "findings": ["gap"]}]}
///
/// `campaign` is null where a replay wrote it.
#include <campaign/campaign.hpp>
#include <map>
#include <report/checks/checks.hpp>

namespace graze::fuzz {

/// How many rays of a campaign show each kind of finding.
struct known_campaign {
  std::string traversal;
  std::string plan; ///< an object, as JSON
  std::uint64_t rays = 0;
  std::array<std::uint64_t, finding_kinds> rays_with{};
};
known_campaign campaign_of(const campaign_plan& plan, const counts& total);

struct baseline {
  std::optional<known_campaign> campaign;
  std::map<std::string, finding_set> lines; ///< by to_json_line()
};

/// The reason names the file and what is wrong.
expected<baseline> read_baseline(const std::string& path);
std::string to_json(const baseline& b);
/// The text is the beginning of one.
bool is_baseline(std::string_view text);

/// Of a campaign: a check for each kind of finding, in their order.
check_report checks_of(std::string command, const known_campaign& now, double seconds);

/// Sets the standings: of a campaign by kinds, and by numbers of rays where the plan is the same (by their
/// share, and 4 standard deviations of it, where the number of rays is not); of replay lines by lines. Adds
/// what is gone: of lines, of those that were asked.
/// Gives what is to be said of it, if anything: the plans differ.
std::string compare(check_report& report, const baseline& known,
                    const std::optional<known_campaign>& now);

} // namespace graze::fuzz
