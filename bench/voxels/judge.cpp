#include "judge.hpp"
#include <graze/oracle/geometry.hpp>

namespace graze::bench {

void exact_octants::descend(const octree::ray& r, unsigned level, std::uint32_t node,
                            const octant_index& at, std::vector<touched_octant>& found) const {
  const octree::cube c = root_.octant({at[0], at[1], at[2]}, static_cast<int>(level));
  const octree::vec3 hi{c.hi(0), c.hi(1), c.hi(2)};
  // A child that the ray touches lies in a parent that it touches: nothing is lost on the way.
  if (!oracle::touches(r.origin(), r.direction(), c.lo, hi))
    return;
  if (level == level_) {
    found.push_back({peers::key_of(at), oracle::crosses(r.origin(), r.direction(), c.lo, hi)});
    return;
  }
  const unsigned mask = tree_.mask(level, node);
  for (unsigned i = 0; i < 8; ++i)
    if ((mask >> i & 1) != 0)
      descend(r, level + 1, level + 1 == level_ ? 0 : tree_.child(level, node, i),
              {2 * at[0] + (i & 1), 2 * at[1] + (i >> 1 & 1), 2 * at[2] + (i >> 2)}, found);
}

std::vector<touched_octant> exact_octants::touched(const octree::ray& r) const {
  std::vector<touched_octant> found;
  if (!tree_.empty())
    descend(r, 0, 0, {0, 0, 0}, found);
  std::sort(found.begin(), found.end(),
            [](const touched_octant& a, const touched_octant& b) { return a.key < b.key; });
  return found;
}

void verdict::add(const std::vector<touched_octant>& exact, std::vector<octant_key>& found) {
  std::sort(found.begin(), found.end());
  const auto last = std::unique(found.begin(), found.end());
  doubles += static_cast<std::size_t>(found.end() - last);
  found.erase(last, found.end());
  ++rays;
  touched += exact.size();
  std::size_t hits = 0, gaps_here = 0;
  auto next = found.begin();
  for (const touched_octant& v : exact) {
    crossed += v.crossed ? 1 : 0;
    while (next != found.end() && *next < v.key)
      ++next;
    if (next != found.end() && *next == v.key)
      ++hits;
    else if (v.crossed)
      ++gaps_here;
  }
  missed += exact.size() - hits;
  gaps += gaps_here;
  spurious += found.size() - hits;
  bad_rays += gaps_here != 0 ? 1 : 0;
}

} // namespace graze::bench
