/// The subject `voxelizer`.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/lazy_octree.hpp>
#include <graze/octree/parallel_voxelizer.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/oracle/random_bits.hpp>
#include <graze/oracle/roots.hpp>
#include <memory>
#include <optional>
#include <self/voxelizer.hpp>
#include <trial/number.hpp>

namespace graze::fuzz::self {

namespace {

using namespace octree;
using oracle::polynomial;
using oracle::random_bits;
using index3 = std::array<std::uint64_t, 3>;

constexpr std::uint64_t trials_a_tree = 64;

double between(random_bits& random, double lo, double hi) {
  return std::clamp(lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53), lo, hi);
}
int below(random_bits& random, int n) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(n));
}

/// Leaves out what it is told to.
template <class J> class dropping_judge : public J {
public:
  dropping_judge(const J& judge, const dropped_leaf& dropped) : J(judge), dropped_(dropped) {}
  [[nodiscard]] leaf_children leaves(const cube& cell) const {
    leaf_children r = J::leaves(cell);
    for (unsigned i = 0; i < 8; ++i)
      if (dropped_ && dropped_(cell.child(i))) {
        r.mask = static_cast<std::uint8_t>(r.mask & ~(1u << i));
        r.certified = static_cast<std::uint8_t>(r.certified & r.mask);
      }
    return r;
  }

private:
  const dropped_leaf& dropped_;
};

/// Is the leaf at `index` of the last level in the octree?
template <class Tree> bool keeps(const Tree& tree, const index3& index) {
  auto n = tree.root();
  cube cell = tree.root_octant();
  for (int bit = tree.level() - 1; bit >= 0; --bit) {
    const auto child = static_cast<unsigned>((index[0] >> bit & 1) | (index[1] >> bit & 1) << 1 |
                                             (index[2] >> bit & 1) << 2);
    if (tree.child_mask(n, cell, static_cast<std::uint8_t>(1u << child)) == 0)
      return false;
    n = tree.child(n, child);
    cell = cell.child(child);
  }
  return true;
}

/// What a part looks at: a domain, a level, and the octrees of them.
struct place {
  box domain;
  root_cube root;
};

/// A point near the surface, by signs in doubles; any point where a line of its own shows none.
template <class F> vec3 near_surface(const F& f, double reach, random_bits& random) {
  vec3 p{between(random, -reach, reach), between(random, -reach, reach),
         between(random, -reach, reach)};
  vec3 q = p;
  const int axis = below(random, 3);
  q[axis] = between(random, -reach, reach);
  const auto is_positive = [&f](const vec3& at) { return f(at[0], at[1], at[2]) > 0; };
  const bool positive = is_positive(p);
  if (positive == is_positive(q))
    return p;
  for (int i = 0; i < 60; ++i) {
    vec3 middle = p;
    middle[axis] = p[axis] / 2 + q[axis] / 2;
    (is_positive(middle) == positive ? p : q) = middle;
  }
  return p;
}

/// The scene's own domain; parts of it with faces anywhere or in octants' planes; a large one; a
/// small one about a point of the surface, to the last level.
template <class F> place any_place(const F& f, double reach, random_bits& random) {
  for (;;) {
    box domain{{-reach, -reach, -reach}, {reach, reach, reach}};
    int level = 1 + below(random, 7);
    const int kind = below(random, 6);
    for (int a = 0; a < 3 && (kind == 1 || kind == 2); ++a) {
      double lo = between(random, -reach, reach), hi = between(random, -reach, reach);
      if (kind == 2)
        lo = std::ldexp(std::nearbyint(std::ldexp(lo, 3)), -3),
        hi = std::ldexp(std::nearbyint(std::ldexp(hi, 3)), -3);
      domain.lo[a] = std::min(lo, hi);
      domain.hi[a] = std::max(lo, hi);
    }
    if (kind == 3) {
      const double far = std::ldexp(between(random, 1, 2), 2 + below(random, 9));
      domain = {{-far, -far, -far}, {far, far, far}};
      if (!std::is_same_v<F, holesrot>) // which has no end
        level = std::min(level + std::ilogb(far), 12);
    }
    if (kind >= 4) {
      const vec3 centre = near_surface(f, reach, random);
      const int zoom = 2 + below(random, 48);
      for (int a = 0; a < 3; ++a) {
        const double half = std::ldexp(between(random, 0.5, 1), -zoom);
        domain.lo[a] = centre[a] - (below(random, 8) == 0 ? 0 : half);
        domain.hi[a] = centre[a] + half;
      }
      level = std::min(zoom + 1 + below(random, 5), max_level);
    }
    if (const auto root = enclosing_root(domain, level))
      return {domain, *root};
  }
}

