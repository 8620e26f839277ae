#include <algorithm>
#include <generate/scenes.hpp>
#include <generate/site.hpp>
#include <generate/tame.hpp>

namespace graze::fuzz {

namespace {

constexpr std::array<double, 16> spacings{0.1, 0.05, 1.0 / 3, 25.2165, 27.9808, 0.6051, 1e-7, 0.2,
                                          0.3, 0.7,  0.01,    1,       0x1p-10, 0.25,   2,    1e3};

double random_spacing(random_stream& random) {
  const unsigned kind = random.below(20);
  if (kind < spacings.size())
    return spacings[kind];
  if (kind == 16)
    return std::ldexp(1.0, random.between(-60, 60));
  const int lowest = random.one_in(4) ? -300 : -12;
  const int highest = random.one_in(4) ? 300 : 8;
  return std::fabs(random_double(random, lowest, highest));
}

double random_corner(random_stream& random, double spacing, std::uint32_t count) {
  switch (random.below(8)) {
  case 0:
  case 1:
    return 0;
  case 2:
    return -10;
  case 3:
    return 1e6;
  case 4:
    return -0.3;
  case 5:
    return -spacing * (count / 2u);
  case 6: {
    const double places = random.below(1000);
    return random.sign() * spacing * places;
  }
  default:
    return random_double(random, -8, 8);
  }
}

/// 1 to 2^20, log-uniform; to 2^10 mostly, since planes take long to make.
std::uint32_t random_count(random_stream& random) {
  return 1 + static_cast<std::uint32_t>(random.bits(random.between(0, random.one_in(8) ? 20 : 10)));
}

std::vector<double> random_planes(random_stream& random) {
  std::vector<double> planes;
  const unsigned count = 1 + random.below(random.one_in(4) ? 60 : 6);
  const double spacing = random_spacing(random), corner = random_corner(random, spacing, count);
  const unsigned kind = random.below(4);
  double at = corner;
  for (unsigned k = 0; k <= count; ++k) {
    planes.push_back(at);
    switch (kind) {
    case 0: // as written down by people
      at = corner + spacing * (k + 1);
      break;
    case 1: // an ulp apart, at times
      at = random.one_in(3) ? at + spacing : step_ulps(at, 1);
      break;
    case 2: // wider and wider
      at += spacing * (1 + 0.3 * k);
      break;
    default:
      at += spacing * (0x1p-20 + static_cast<double>(random.bits(20)) * 0x1p-20);
      break;
    }
  }
  if (random.one_in(16))
    planes.resize(1); // flat
  return planes;
}

} // namespace

grid_planes random_grid(random_stream& random) {
  while (true) {
    grid_planes g;
    g.rule = static_cast<plane_rule>(random.below(6));
    if (g.rule == plane_rule::given) {
      g = grid_of({random_planes(random), random_planes(random), random_planes(random)});
    } else {
      const bool alike = random.coin();
      for (unsigned a = 0; a < 3; ++a) {
        g.spacing[a] = alike && a != 0 ? g.spacing[0] : random_spacing(random);
        g.count[a] = random_count(random);
        g.origin[a] = alike && a != 0 && random.coin()
                          ? g.origin[0]
                          : random_corner(random, g.spacing[a], g.count[a]);
      }
      for (unsigned a = 0; a < 3; ++a) { // planes that may fall together are few, to be looked at
        const double reach = std::fabs(g.origin[a]) + g.spacing[a] * g.count[a];
        const double ulp = reach * (g.rule == plane_rule::binary32 ? 0x1p-23 : 0x1p-52);
        if (g.spacing[a] < 32 * ulp)
          g.count[a] = std::min(g.count[a], 1 + random.below(200));
      }
      if (random.one_in(6)) {
        const unsigned a = random.below(3);
        g.spacing[a] = 0;
        g.count[a] = 1;
      }
    }
    if (judgeable(g))
      return g;
  }
}

namespace {

double random_size(random_stream& random) {
  return random.coin() ? random_spacing(random) : 1 + random.below(8);
}

/// A box about a point, each of whose edges is of its own length.
octree::box box_about(random_stream& random, const vec3& point, double size) {
  octree::box b;
  for (unsigned a = 0; a < 3; ++a) {
    const double lo = point[a] - size * static_cast<double>(random.bits(10)) * 0x1p-10;
    const double hi = lo + size * static_cast<double>(1 + random.bits(10)) * 0x1p-10;
    b.lo[a] = lo;
    b.hi[a] = std::max(lo, hi);
  }
  return b;
}

void flatten(random_stream& random, octree::box& b) {
  const unsigned a = random.below(3);
  b.lo[a] = b.hi[a] = random.coin() ? b.lo[a] : b.hi[a];
}

} // namespace

std::vector<octree::box> random_boxes(random_stream& random) {
  std::vector<octree::box> boxes;
  const std::size_t count = 1 + random.bits(random.between(0, 6)) % max_boxes;
  const double size = random_size(random);
  vec3 corner;
  for (double& x : corner)
    x = random_corner(random, size, 1);
  std::array<std::vector<double>, 3> planes; // of stacked ones
  for (unsigned a = 0; a < 3; ++a) {
    planes[a] = {corner[a]};
    for (unsigned k = 1; k <= 4; ++k)
      planes[a].push_back(random.coin() ? corner[a] + k * size
                                        : planes[a].back() + random_size(random));
    std::sort(planes[a].begin(), planes[a].end());
  }
  const auto plane_pair = [&](unsigned a) {
    unsigned lo = random.below(4), hi = random.one_in(4) ? 4 : lo + 1;
    return std::pair(planes[a][lo], planes[a][hi]);
  };
  const unsigned usual = random.below(6);
  while (boxes.size() < count) {
    octree::box b;
    switch (random.one_in(4) ? random.below(5) : usual) {
    case 0:
    case 1: // stacked
      for (unsigned a = 0; a < 3; ++a)
        std::tie(b.lo[a], b.hi[a]) = plane_pair(a);
      break;
    case 2: // within the one before
      b = boxes.empty() ? box_about(random, corner, size) : boxes.back();
      for (unsigned a = 0; a < 3; ++a) {
        const double edge = b.hi[a] - b.lo[a];
        if (random.coin())
          b.lo[a] = std::min(b.hi[a], b.lo[a] + edge / 4);
        if (random.coin())
          b.hi[a] = std::max(b.lo[a], b.hi[a] - edge / 4);
      }
      break;
    case 3: // tiny, or huge
      b = box_about(
          random, corner,
          std::ldexp(size, random.coin() ? -random.between(10, 40) : random.between(5, 30)));
      break;
    case 4:
      b = box_about(random, corner, size);
      break;
    default: // a neighbour: one face is another's
      b = box_about(random, corner, size);
      if (!boxes.empty()) {
        const octree::box& other = boxes[random.below(static_cast<unsigned>(boxes.size()))];
        const unsigned a = random.below(3);
        const double edge = b.hi[a] - b.lo[a];
        b = other;
        b.lo[a] = other.hi[a];
        b.hi[a] = std::max(b.lo[a], b.lo[a] + edge);
      }
      break;
    }
    if (random.one_in(12))
      flatten(random, b);
    for (unsigned a = 0; a < 3; ++a)
      if (!std::isfinite(b.lo[a]) || !std::isfinite(b.hi[a]))
        b.lo[a] = b.hi[a] = corner[a];
    boxes.push_back(b);
  }
  return boxes;
}

void cut(random_stream& random, trial& t) {
  const vec3 o = t.origin, d = t.direction;
  // some plane of the cells
  const unsigned a = random.below(3);
  vec3 vertex;
  for (unsigned b = 0; b < 3; ++b) {
    if (t.boxes) {
      const octree::box& box = (*t.boxes)[random.below(static_cast<unsigned>(t.boxes->size()))];
      vertex[b] = random.coin() ? box.lo[b] : box.hi[b];
    } else {
      vertex[b] = t.plane(static_cast<int>(b), random.below(t.extent[b] + 1u));
    }
  }
  const double to_plane = d[a] != 0 ? (vertex[a] - o[a]) / d[a] : 1;
  const auto at = [&](double when) {
    return vec3{o[0] + when * d[0], o[1] + when * d[1], o[2] + when * d[2]};
  };
  vec3 end;
  switch (random.below(10)) {
  case 0:
    end = vertex;
    break;
  case 1:
  case 2: // on the plane, or an ulp beside it
    end = at(to_plane);
    end[a] = vertex[a];
    if (random.coin())
      end[a] = step_ulps(end[a], random.coin() ? 1 : -1);
    break;
  case 3:
  case 4:
    end = at(to_plane * (static_cast<double>(random.bits(20)) * 0x1p-19));
    break;
  case 5: // tiny
    end = o;
    for (double& x : end)
      x = step_ulps(x, random.between(-2, 2));
    break;
  case 6: // long
    end = at(to_plane * std::ldexp(1.0, random.between(1, 60)));
    break;
  case 7: // the point that the generator led the ray to, most often
    end = at(1);
    break;
  case 8: // beyond it, by as much
    end = at(2);
    break;
  default: // a few ulps beside a vertex
    end = vertex;
    end[a] = step_ulps(end[a], random.between(-2, 2));
    break;
  }
  t = with_end(t, o, end);
  if (random.one_in(4))
    t = with_end(t, end, o);
  if (judgeable(t))
    return;
  vec3 next = o; // too long, or of no length
  next[a] = step_ulps(next[a], next[a] > 0 ? -1 : 1);
  t = with_end(t, o, next);
}

namespace {

/// Along a lattice of exact multiples of the spacings, through a vertex whose coordinates are no doubles:
/// from one whose coordinates are, by a direction of small multiples.
void lead_along_lattice(random_stream& random, trial& t) {
  const grid_planes& g = *t.grid;
  std::array<std::uint64_t, 3> from{}, index{};
  std::array<int, 3> steps{};
  for (unsigned a = 0; a < 3; ++a) {
    const auto last = g.last(a);
    if (random.coin()) { // another vertex, if it is a double: plane 0 is one
      const auto k = static_cast<std::uint32_t>(random.bits(32) % (last + 1));
      const auto terms = exact_plane(g, a, k);
      const double plane = nearest_plane(g, a, k);
      if (plane - terms[0] == terms[1] && terms[2] == 0 && terms[0] + terms[1] == plane &&
          plane - terms[1] == terms[0])
        from[a] = k;
    }
    static constexpr std::array<int, 8> multiples{0, 1, 1, 1, 1, 2, 2, 4};
    const int m = last == 0 ? 0 : multiples[random.below(8)];
    steps[a] = from[a] * 2 > last ? -m : m;
  }
  std::int64_t most = max_count; // steps to the end of the grid
  for (unsigned a = 0; a < 3; ++a)
    if (steps[a] != 0)
      most =
          std::min(most, static_cast<std::int64_t>(steps[a] < 0 ? from[a] : g.last(a) - from[a]) /
                             std::abs(steps[a]));
  const auto times =
      std::min(most, static_cast<std::int64_t>(1 + random.bits(random.between(0, 18))));
  for (unsigned a = 0; a < 3; ++a) {
    const auto last = static_cast<std::int64_t>(g.last(a));
    t.origin[a] = nearest_plane(g, a, static_cast<std::uint32_t>(from[a]));
    t.direction[a] = g.spacing[a] * steps[a];
    index[a] = static_cast<std::uint64_t>(
        std::clamp(static_cast<std::int64_t>(from[a]) + steps[a] * times, std::int64_t{0}, last));
  }
  if (t.direction == vec3{}) // along flat axes alone
    t.direction[random.below(3)] = 1;
  occupy(random, t, site_at(t, index));
}

/// Leads a ray through the trial's grid.
void lead_through_grid(const generator& g, random_stream& random, trial& t) {
  double size = 0;
  std::uint64_t count = 1;
  for (unsigned a = 0; a < 3; ++a) {
    t.root.lo[a] = lowest(t, a);
    if (random.coin() || a == 2)
      size = std::max(size, highest(t, a) - t.root.lo[a]);
    count = std::max(count, t.count(a));
  }
  if (!(size >= 0x1p-1000)) // flat, or nearly
    size = 1;
  t.root.size = std::ldexp(1.0, std::min(std::ilogb(size) + 1, 1000));
  t.level = std::max(1, static_cast<int>(std::bit_width(count - 1)));
  if (t.grid->rule == plane_rule::exact && random.one_in(3))
    lead_along_lattice(random, t);
  else
    g.make(random, t);
  t.root = trial{}.root;
  t.level = trial{}.level;
  for (unsigned a = 0; a < 3; ++a) { // of a far origin, and a frame that is not the grid's
    if (!std::isfinite(t.origin[a]))
      t.origin[a] = lowest(t, a);
    if (!std::isfinite(t.direction[a]))
      t.direction[a] = 1;
  }
}

/// The planes of some of the boxes as a grid, to lead a ray through.
std::shared_ptr<const grid_planes> planes_of(random_stream& random,
                                             const std::vector<octree::box>& boxes) {
  std::array<std::vector<double>, 3> planes;
  const unsigned some = random.one_in(3) ? 1 : 2;
  for (unsigned i = 0; i < some; ++i) {
    const octree::box& b = boxes[random.below(static_cast<unsigned>(boxes.size()))];
    for (unsigned a = 0; a < 3; ++a) {
      planes[a].push_back(b.lo[a]);
      planes[a].push_back(b.hi[a]);
    }
  }
  for (auto& p : planes) {
    std::sort(p.begin(), p.end());
    p.erase(std::unique(p.begin(), p.end()), p.end());
  }
  return std::make_shared<const grid_planes>(grid_of(std::move(planes)));
}

/// The last scene that was made in this thread, since trials in a row share one.
template <class T, class Make>
std::shared_ptr<const T> shared_scene(std::uint64_t seed, std::uint64_t number, Make make) {
  struct last {
    std::uint64_t seed = 0, number = 0;
    std::shared_ptr<const T> scene;
  };
  thread_local last known;
  if (!known.scene || known.seed != seed || known.number != number) {
    random_stream random(mix(seed ^ 0x67726964u), number);
    known = {seed, number, std::make_shared<const T>(make(random))};
  }
  return known.scene;
}

/// One whose edges are tame.
grid_planes tame_grid(random_stream& random) {
  grid_planes g = random_grid(random);
  while (!has_tame_edges(g))
    g = random_grid(random);
  return g;
}

/// Of random ones those that are near the first, and about as large.
std::vector<octree::box> boxes_like_first(random_stream& random) {
  std::vector<octree::box> boxes = random_boxes(random);
  const octree::box first = boxes.front();
  double size = 0;
  for (unsigned a = 0; a < 3; ++a)
    size = std::max(size, first.hi[a] - first.lo[a]);
  const double most = size * 0x1p10, least = size * 0x1p-10;
  std::erase_if(boxes, [&](const octree::box& b) {
    for (unsigned a = 0; a < 3; ++a) {
      const double edge = b.hi[a] - b.lo[a];
      if (edge != 0 && !(least <= edge && edge <= most))
        return true;
      if (!(std::fabs(b.lo[a] - first.lo[a]) <= most))
        return true;
    }
    return false;
  });
  if (boxes.empty()) // the first is a plate, a needle or a point
    boxes.push_back(first);
  return boxes;
}

/// As an owner has them: their edges are tame, and no box is 2^10 edges from the first.
std::vector<octree::box> tame_boxes(random_stream& random) {
  std::vector<octree::box> boxes = boxes_like_first(random);
  while (!has_tame_edges(boxes))
    boxes = boxes_like_first(random);
  return boxes;
}

} // namespace

trial make_trial(const generator& g, std::uint64_t seed, std::uint64_t index, int level,
                 const scene_choice& scene, bool tame) {
  random_stream random(seed, index);
  constexpr std::uint64_t tame_ones = std::uint64_t{1} << 62; // scenes are numbered apart
  const std::uint64_t apart = tame ? tame_ones : 0;
  trial t;
  switch (scene.cells) {
  case cell_kind::cube:
    t.level = level;
    g.make(random, t);
    break;
  case cell_kind::grid:
    t.grid = scene.grid ? scene.grid
                        : shared_scene<grid_planes>(seed, index / 64 + apart,
                                                    tame ? tame_grid : random_grid);
    t.map = scene.map;
    if (t.map)
      lead_through_map(g, random, t);
    else
      lead_through_grid(g, random, t);
    break;
  case cell_kind::boxes: {
    t.boxes = shared_scene<std::vector<octree::box>>(seed, index / 8 + apart,
                                                     tame ? tame_boxes : random_boxes);
    trial led;
    led.grid = planes_of(random, *t.boxes);
    lead_through_grid(g, random, led);
    t = with_ray(t, led.origin, led.direction);
    break;
  }
  }
  if (tame)
    t = tamed(t, seed, index);
  if (!scene.segments)
    return t;
  const trial ray = t;
  cut(random, t);
  for (int attempt = 0; attempt < 8 && tame && !is_tame(t); ++attempt) {
    t = ray;
    cut(random, t);
  }
  if (!tame || is_tame(t))
    return t;
  vec3 end;
  for (unsigned a = 0; a < 3; ++a)
    end[a] = ray.origin[a] + ray.direction[a];
  if (const trial whole = with_end(ray, ray.origin, end); judgeable(whole))
    return whole;
  return t;
}

} // namespace graze::fuzz
