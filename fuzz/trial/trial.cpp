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
         a.map == b.map && same(a.boxes, b.boxes);
}

octree::box trial::cell(octant_number v) const {
  if (boxes)
    return (*boxes)[v];
  if (!grid)
    return octree::closed_box(octant(v));
  octree::box b;
  const std::array<unsigned, 3> at{v & 3u, v >> 2 & 3u, static_cast<unsigned>(v) >> 4};
  for (unsigned a = 0; a < 3; ++a) {
    b.lo[a] = plane(static_cast<int>(a), at[a]);
    b.hi[a] = plane(static_cast<int>(a), at[a] + 1);
  }
  return b;
}

trial with_end(const trial& t, const vec3& origin, const vec3& end) {
  trial s = t;
  s.origin = origin;
  s.end = end;
  for (unsigned a = 0; a < 3; ++a)
    s.direction[a] = end[a] - origin[a];
  return s;
}

trial with_ray(const trial& t, const vec3& origin, const vec3& direction) {
  trial r = t;
  r.origin = origin;
  r.direction = direction;
  r.end.reset();
  return r;
}

namespace {

support::status sound_line(const trial& t) {
  if (!t.end) {
    const auto ray = octree::ray::make(t.origin, t.direction);
    return ray ? support::status{} : unexpected{ray.reason()};
  }
  for (unsigned a = 0; a < 3; ++a) {
    if (!std::isfinite(t.origin[a]))
      return unexpected{"segment origin is not finite"};
    if (!std::isfinite((*t.end)[a]))
      return unexpected{"segment end is not finite"};
    if (!std::isfinite((*t.end)[a] - t.origin[a]))
      return unexpected{"segment is longer than any double: take one within 2^1023"};
  }
  if (*t.end == t.origin)
    return unexpected{"segment's end is its origin: take two points, or ask about a ray"};
  return {};
}

support::status sound_boxes(const std::vector<octree::box>& boxes) {
  if (boxes.empty() || boxes.size() > max_boxes)
    return unexpected{
        fmt::format("{} boxes: lists of 1 to {} are judged", boxes.size(), max_boxes)};
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (unsigned a = 0; a < 3; ++a) {
      const double lo = boxes[i].lo[a], hi = boxes[i].hi[a];
      if (!std::isfinite(lo) || !std::isfinite(hi))
        return unexpected{
            fmt::format("box {} is not finite on axis {}: take large numbers for a box "
                        "without end",
                        i, "xyz"[a])};
      if (lo > hi)
        return unexpected{fmt::format("box {} has lo {} above hi {} on axis {}: exchange them", i,
                                      hex(lo), hex(hi), "xyz"[a])};
    }
  return {};
}

/// As judgeable(), once for a grid that many trials have.
support::status sound_again(const std::shared_ptr<const grid_planes>& g) {
  thread_local std::shared_ptr<const grid_planes> known;
  if (known == g)
    return {};
  const auto well = judgeable(*g);
  if (well)
    known = g;
  return well;
}

support::status sound_root(const trial& t) {
  if (t.level < 0 || t.level > octree::max_level)
    return unexpected{fmt::format("level {} is outside 0..{}", t.level, octree::max_level)};
  if (const auto root = octree::root_cube::make(t.root, std::max(1, t.level)); !root)
    return unexpected{root.reason()};
  return {};
}

} // namespace

support::status judgeable(const trial& t) {
  if (const auto well = sound_line(t); !well)
    return well;
  if (t.boxes)
    return sound_boxes(*t.boxes);
  if (const auto well = t.grid ? sound_again(t.grid) : sound_root(t); !well)
    return well;
  for (unsigned a = 0; a < 3; ++a) {
    if (t.extent[a] < 1 || t.extent[a] > max_extent)
      return unexpected{"extent is outside 1..4"};
    const std::uint64_t count = t.count(a);
    if (t.base[a] >= count || t.extent[a] > count - t.base[a])
      return unexpected{t.grid ? fmt::format("voxels lie outside the grid, which has {} on axis {}",
                                             count, "xyz"[a])
                               : "octants lie outside the root"};
  }
  if (t.map && t.all() == 0)
    return unexpected{
        fmt::format("none of these voxels is occupied in the map {}", t.map->file().path)};
  return {};
}

expected<trial> trial_of_octant(const vec3& origin, const vec3& direction, const cube& octant,
                                const cube& root, const std::array<std::uint8_t, 3>& extent) {
  trial t = with_ray({}, origin, direction);
  t.extent = extent;
  return trial_of_octant(t, octant, root);
}

expected<trial> trial_of_octant(const trial& line, const cube& octant, const cube& root) {
  trial t = line;
  t.root = root;
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