/// A line through the domain.
struct line {
  vec3 origin, direction;
};

/// Through `through`, but on some axes moved to octants' planes, or an ulp beside them, or to the
/// domain's faces; in any direction, along axes, in faces and diagonals.
line any_line(const place& at, const vec3& through, random_bits& random) {
  const double size = std::ldexp(at.root.root_octant().size, -at.root.level());
  line l{};
  const int snapped = below(random, 8);
  for (int a = 0; a < 3; ++a) {
    const double lo = at.domain.lo[a], hi = at.domain.hi[a];
    double x = through[a];
    if ((snapped >> a & 1) != 0) {
      const double root_lo = at.root.root_octant().lo[a];
      const double k = std::nearbyint((x - root_lo) / size);
      x = std::clamp(root_lo + k * size, lo, hi);
      if (below(random, 4) == 0)
        x = std::clamp(step_ulps(x, below(random, 2) == 0 ? 1 : -1), lo, hi);
    } else if (below(random, 8) == 0) {
      x = below(random, 2) == 0 ? lo : hi;
    }
    l.origin[a] = x;
  }
  do {
    const int kind = below(random, 4);
    for (int a = 0; a < 3; ++a) {
      const double sign = below(random, 2) == 0 ? 1 : -1;
      switch (kind) {
      case 0: // along an axis or a diagonal of a face or of the cube
        l.direction[a] = below(random, 2) == 0 ? 0 : sign;
        break;
      case 1: // in a face
        l.direction[a] = below(random, 3) == 0 ? 0 : sign * between(random, 0.001, 1);
        break;
      case 2: // few bits, so that zeros may be rational
        l.direction[a] = sign * below(random, 16) / 4;
        break;
      default:
        l.direction[a] = sign * between(random, 0, 1);
      }
    }
  } while (l.direction == vec3{0, 0, 0});
  return l;
}

/// The t for which the line is in the closed domain.
std::optional<std::pair<mpq_class, mpq_class>> range_in(const line& l, const box& domain) {
  std::optional<mpq_class> from, to;
  for (int a = 0; a < 3; ++a) {
    if (l.direction[a] == 0)
      continue; // the origin is in the domain
    mpq_class s = (mpq_class(domain.lo[a]) - mpq_class(l.origin[a])) / mpq_class(l.direction[a]);
    mpq_class t = (mpq_class(domain.hi[a]) - mpq_class(l.origin[a])) / mpq_class(l.direction[a]);
    if (s > t)
      std::swap(s, t);
    if (!from || s > *from)
      from = s;
    if (!to || t < *to)
      to = t;
  }
  if (!from || *from > *to)
    return std::nullopt;
  return std::pair(*from, *to);
}

/// An exact zero of a polynomial: what is known of it.
struct exact_zero {
  const polynomial& function;
  const oracle::root_counter& counter;
  oracle::root at;
  /// The sign of (zero - t).
  [[nodiscard]] int beside(const mpq_class& t) const {
    if (t < at.lo)
      return 1;
    if (t > at.hi)
      return -1;
    if (at.lo == at.hi || function(t) == 0)
      return 0; // the only zero from at.lo to at.hi
    if (function(at.lo) == 0)
      return at.lo < t ? -1 : 0;
    return counter.roots_between(at.lo, t) != 0 ? -1 : 1;
  }
};

