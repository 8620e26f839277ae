// The planes of a grid by their rules, and why a grid is refused.
#include <cmath>
#include <cstdio>
#include <graze/octree/exact_sum.hpp>
#include <graze/octree/grid.hpp>
#include <graze/rounding/hardware.hpp>

namespace graze::octree {
namespace {

std::string hexadecimal(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}
std::string on_axis(int axis) { return "axis " + std::to_string(axis) + ": "; }

/// o + k s.
detail::exact_sum exact_plane(double o, double s, std::uint32_t k) {
  detail::exact_sum sum;
  sum.add(o);
  sum.add(s, k);
  return sum;
}

/// In the mode to-nearest, nothing flushed.
[[gnu::noinline]] void fill(plane_rule rule, double o, double s, std::vector<double>& lower,
                            std::vector<double>& upper) {
  const auto of_float = [&](std::uint32_t k) {
    const auto origin = static_cast<float>(o), spacing = static_cast<float>(s);
    const float product = static_cast<float>(k) * spacing;
    return static_cast<double>(origin + product);
  };
  for (std::uint32_t k = 0; k < lower.size(); ++k)
    switch (rule) {
    case plane_rule::exact: {
      const detail::exact_sum p = exact_plane(o, s, k);
      lower[k] = p.rounded(detail::direction::down);
      upper[k] = p.rounded(detail::direction::up);
      break;
    }
    case plane_rule::rounded:
      lower[k] = exact_plane(o, s, k).nearest();
      break;
    case plane_rule::multiplied: {
      const double product = k * s;
      lower[k] = o + product;
      break;
    }
    case plane_rule::added:
      lower[k] = k == 0 ? o : lower[k - 1] + s;
      break;
    case plane_rule::binary32:
      lower[k] = of_float(k);
      break;
    case plane_rule::given:
      break;
    }
}

/// Why these planes are none; empty if they are. `by_rule`: that they may be made again otherwise.
std::string wrong_plane(int axis, const std::vector<double>& planes, bool exact, bool by_rule) {
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (!std::isfinite(planes[k]))
      return on_axis(axis) + "plane " + std::to_string(k) + " is no finite number" +
             (by_rule ? ": it lies beyond the numbers of its rule; take fewer voxels, a smaller "
                        "spacing, or scale the scene down"
                      : ": leave it out");
    if (k == 0 || exact || planes[k - 1] < planes[k])
      continue;
    const std::string both = on_axis(axis) + "plane " + std::to_string(k) + " (" +
                             hexadecimal(planes[k]) + ") is not above plane " +
                             std::to_string(k - 1) + " (" + hexadecimal(planes[k - 1]) + ")";
    return both + (by_rule ? ": they are rounded to the same number; take plane_rule::exact, whose "
                             "planes are not rounded, or a greater spacing"
                           : ": give planes in increasing order, each once; an axis that is flat "
                             "has one plane");
  }
  return {};
}

} // namespace

expected<grid> grid::make(const vec3& origin, const vec3& spacing,
                          const std::array<std::uint32_t, 3>& count, plane_rule rule) {
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  return make_within_scope(origin, spacing, count, rule);
}
expected<grid> grid::make(const std::array<std::span<const double>, 3>& planes) {
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  return make_within_scope(planes);
}

[[gnu::noinline]] expected<grid> grid::make_within_scope(const vec3& origin, const vec3& spacing,
                                                         const std::array<std::uint32_t, 3>& count,
                                                         plane_rule rule) {
  if (rule == plane_rule::given)
    return unexpected{"planes that are given come as three arrays: grid::make(planes)"};
  auto p = std::make_shared<planes>();
  p->rule = rule;
  p->count = count;
  for (int axis = 0; axis < 3; ++axis) {
    const unsigned a = at(axis);
    if (count[a] < 1 || count[a] > most_voxels)
      return unexpected{on_axis(axis) + "a count of " + std::to_string(count[a]) +
                        " is outside 1..2^20" +
                        (count[a] == 0 ? ": a flat axis has spacing 0 and count 1"
                                       : ": split the grid into several")};
    if (!std::isfinite(origin[a]))
      return unexpected{on_axis(axis) + "the origin is no finite number"};
    if (!std::isfinite(spacing[a]))
      return unexpected{on_axis(axis) + "the spacing is no finite number"};
    if (spacing[a] < 0)
      return unexpected{on_axis(axis) + "the spacing is negative: give the grid's lower corner as "
                                        "its origin, and count upwards"};
    p->flat[a] = spacing[a] == 0;
    if (p->flat[a] && count[a] != 1)
      return unexpected{on_axis(axis) +
                        "a spacing of 0 makes a flat axis, which has 1 voxel, not " +
                        std::to_string(count[a])};
    p->origin[a] = origin[a];
    p->spacing[a] = spacing[a];
    p->lower[a].resize(count[a] + 1);
    if (rule == plane_rule::exact)
      p->upper[a].resize(count[a] + 1);
    fill(rule, origin[a], spacing[a], p->lower[a], p->upper[a]);
    const bool exact = rule == plane_rule::exact;
    std::string why = wrong_plane(axis, p->lower[a], exact || p->flat[a], true);
    if (why.empty() && exact)
      why = wrong_plane(axis, p->upper[a], true, true);
    if (!why.empty())
      return unexpected{std::move(why)};
    if (exact)
      for (std::size_t k = 0; k < p->lower[a].size(); ++k)
        p->width[a] = std::max(p->width[a], rounding::exact::add(p->upper[a][k], -p->lower[a][k],
                                                                 detail::direction::up));
  }
  return grid(std::move(p));
}

[[gnu::noinline]] expected<grid>
grid::make_within_scope(const std::array<std::span<const double>, 3>& given) {
  auto p = std::make_shared<planes>();
  for (int axis = 0; axis < 3; ++axis) {
    const unsigned a = at(axis);
    if (given[a].empty())
      return unexpected{on_axis(axis) + "no plane is given: a flat axis has one"};
    if (given[a].size() - 1 > most_voxels)
      return unexpected{on_axis(axis) + std::to_string(given[a].size()) +
                        " planes are more than 2^20 + 1: split the grid into several"};
    p->lower[a].assign(given[a].begin(), given[a].end());
    if (std::string why = wrong_plane(axis, p->lower[a], false, false); !why.empty())
      return unexpected{std::move(why)};
    p->flat[a] = given[a].size() == 1;
    if (p->flat[a])
      p->lower[a].push_back(p->lower[a][0]);
    p->count[a] = static_cast<std::uint32_t>(p->lower[a].size() - 1);
  }
  return grid(std::move(p));
}

} // namespace graze::octree
