#pragma once
/// A campaign's result for people (a table) and for programs (one JSON object).
#include <campaign/counterexample.hpp>
#include <report/checks/checks.hpp>
#include <string>

namespace graze::fuzz {

/// A row a generator and one for all.
std::string table(const campaign_plan& plan, const campaign_result& result);
/// A line for each kind that was found, in their order, but seams first where they lead: on how many rays, and what it means.
std::string kinds_of(const campaign_result& result);
/// The command that asks about this ray of a campaign again.
std::string command_of(const campaign_plan& plan, std::uint64_t ray);
/// What was found, in hex floats and with its replay line, and the first rays of the other kinds;
/// several lines.
std::string describe(const campaign_plan& plan, const campaign_result& result,
                     const counterexample& c);
/// One object, pretty-printed: traversal, level, seed, rays, touched, misses, gaps, spurious,
/// order_errors, rays_per_second, first_miss_seconds, counterexample, generators and more.
/// With `compared` the standings beside a baseline as well.
std::string to_json(const campaign_plan& plan, const campaign_result& result,
                    const std::optional<counterexample>& c, const check_report* compared = nullptr);
/// The lowest ray of a kind that is shown; of a kind that was found.
std::optional<std::uint64_t> first_ray(const campaign_result& result, finding kind);
/// "echo '...' | graze-fuzz replay - ...".
std::string replay_command(const campaign_plan& plan, const counterexample& c);

} // namespace graze::fuzz