/// Indices on one axis of the octants of the last level that hold the zero's point.
std::vector<std::uint64_t> slabs_at(const exact_zero& zero, const line& l, int axis,
                                    const root_cube& root) {
  const mpq_class size =
      mpq_class(root.root_octant().size) / mpq_class(std::ldexp(1.0, root.level()));
  const mpq_class origin(l.origin[axis]), direction(l.direction[axis]),
      lo(root.root_octant().lo[axis]);
  const mpq_class near = (origin + zero.at.lo * direction - lo) / size;
  mpz_class k;
  mpz_fdiv_q(k.get_mpz_t(), near.get_num_mpz_t(), near.get_den_mpz_t());
  // the planes about `near`: below, on or above each?
  const auto side_of = [&](const mpz_class& plane) {
    const mpq_class x = lo + mpq_class(plane) * size - origin;
    if (direction == 0)
      return x < 0 ? 1 : x > 0 ? -1 : 0;
    const int beside = zero.beside(x / direction);
    return direction > 0 ? beside : -beside;
  };
  while (side_of(k) < 0)
    --k;
  while (side_of(k + 1) >= 0)
    ++k;
  std::vector<std::uint64_t> slabs;
  const mpz_class count = mpz_class(1) << root.level();
  const auto add = [&](const mpz_class& slab) {
    if (slab >= 0 && slab < count)
      slabs.push_back(std::stoull(slab.get_str()));
  };
  add(k);
  if (side_of(k) == 0)
    add(k - 1);
  return slabs;
}

std::string spelled(const vec3& v) {
  return fmt::format("({}, {}, {})", hex(v[0]), hex(v[1]), hex(v[2]));
}

template <class F> std::vector<polynomial> along(const F& f, const line& l) {
  const auto [x, y, z] = oracle::along(l.origin, l.direction);
  if constexpr (std::is_same_v<F, spheres>) {
    std::vector<polynomial> parts;
    for (const auto& s : F::parts)
      parts.push_back(F::part(s, x, y, z));
    return parts;
  } else {
    return {f(x, y, z)};
  }
}

/// The union's surface is where one polynomial is 0 and none is negative.
bool on_union(const std::vector<polynomial>& all, std::size_t mine, const oracle::root& at) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == mine)
      continue;
    if (all[i](at.lo) <= 0 || all[i](at.hi) <= 0 ||
        oracle::root_counter(all[i]).roots_between(at.lo, at.hi) != 0)
      return false; // negative, or too near to tell
  }
  return true;
}

