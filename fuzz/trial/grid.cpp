#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <trial/grid.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

constexpr std::array<std::string_view, 6> rule_names{"exact", "rounded", "multiplied",
                                                     "added", "float",   "given"};
constexpr std::string_view axis_names = "xyz";

/// What an ulp of the planes' arithmetic is at x.
double ulp_at(plane_rule rule, double x) {
  return rule == plane_rule::binary32 ? std::max(x * 0x1p-23, 0x1p-149)
                                      : std::max(x * 0x1p-52, 0x1p-1074);
}

/// Each plane is off o + k s by less than three ulps of the largest number on the way (binary32: of
/// floats, s itself and o rounded, k s rounded and the sum); but for `added`, of which each step is off
/// by half an ulp. Planes that are further apart than six are increasing, and need not be looked at.
bool far_apart(const grid_planes& g, unsigned a) {
  const double reach = std::fabs(g.origin[a]) + 2 * g.spacing[a] * g.count[a];
  const double limit = g.rule == plane_rule::binary32 ? 0x1p126 : 0x1p1022;
  return reach < limit && (g.rule == plane_rule::exact || g.spacing[a] > 8 * ulp_at(g.rule, reach));
}

std::string way_out(plane_rule rule) {
  switch (rule) {
  case plane_rule::given:
    return "give each plane once, in increasing order";
  case plane_rule::exact:
    return "take a smaller origin, spacing or count";
  case plane_rule::binary32:
    return "take a larger spacing, an origin nearer to 0, or planes in double: \"planes\": "
           "\"rounded\"";
  default:
    return "take a larger spacing, an origin nearer to 0, or the planes as real numbers: "
           "\"planes\": \"exact\"";
  }
}

support::status sound_axis(const grid_planes& g, unsigned a) {
  const char axis = axis_names[a];
  const bool given = g.rule == plane_rule::given;
  if (given) {
    if (g.given[a].empty() || g.given[a].size() > max_count + 1)
      return unexpected{fmt::format("axis {} has {} planes: 1 to {} are judged", axis,
                                    g.given[a].size(), max_count + 1)};
    if (g.count[a] != std::max<std::size_t>(g.given[a].size() - 1, 1))
      return unexpected{
          fmt::format("axis {} has {} planes for {} voxels", axis, g.given[a].size(), g.count[a])};
  } else {
    if (!std::isfinite(g.origin[a]) || !std::isfinite(g.spacing[a]))
      return unexpected{fmt::format("origin and spacing of axis {} are not finite", axis)};
    if (g.spacing[a] < 0)
      return unexpected{fmt::format("spacing of axis {} is {}: take a positive one, and the lowest "
                                    "plane as the origin",
                                    axis, g.spacing[a])};
    if (g.count[a] < 1 || g.count[a] > max_count)
      return unexpected{
          fmt::format("count of axis {} is {}, outside 1..{}: take the part of the grid "
                      "that matters",
                      axis, g.count[a], max_count)};
    if (g.spacing[a] == 0 && g.count[a] != 1)
      return unexpected{fmt::format("spacing of axis {} is 0: a flat axis has count 1, not {}",
                                    axis, g.count[a])};
    if (g.spacing[a] > 0 && far_apart(g, a))
      return {};
  }
  double before = nearest_plane(g, a, 0);
  if (!std::isfinite(before))
    return unexpected{fmt::format("plane 0 of axis {} is not finite: {}", axis, way_out(g.rule))};
  for (std::uint32_t k = 1; k <= g.last(a); ++k) {
    // a step from the plane before, since plane k from the first one costs more
    const double plane = g.rule == plane_rule::added ? oracle::plane_added(before, g.spacing[a], 1)
                                                     : nearest_plane(g, a, k);
    if (!std::isfinite(plane))
      return unexpected{
          fmt::format("plane {} of axis {} is not finite: {}", k, axis, way_out(g.rule))};
    if (g.rule != plane_rule::exact && plane == before)
      return unexpected{fmt::format("planes {} and {} of axis {} are both {}: {}", k - 1, k, axis,
                                    hex(plane), way_out(g.rule))};
    if (plane < before)
      return unexpected{fmt::format("plane {} of axis {}, {}, lies below plane {}, {}: {}", k, axis,
                                    hex(plane), k - 1, hex(before), way_out(g.rule))};
    before = plane;
  }
  return {};
}

} // namespace

std::string_view name_of(plane_rule rule) { return rule_names[static_cast<unsigned>(rule)]; }

std::optional<plane_rule> plane_rule_of(std::string_view name) {
  const auto at = std::find(rule_names.begin(), rule_names.end(), name);
  if (at == rule_names.end())
    return std::nullopt;
  return static_cast<plane_rule>(at - rule_names.begin());
}

grid_planes grid_of(std::array<std::vector<double>, 3> planes) {
  grid_planes g;
  g.rule = plane_rule::given;
  g.given = std::move(planes);
  for (unsigned a = 0; a < 3; ++a)
    g.count[a] = static_cast<std::uint32_t>(
        std::clamp<std::size_t>(g.given[a].size(), 2, max_count + 2) - 1);
  return g;
}

oracle::plane_terms exact_plane(const grid_planes& g, unsigned axis, std::uint32_t index) {
  if (g.rule == plane_rule::exact && !g.flat(axis))
    return oracle::plane_exactly(g.origin[axis], g.spacing[axis], index);
  return {nearest_plane(g, axis, index), 0, 0};
}

double nearest_plane(const grid_planes& g, unsigned axis, std::uint32_t index) {
  const double o = g.origin[axis], s = g.spacing[axis];
  switch (g.rule) {
  case plane_rule::given:
    return g.given[axis][std::min<std::size_t>(index, g.given[axis].size() - 1)];
  case plane_rule::multiplied:
    return oracle::plane_multiplied(o, s, index);
  case plane_rule::added:
    return oracle::plane_added(o, s, index);
  case plane_rule::binary32:
    return oracle::plane_binary32(o, s, index);
  default:
    return oracle::plane_rounded(o, s, index);
  }
}

support::status judgeable(const grid_planes& g) {
  for (unsigned a = 0; a < 3; ++a)
    if (const auto well = sound_axis(g, a); !well)
      return well;
  return {};
}

} // namespace graze::fuzz
