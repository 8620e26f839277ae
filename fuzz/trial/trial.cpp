#include <fmt/format.h>
#include <trial/number.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

namespace {
template <class T> bool same(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}
} // namespace

bool operator==(const trial& a, const trial& b) {
  return a.origin == b.origin && a.direction == b.direction && a.end == b.end && a.root == b.root &&
         a.level == b.level && a.base == b.base && a.extent == b.extent && same(a.grid, b.grid) &&
         same(a.boxes, b.boxes);
}

support::status judgeable(const trial& t) {
  if (const auto ray = octree::ray::make(t.origin, t.direction); !ray)
    return unexpected{ray.reason()};
  if (t.level < 0 || t.level > octree::max_level)
    return unexpected{fmt::format("level {} is outside 0..{}", t.level, octree::max_level)};
  if (const auto root = octree::root_cube::make(t.root, std::max(1, t.level)); !root)
    return unexpected{root.reason()};
  for (int a = 0; a < 3; ++a) {
    if (t.extent[a] < 1 || t.extent[a] > max_extent)
      return unexpected{"extent is outside 1..4"};
    const std::uint64_t count = std::uint64_t{1} << t.level;
    if (t.base[a] >= count || t.extent[a] > count - t.base[a])
      return unexpected{"octants lie outside the root"};
  }
  return {};
}

expected<trial> trial_of_octant(const vec3& origin, const vec3& direction, const cube& octant,
                                const cube& root, const std::array<std::uint8_t, 3>& extent) {
  trial t;
  t.origin = origin;
  t.direction = direction;
  t.root = root;
  t.extent = extent;
  if (!(root.size > 0) || !std::isfinite(root.size))
    return unexpected{"root size is not positive and finite"};
  if (!(octant.size > 0) || !std::isfinite(octant.size))
    return unexpected{"octant size is not positive and finite"};
  int root_exponent = 0;
  int exponent = 0;
  if (std::frexp(root.size, &root_exponent) != std::frexp(octant.size, &exponent) ||
      exponent > root_exponent || root_exponent - exponent > octree::max_level)
    return unexpected{"octant size is not the root's size halved 0 to 53 times"};
  t.level = root_exponent - exponent;
  for (int a = 0; a < 3; ++a) {
    if (!std::isfinite(octant.lo[a]))
      return unexpected{"octant corner is not finite"};
    // from the middle, as trial::grid_plane; exact where the corner is on the grid
    const double half = std::ldexp(1.0, t.level) / 2;
    const double from_middle = octant.lo[a] - (root.lo[a] + root.size / 2);
    const double index = std::floor(from_middle / octant.size + half);
    if (!(index >= 0) || !(index < std::ldexp(1.0, t.level)))
      return unexpected{"octant lies outside the root"};
    t.base[a] = static_cast<std::uint64_t>(index);
    if (t.plane(a, 0) != octant.lo[a])
      return unexpected{"octant corner is not on the root's grid"};
  }
  if (const support::status s = judgeable(t); !s)
    return unexpected{s.reason()};
  return t;
}

} // namespace graze::fuzz