template <class F> class surface_trials {
public:
  surface_trials(const F& f, double reach, std::uint64_t which, std::uint64_t parts,
                 const dropped_leaf& dropped)
      : f_(f), reach_(reach), which_(which), parts_(parts), dropped_(dropped) {}

  void examine(std::uint64_t seed, std::uint64_t index, observations& out) {
    const std::uint64_t k = index / parts_, number = k / trials_a_tree;
    if (!at_ || number != number_ || seed != seed_)
      build(seed, number);
    if (!tree_) {
      out.push_back({flaw::wrong_empty, "no octree: " + why_ + where()});
      return;
    }
    if (k % trials_a_tree == 0)
      compare_octrees(out);
    random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
    for (int tries = 0; tries < 8; ++tries) {
      vec3 through = near_surface(f_, reach_, random);
      if (below(random, 2) == 0 || !contains(at_->domain, box{through, through}))
        for (int a = 0; a < 3; ++a)
          through[a] = between(random, at_->domain.lo[a], at_->domain.hi[a]);
      if (look_along(any_line(*at_, through, random), random, out))
        return;
    }
  }

private:
  using judge = lane_judge<F>;

  void build(std::uint64_t seed, std::uint64_t number) {
    seed_ = seed;
    number_ = number;
    random_bits random(oracle::mix(seed + which_) ^ oracle::mix(number));
    lazy_.reset();
    at_ = any_place(f_, reach_, random);
    auto tree = voxelize_by(dropping_judge(scalar_judge<F>(f_, at_->domain), dropped_), at_->root);
    tree_.reset();
    if (tree)
      tree_ = *std::move(tree);
    else
      why_ = tree.reason();
    lazy_.emplace(judge(f_, at_->domain), at_->root);
  }

  [[nodiscard]] std::string where() const {
    return fmt::format(" (domain {} to {}, level {})", spelled(at_->domain.lo),
                       spelled(at_->domain.hi), at_->root.level());
  }

  void compare_octrees(observations& out) const {
    const auto same = [&](const expected<sparse_octree>& other, const std::string& maker) {
      if (!other || !(*other == *tree_))
        out.push_back({flaw::difference, "another octree by " + maker + where()});
    };
    for (const batch::path p : batch::paths)
      if (!batch::refusal(p))
        same(voxelize_in_lanes(f_, at_->root, at_->domain, p), batch::name(p));
    same(voxelize_parallel(judge(f_, at_->domain), at_->root, {2, nullptr, {}}), "two threads");
  }

  /// False where the line shows no point of the surface.
  bool look_along(const line& l, random_bits& random, observations& out) {
    const auto range = range_in(l, at_->domain);
    if (!range)
      return false;
    // from the domain's face, or from somewhere on: not only what is seen first
    mpq_class from = range->first;
    if (below(random, 2) == 0)
      from += (range->second - range->first) * mpq_class(below(random, 64), 64);
    const std::vector<polynomial> all = along(f_, l);
    const std::size_t start = random() % all.size();
    std::optional<oracle::root> root;
    std::size_t mine = start;
    for (std::size_t i = 0; i < all.size() && !root; ++i) {
      mine = (start + i) % all.size();
      if (all[mine].degree() < 1)
        continue; // constant; where it is 0, the whole line is a part of the surface
      root = oracle::first_root(all[mine], from, range->second, 120);
      if (root && !on_union(all, mine, *root))
        root.reset();
    }
    if (!root)
      return false;
    const oracle::root_counter counter(all[mine]);
    const exact_zero zero{all[mine], counter, *std::move(root)};
    std::array<std::vector<std::uint64_t>, 3> slabs;
    for (int a = 0; a < 3; ++a)
      slabs[a] = slabs_at(zero, l, a, at_->root);
    for (const std::uint64_t x : slabs[0])
      for (const std::uint64_t y : slabs[1])
        for (const std::uint64_t z : slabs[2])
          check_leaf({x, y, z}, l, out);
    return true;
  }

  void check_leaf(const index3& index, const line& l, observations& out) {
    const auto report = [&](const char* maker) {
      out.push_back({flaw::dropped,
                     fmt::format("octant ({}, {}, {}) is not in the {} octree, but holds a zero on "
                                 "the line {} + t {}{}",
                                 index[0], index[1], index[2], maker, spelled(l.origin),
                                 spelled(l.direction), where())});
    };
    if (!keeps(*tree_, index))
      report("eager");
    if (!keeps(*lazy_, index))
      report("lazy");
  }

  F f_;
  double reach_;
  std::uint64_t which_, parts_;
  dropped_leaf dropped_;
  std::uint64_t seed_ = 0, number_ = 0;
  std::optional<place> at_;
  std::optional<sparse_octree> tree_;
  std::string why_;
  std::optional<lazy_octree<judge>> lazy_;
};

} // namespace

subject voxelizer_subject(const dropped_leaf& dropped) {
  subject s{"voxelizer", "Octants that hold a zero of a surface are kept, by exact zeros", {}};
  // whose zeros along lines are exact
  const auto each = [](const auto& visit) {
    for_each_built_in([&visit]<class F>(const built_in_surface<F>& row) {
      if constexpr (is_algebraic<F>())
        visit(row);
    });
  };
  std::uint64_t count = 0, which = 0;
  each([&count](const auto&) { ++count; });
  each([&]<class F>(const built_in_surface<F>& row) {
    const auto trials =
        std::make_shared<surface_trials<F>>(row.surface(), row.reach, which++, count, dropped);
    s.parts.push_back({std::string(row.name),
                       [trials](std::uint64_t seed, std::uint64_t index, observations& out) {
                         trials->examine(seed, index, out);
                       }});
  });
  return s;
}

} // namespace graze::fuzz::self
