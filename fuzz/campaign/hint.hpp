#pragma once
/// Whether what was found is explained by another ray than the one that was sent.
#include <campaign/campaign.hpp>
#include <optional>
#include <string_view>

namespace graze::fuzz {

/// What a traversal may have made of the ray without saying so.
enum class other_ray : std::uint8_t { as_float, unit_direction, float_unit_direction };
std::string_view name_of(other_ray r);
/// What a user does about it: a line for the report.
std::string_view advice_on(other_ray r);

/// The other ray, if at least 8 samples have an answer that says nothing of the ray received and can be
/// judged on it, and at least 80 % of them are right. For rays in float t, distance and face are allowed
/// ulps of float, so that a sample that is wrong in them alone would be right on whatever ray: it counts
/// only if what it says is in float.
std::optional<other_ray> hint_of(std::span<const sample> samples, promise p,
                                 const allowance& allowed = {});
/// The same of a campaign's samples.
std::optional<other_ray> hint_of(const campaign_plan& plan, const campaign_result& result);

} // namespace graze::fuzz
