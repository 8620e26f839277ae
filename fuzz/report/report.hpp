#pragma once
/// A campaign's result for people (a table) and for programs (one JSON object).
#include <campaign/counterexample.hpp>
#include <string>

namespace graze::fuzz {

/// A row a generator and one for all.
std::string table(const campaign_plan& plan, const campaign_result& result);
/// The command that asks about this ray of a campaign again.
std::string command_of(const campaign_plan& plan, std::uint64_t ray);
/// What was found, in hex floats and with its replay line, and the first rays of the other kinds;
/// several lines.
std::string describe(const campaign_plan& plan, const campaign_result& result,
                     const counterexample& c);
/// One object, pretty-printed: traversal, level, seed, rays, touched, misses, gaps, spurious,
/// order_errors, rays_per_second, first_miss_seconds, counterexample, generators and more.
std::string to_json(const campaign_plan& plan, const campaign_result& result,
                    const std::optional<counterexample>& c);

} // namespace graze::fuzz
