#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <shrink/candidates.hpp>
#include <shrink/scenes.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

/// A place in the scene is moved and scaled with it, a length is scaled, a direction is neither.
enum class role : std::uint8_t { place, length, direction };

struct entry {
  double value;
  role is;
  unsigned axis;
};

/// All numbers of the ray or segment and its cells, but those of a map.
std::vector<entry> numbers_of(const trial& t) {
  std::vector<entry> all;
  for (unsigned a = 0; a < 3; ++a)
    all.push_back({t.origin[a], role::place, a});
  for (unsigned a = 0; a < 3; ++a)
    all.push_back(t.end ? entry{(*t.end)[a], role::place, a}
                        : entry{t.direction[a], role::direction, a});
  if (t.map) // its grid stays
    return all;
  for (unsigned a = 0; a < 3; ++a) {
    if (t.boxes) {
      for (const octree::box& b : *t.boxes) {
        all.push_back({b.lo[a], role::place, a});
        all.push_back({b.hi[a], role::place, a});
      }
    } else if (t.grid && t.grid->rule == plane_rule::given) {
      for (const double p : t.grid->given[a])
        all.push_back({p, role::place, a});
    } else if (t.grid) {
      all.push_back({t.grid->origin[a], role::place, a});
      all.push_back({t.grid->spacing[a], role::length, a});
    } else {
      all.push_back({t.root.lo[a], role::place, a});
    }
  }
  if (t.cells() == cell_kind::cube)
    all.push_back({t.root.size, role::length, 0});
  return all;
}

/// The trial with these numbers in their places.
trial with_numbers(const trial& t, const std::vector<entry>& all) {
  trial n = t;
  std::size_t at = 0;
  const auto next = [&] { return all[at++].value; };
  vec3 origin, ahead;
  for (double& x : origin)
    x = next();
  for (double& x : ahead)
    x = next();
  n = t.end ? with_end(n, origin, ahead) : with_ray(n, origin, ahead);
  if (t.map)
    return n;
  if (t.boxes) {
    auto boxes = *t.boxes;
    for (unsigned a = 0; a < 3; ++a)
      for (octree::box& b : boxes) {
        b.lo[a] = next();
        b.hi[a] = next();
      }
    n.boxes = std::make_shared<const std::vector<octree::box>>(std::move(boxes));
  } else if (t.grid) {
    grid_planes g = *t.grid;
    for (unsigned a = 0; a < 3; ++a) {
      if (g.rule == plane_rule::given) {
        for (double& p : g.given[a])
          p = next();
        continue;
      }
      g.origin[a] = next();
      g.spacing[a] = next();
    }
    if (g != *t.grid)
      n.grid = std::make_shared<const grid_planes>(std::move(g));
  } else {
    for (double& x : n.root.lo)
      x = next();
    n.root.size = next();
  }
  return n;
}

/// What there is to read in a number: as a short decimal, or as bits.
int length_of(double x) {
  if (x == 0)
    return 0;
  if (!std::isfinite(x))
    return 1 << 16;
  const int far = std::max(0, std::abs(std::ilogb(x)) - 64) / 2;
  const int bits = 2 * significant_bits(x) + std::abs(std::ilogb(x)) / 4;
  const int decimal = 4 * static_cast<int>(fmt::format("{}", std::fabs(x)).size()) + 2;
  return std::min(bits, decimal) + (std::signbit(x) ? 1 : 0) + far;
}

/// Shorter numbers near x, or in its place.
std::vector<double> shorter(double x) {
  std::vector<double> all{0, 1, -1, 2, 0.5, 0.1, std::fabs(x)};
  if (!std::isfinite(x))
    return all;
  for (const double whole : {std::floor(x), std::ceil(x), std::trunc(x / 2)})
    all.push_back(whole);
  for (const int n : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 40, 48, 52}) {
    const double down = keep_bits(x, n);
    all.push_back(down);
    all.push_back(down + (down - keep_bits(step_ulps(down, down > 0 ? -1 : 1), n)));
  }
  for (const int digits : {1, 2, 3, 4, 6, 9, 12, 15})
    if (const auto y = parse_number(fmt::format("{:.{}e}", x, digits - 1)))
      all.push_back(*y);
  if (x != 0)
    all.push_back(std::ldexp(x, std::ilogb(x) > 0 ? -1 : 1));
  return all;
}

void offer_fewer_boxes(const trial& t, candidates& out) {
  const auto& boxes = *t.boxes;
  const auto offer = [&](std::vector<octree::box> fewer) {
    trial n = t;
    n.boxes = std::make_shared<const std::vector<octree::box>>(std::move(fewer));
    out.offer(n);
  };
  const auto size = static_cast<std::ptrdiff_t>(boxes.size());
  if (size == 1)
    return;
  for (const octree::box& one : boxes)
    offer({one});
  for (std::ptrdiff_t part = size / 2; part >= 1; part /= 2)
    for (std::ptrdiff_t from = 0; from < size; from += part) {
      std::vector<octree::box> fewer(boxes.begin(), boxes.begin() + from);
      fewer.insert(fewer.end(), boxes.begin() + std::min(size, from + part), boxes.end());
      if (!fewer.empty())
        offer(fewer);
    }
}

