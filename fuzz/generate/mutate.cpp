#include <algorithm>
#include <generate/mutate.hpp>
#include <generate/site.hpp>
#include <trial/number.hpp>
#include <utility>

namespace graze::fuzz {

namespace {

/// Of a segment its two ends.
double& number_of_ray(random_stream& random, trial& t) {
  const unsigned i = random.below(6);
  if (i >= 3 && t.end)
    return (*t.end)[i - 3];
  return i < 3 ? t.origin[i] : t.direction[i - 3];
}

const octree::box& some_box(random_stream& random, const trial& t) {
  return (*t.boxes)[random.below(static_cast<unsigned>(t.boxes->size()))];
}

double plane_of_block(random_stream& random, const trial& t, unsigned axis) {
  if (t.boxes) {
    const octree::box& b = some_box(random, t);
    return random.coin() ? b.lo[axis] : b.hi[axis];
  }
  return t.plane(static_cast<int>(axis), random.below(t.extent[axis] + 1u));
}

/// Most often one ulp, at times up to 2^30 of them, log-uniform.
void step(random_stream& random, trial& t) {
  double& x = number_of_ray(random, t);
  const int ulps = random.coin() ? 1 : static_cast<int>(random.bits(random.between(1, 30)));
  x = step_ulps(x, random.coin() ? ulps : -ulps);
}

void snap(random_stream& random, trial& t) {
  const unsigned a = random.below(3);
  t.origin[a] = plane_of_block(random, t, a);
}

/// At a vertex of the block, or at a point of one of its edges.
void aim(random_stream& random, trial& t) {
  vec3 target;
  for (unsigned a = 0; a < 3; ++a)
    target[a] = plane_of_block(random, t, a);
  if (random.coin()) {
    const unsigned along = random.below(3);
    const double edge =
        t.boxes ? t.boxes->front().hi[along] - t.boxes->front().lo[along] : pitch(t, along);
    target[along] += std::ldexp(static_cast<double>(random.bits(20)), -20) * edge;
  }
  const bool exactly = random.one_in(4);
  for (unsigned a = 0; a < 3; ++a) {
    if (exactly)
      t.origin[a] = exact_origin(target[a], target[a] - t.origin[a]);
    t.direction[a] = target[a] - t.origin[a];
  }
  if (t.end) { // to it, or through it
    for (unsigned a = 0; a < 3; ++a)
      (*t.end)[a] = target[a];
    if (random.coin())
      for (unsigned a = 0; a < 3; ++a)
        (*t.end)[a] += t.direction[a];
  }
}

/// One number of the grid or of a box; another rule, count or list.
void change_cells(random_stream& random, trial& t) {
  if (t.map) // which is of its grid
    return;
  if (t.grid) {
    grid_planes g = *t.grid;
    const unsigned a = random.below(3);
    if (g.rule == plane_rule::given) {
      double& plane = g.given[a][random.below(static_cast<unsigned>(g.given[a].size()))];
      plane = step_ulps(plane, random.coin() ? 1 : -1);
    } else {
      switch (random.below(5)) {
      case 0:
        g.rule = static_cast<plane_rule>(random.below(5));
        break;
      case 1:
        g.spacing[a] = step_ulps(g.spacing[a], random.coin() ? 1 : -1);
        break;
      case 2:
        g.origin[a] = step_ulps(g.origin[a], random.coin() ? 1 : -1);
        break;
      case 3:
        g.origin[a] = 0;
        break;
      default:
        if (!g.flat(a))
          g.count[a] = 1 + random.below(g.count[a]);
        break;
      }
    }
    t.grid = std::make_shared<const grid_planes>(std::move(g));
  } else if (t.boxes) {
    auto boxes = *t.boxes;
    octree::box& b = boxes[random.below(static_cast<unsigned>(boxes.size()))];
    const unsigned a = random.below(3);
    double& x = random.coin() ? b.lo[a] : b.hi[a];
    switch (random.below(4)) {
    case 0:
      x = step_ulps(x, random.coin() ? 1 : -1);
      break;
    case 1:
      x = plane_of_block(random, t, a);
      break;
    case 2:
      if (boxes.size() > 1)
        boxes.pop_back();
      break;
    default:
      if (boxes.size() < max_boxes) // a neighbour
        boxes.push_back(b);
      boxes.back().lo[a] = b.hi[a];
      boxes.back().hi[a] = b.hi[a] + (b.hi[a] - b.lo[a]);
      break;
    }
    t.boxes = std::make_shared<const std::vector<octree::box>>(std::move(boxes));
  }
}

void change_level(random_stream& random, trial& t) {
  if (t.cells() != cell_kind::cube)
    return change_cells(random, t);
  if (random.coin()) {
    --t.level;
    for (auto& b : t.base)
      b >>= 1;
  } else {
    ++t.level;
    for (auto& b : t.base)
      b = 2 * b + random.below(2);
  }
}

void change_sign(random_stream& random, trial& t) {
  double& x = number_of_ray(random, t);
  x = -x;
}

void change_exponent(random_stream& random, trial& t) {
  const int reach = random.one_in(8) ? 1000 : 8;
  const int exponent = random.between(-reach, reach);
  if (random.coin()) {
    scale(t.direction, exponent);
    if (t.end)
      for (unsigned a = 0; a < 3; ++a)
        (*t.end)[a] = t.origin[a] + t.direction[a];
  } else {
    double& x = number_of_ray(random, t);
    x = std::ldexp(x, exponent);
  }
}

void make_zero(random_stream& random, trial& t) {
  const double zero = random.coin() ? 0.0 : -0.0;
  const unsigned a = random.below(3);
  t.direction[a] = zero;
  if (t.end)
    (*t.end)[a] = t.origin[a];
}

void drop_bits(random_stream& random, trial& t) {
  double& x = number_of_ray(random, t);
  x = keep_bits(x, random.between(1, 52));
}

void change_block(random_stream& random, trial& t) {
  if (t.boxes)
    return change_cells(random, t);
  const unsigned a = random.below(3);
  if (random.coin())
    t.base[a] += random.coin() ? std::uint64_t{1} : ~std::uint64_t{0};
  else
    t.extent[a] = static_cast<std::uint8_t>(random.between(1, max_extent));
}

void exchange_axes(random_stream& random, trial& t) {
  if (t.map)
    return;
  const unsigned a = random.below(3);
  const unsigned b = (a + 1) % 3;
  std::swap(t.origin[a], t.origin[b]);
  std::swap(t.direction[a], t.direction[b]);
  std::swap(t.root.lo[a], t.root.lo[b]);
  std::swap(t.base[a], t.base[b]);
  std::swap(t.extent[a], t.extent[b]);
  if (t.end)
    std::swap((*t.end)[a], (*t.end)[b]);
  if (t.grid) {
    grid_planes g = *t.grid;
    std::swap(g.origin[a], g.origin[b]);
    std::swap(g.spacing[a], g.spacing[b]);
    std::swap(g.count[a], g.count[b]);
    std::swap(g.given[a], g.given[b]);
    t.grid = std::make_shared<const grid_planes>(std::move(g));
  }
  if (t.boxes) {
    auto boxes = *t.boxes;
    for (octree::box& box : boxes) {
      std::swap(box.lo[a], box.lo[b]);
      std::swap(box.hi[a], box.hi[b]);
    }
    t.boxes = std::make_shared<const std::vector<octree::box>>(std::move(boxes));
  }
}

void scale_scene(random_stream& random, trial& t) {
  if (t.map)
    return;
  const int exponent = random.between(-4, 4);
  for (unsigned a = 0; a < 3; ++a) {
    t.origin[a] = std::ldexp(t.origin[a], exponent);
    t.root.lo[a] = std::ldexp(t.root.lo[a], exponent);
  }
  t.root.size = std::ldexp(t.root.size, exponent);
  const auto scale_all = [exponent](auto& numbers) {
    for (double& x : numbers)
      x = std::ldexp(x, exponent);
  };
  if (t.end)
    scale_all(*t.end);
  if (t.grid) {
    grid_planes g = *t.grid;
    scale_all(g.origin);
    scale_all(g.spacing);
    for (auto& planes : g.given)
      scale_all(planes);
    t.grid = std::make_shared<const grid_planes>(std::move(g));
  }
  if (t.boxes) {
    auto boxes = *t.boxes;
    for (octree::box& box : boxes) {
      scale_all(box.lo);
      scale_all(box.hi);
    }
    t.boxes = std::make_shared<const std::vector<octree::box>>(std::move(boxes));
  }
}

/// A root whose corners are small integers.
void change_root(random_stream& random, trial& t) {
  if (t.cells() != cell_kind::cube)
    return change_cells(random, t);
  for (double& x : t.root.lo)
    x = random.between(-4, 4);
  t.root.size = random.between(1, 8);
}

void move(random_stream& random, trial& t) {
  using change = void (*)(random_stream&, trial&);
  static constexpr std::array<change, 20> moves{step,         step,
                                                step,         step,
                                                step,         step,
                                                aim,          aim,
                                                aim,          snap,
                                                snap,         make_zero,
                                                change_sign,  change_exponent,
                                                change_block, change_level,
                                                drop_bits,    exchange_axes,
                                                scale_scene,  change_root};
  moves[random.below(moves.size())](random, t);
}

} // namespace

trial mutated(random_stream& random, const trial& t) {
  for (int attempt = 0; attempt < 8; ++attempt) {
    trial next = t;
    move(random, next);
    if (next.end)
      next = with_end(next, next.origin, *next.end);
    if (next.level >= 0 &&
        next.level <= octree::max_level) // a block may leave the root: bring it back
      for (unsigned a = 0; a < 3; ++a) {
        const std::uint64_t count = next.count(a);
        next.base[a] = std::min(next.base[a], count - 1);
        next.extent[a] = static_cast<std::uint8_t>(
            std::min<std::uint64_t>(next.extent[a], count - next.base[a]));
      }
    if (next != t && judgeable(next))
      return next;
  }
  return t;
}

} // namespace graze::fuzz