/// The grid cut off behind the block; the block moved towards the first voxels.
void offer_smaller_grid(const trial& t, candidates& out) {
  const grid_planes& g = *t.grid;
  const auto with_grid = [&](trial n, grid_planes smaller) {
    n.grid = std::make_shared<const grid_planes>(std::move(smaller));
    out.offer(n);
  };
  for (unsigned axes = 7; axes >= 1; --axes) { // cut off
    grid_planes cut = g;
    for (unsigned a = 0; a < 3; ++a)
      if ((axes >> a & 1) != 0 && !g.flat(a)) {
        cut.count[a] = static_cast<std::uint32_t>(t.base[a] + t.extent[a]);
        if (g.rule == plane_rule::given)
          cut.given[a].resize(cut.count[a] + 1);
      }
    with_grid(t, cut);
  }
  if (g.rule == plane_rule::given)
    for (unsigned a = 0; a < 3; ++a)
      if (t.base[a] != 0) { // or before it
        grid_planes cut = g;
        cut.given[a].erase(cut.given[a].begin(),
                           cut.given[a].begin() + static_cast<std::ptrdiff_t>(t.base[a]));
        trial n = t;
        n.base[a] = 0;
        with_grid(n, grid_of(cut.given));
      }
  for (unsigned a = 0; a < 3; ++a)
    for (int high = 20; high >= 0; --high) {
      trial n = t;
      n.base[a] &= (std::uint64_t{1} << high) - 1;
      if (n.base[a] == t.base[a])
        continue;
      out.offer(n);
      const double moved = n.plane(static_cast<int>(a), 0) - t.plane(static_cast<int>(a), 0);
      n.origin[a] += moved;
      if (n.end)
        (*n.end)[a] += moved;
      out.offer(n.end ? with_end(n, n.origin, *n.end) : n);
    }
  for (unsigned a = 0; a < 3; ++a) { // all axes as one of them
    grid_planes alike = g;
    alike.spacing = {g.spacing[a], g.spacing[a], g.spacing[a]};
    with_grid(t, alike);
  }
}

void offer_numbers(const trial& t, candidates& out) {
  const std::vector<entry> all = numbers_of(t);
  const auto offer_with = [&](const auto& change) {
    std::vector<entry> changed = all;
    for (entry& e : changed)
      change(e);
    out.offer(with_numbers(t, changed));
  };
  // moved, so that a place is 0; scaled, so that a length is 1
  std::set<double> seen;
  for (const entry& e : all)
    if (e.is == role::place && e.value != 0 && seen.insert(e.value).second)
      offer_with([&](entry& x) {
        if (x.is == role::place && x.axis == e.axis)
          x.value -= e.value;
      });
  for (const int power : {-64, -16, -4, -1, 1, 4, 16, 64})
    offer_with([&](entry& x) {
      if (x.is != role::direction)
        x.value = std::ldexp(x.value, power);
    });
  int largest = 0;
  for (const double d : t.direction)
    if (d != 0)
      largest = std::max(largest == 0 ? -2000 : largest, std::ilogb(d));
  offer_with([&](entry& x) {
    if (x.is == role::direction)
      x.value = std::ldexp(x.value, -largest);
  });
  // all that are equal, on all axes or one; then each alone
  seen.clear();
  for (const entry& e : all) {
    if (e.value == 0 || !seen.insert(e.value).second)
      continue;
    for (const double y : shorter(e.value)) {
      offer_with([&](entry& x) { x.value = x.value == e.value ? y : x.value; });
      offer_with([&](entry& x) { x.value = x.value == e.value && x.axis == e.axis ? y : x.value; });
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const double y : shorter(all[i].value)) {
      std::vector<entry> changed = all;
      changed[i].value = y;
      out.offer(with_numbers(t, changed));
    }
}

/// The origin made shorter and the ray led again through a corner of a cell.
void offer_led_again(const trial& t, candidates& out) {
  if (t.end)
    return;
  for (octant_set left = t.all(); left != 0; left &= left - 1) {
    const octree::box cell = t.cell(static_cast<octant_number>(std::countr_zero(left)));
    for (unsigned corner = 0; corner < 8; ++corner)
      for (const int n : {1, 2, 3, 4, 6, 10, 16, 25, 40}) {
        trial again = t;
        const vec3 place = cell.corner(corner);
        for (unsigned a = 0; a < 3; ++a) {
          again.origin[a] = keep_bits(t.origin[a], n);
          again.direction[a] = place[a] - again.origin[a];
        }
        out.offer(again);
      }
    if (t.boxes) // one of them will do
      return;
  }
}

} // namespace

complexity complexity_of_scene(const trial& t) {
  complexity c{std::popcount(t.all()), 0, 0, 0};
  if (t.grid)
    for (unsigned a = 0; a < 3; ++a) {
      c.level += static_cast<int>(std::bit_width(t.grid->count[a])) +
                 static_cast<int>(std::bit_width(t.base[a]));
      c.places += static_cast<int>(t.grid->count[a]);
    }
  else if (!t.boxes)
    c.level = t.level;
  for (const entry& e : numbers_of(t))
    c.bits += length_of(e.value);
  return c;
}

std::vector<trial> simpler_scenes(const trial& t) {
  candidates out(t);
  if (t.boxes)
    offer_fewer_boxes(t, out);
  else
    offer_smaller_block(t, out);
  if (t.grid && !t.map)
    offer_smaller_grid(t, out);
  offer_led_again(t, out);
  offer_numbers(t, out);
  return out.take();
}

} // namespace graze::fuzz
