#pragma once
/// The first hit of a ray with a surface: descent through the octree to its level and, on the fly,
/// below it; then proof along the ray itself.
#include <algorithm>
#include <cstdint>
#include <graze/octree/along_ray.hpp>
#include <graze/octree/descent.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/sparse_octree.hpp>
#include <limits>
#include <memory>
#include <type_traits>
#include <xmmintrin.h>

namespace graze::octree {

/// How a ray ends. Each is proven: `hit` that there is a root, `miss` that there is none.
enum class verdict : std::uint8_t { hit, miss, undecided };

/// [t_near, t_far], in units of the ray's own parameter, encloses the first root in the domain: of
/// a `hit` for sure, of an `undecided` if there is one. Without meaning for a `miss`.
struct surface_hit {
  verdict outcome;
  double t_near, t_far;
  /// The paper's answer: the first octant of level NL that the last-level test keeps, whether the
  /// ray meets the surface in it or only passes beside it; size 0 if there is none.
  cube leaf;
  /// The surface is proven to meet `leaf`.
  bool certified_leaf;
};

/// Sums over the rays that were followed with it.
struct traversal_counts {
  std::uint64_t cells_opened = 0; ///< octants whose children were tested
  std::uint64_t leaves_kept = 0;  ///< octants of level NL in which the ray could not be proven free
};

/// The octree continued below its last level by the surface's own enclosures. Models Tree; its
/// functions are called within a scope of B.
template <Surface F, rounding::Backend B> class continued_octree {
public:
  struct node {
    sparse_octree::node index; ///< at or below the octree's last level without meaning
    int depth;
  };

  continued_octree(const F& f, const box& domain, const sparse_octree& octree)
      : f_(f), domain_(domain), octree_(octree) {}

  [[nodiscard]] node root() const { return {octree_.root(), 0}; }
  [[nodiscard]] std::uint8_t child_mask(const node& n, const cube& cell,
                                        std::uint8_t wanted) const {
    return n.depth < octree_.level() ? octree_.child_mask(n.index, cell, wanted)
                                     : evaluated_mask(cell, wanted);
  }
  [[nodiscard]] node child(const node& n, unsigned index) const {
    return {n.depth < octree_.level() ? octree_.child(n.index, index) : 0, n.depth + 1};
  }

private:
  [[nodiscard]] std::uint8_t evaluated_mask(const cube& cell, std::uint8_t wanted) const {
    const bool cut = !contains(domain_, closed_box(cell));
    unsigned mask = 0;
    for (unsigned rest = wanted; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      box b = closed_box(cell.child(i));
      if (cut) {
        b = intersection(b, domain_);
        if (b.empty())
          continue;
      }
      if (!has_no_zero<B>(f_, b))
        mask |= 1u << i;
    }
    return static_cast<std::uint8_t>(mask);
  }

  const F& f_;
  const box& domain_;
  const sparse_octree& octree_;
};

/// What is known of the first root while a ray is followed from octant to octant: nothing lies
/// before `near`; two opposite proven signs, both at parameters within the domain and at most
/// `far`, prove a root between them.
template <Surface F, rounding::Backend B> class root_search {
public:
  root_search(const along_ray<F, B>& g, const ray_span& domain) : g_(g), domain_(domain) {}

  /// Looks at the ray's part in the next octant front to back, of which `s` is the span; returns
  /// true if the octant is kept, which it is unless g is proven free of zeros there.
  bool keep(const ray_span& s) {
    const double first = std::max(s.entry_down, domain_.entry_down);
    const double last = std::min(s.exit_up, domain_.exit_up);
    if (first > last || g_.has_no_zero_in(first, last))
      return false;
    // An octant that the ray only seems to touch, by rounding, may seem to be entered after the
    // next one; its own exit, rounded down, is not after that.
    near_ = std::min({near_, first, s.exit_down});
    far_ = last;
    if (kept_++ == 0)
      look_before();
    look_at(last);
    return true;
  }

  [[nodiscard]] bool proven() const { return positive_ && negative_; }
  [[nodiscard]] bool any() const { return kept_ != 0; }
  [[nodiscard]] double near() const { return std::max(near_, domain_.entry_down); }
  [[nodiscard]] double far() const { return far_; }

private:
  /// From the domain's entry up to `near` the sign does not change: any point there will do.
  void look_before() {
    look_at(near_);
    if (positive_ || negative_ || !(domain_.entry_up < near_))
      return;
    look_at(domain_.entry_up / 2 + near_ / 2);
    if (!positive_ && !negative_)
      look_at(domain_.entry_up);
  }

  void look_at(double t) {
    if (!(domain_.entry_up <= domain_.exit_down))
      return;
    t = std::clamp(t, domain_.entry_up, domain_.exit_down);
    const int sign = g_.sign_at(t);
    positive_ = positive_ || sign > 0;
    negative_ = negative_ || sign < 0;
    far_ = std::max(far_, t);
  }

  const along_ray<F, B>& g_;
  ray_span domain_;
  double near_ = std::numeric_limits<double>::infinity(), far_ = 0;
  std::uint64_t kept_ = 0;
  bool positive_ = false, negative_ = false;
};

/// First hits with one surface. M is the Method by which the ray descends; the verdicts are proven
/// for the sound one in the convention `owned`, which is front to back; with a baseline they are
/// what that baseline makes of the scene. B evaluates the surface; its scope must be compatible
/// with M's: the same, or one that sets no mode. Sources: DESIGN, contracts 4 to 7; the paper,
/// Fig. 1.
template <Surface F, Method M = sound<rounding::upward, convention::owned>,
          rounding::Backend B = rounding::upward>
class surface_traversal {
public:
  /// Octants of the last level looked at before a ray is given up as undecided.
  static constexpr std::uint64_t most_leaves = 4096;

  /// `octree` must come from voxelizing the same surface in the same domain, and outlive this
  /// object. Refuses a level outside 1..53 or at which the octree's root is not exact.
  [[nodiscard]] static expected<surface_traversal> make(const F& surface, const box& domain,
                                                        const sparse_octree& octree, int level) {
    const expected<root_cube> root = root_cube::make(octree.box(), level);
    if (!root)
      return unexpected{root.reason()};
    return surface_traversal(surface, domain, octree, level);
  }

  /// Takes the rounding scopes itself. Where flushing to zero would remain on, nothing is proven:
  /// undecided, [0, infinity].
  [[nodiscard]] surface_hit first_hit(const ray& r, traversal_counts* counts = nullptr) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const typename M::scope method_scope;
    [[maybe_unused]] const surface_scope scope;
    surface_hit result{verdict::miss, infinity, infinity, {{}, 0}, false};
    if ((_mm_getcsr() & flush_bits) != 0) {
      result.outcome = verdict::undecided;
      result.t_near = 0;
      return result;
    }

    const along_ray<F, B> g(surface_, r);
    const ray_span in_domain = g.within(domain_);
    if (in_domain.empty())
      return result;
    root_search<F, B> search(g, in_domain);
    const continued_octree<F, B> tree(surface_, domain_, *octree_);
    traversal_counts seen;
    std::uint64_t looked_at = 0;
    const auto visit = [&](const cube& cell, const auto&, const auto&) {
      const box b = intersection(closed_box(cell), domain_);
      if (b.empty())
        return false;
      if (result.leaf.size == 0) {
        const content c = leaf_content<B>(surface_, b);
        if (c == content::none)
          return false;
        result.leaf = cell;
        result.certified_leaf = c == content::certified;
      }
      if (search.keep(g.within(b)))
        ++seen.leaves_kept;
      return search.proven() || ++looked_at == most_leaves;
    };
    const bool stopped = descend(M(r), octree_->box(), level_, tree, visit, &seen.cells_opened);
    if (counts != nullptr) {
      counts->cells_opened += seen.cells_opened;
      counts->leaves_kept += seen.leaves_kept;
    }
    if (search.proven()) {
      result.outcome = verdict::hit;
      result.t_near = search.near();
      result.t_far = search.far();
    } else if (stopped) {
      result.outcome = verdict::undecided;
      result.t_near = search.any() ? search.near() : in_domain.entry_down;
      result.t_far = in_domain.exit_up;
    } else if (search.any()) {
      result.outcome = verdict::undecided;
      result.t_near = search.near();
      result.t_far = search.far();
    }
    return result;
  }

  [[nodiscard]] int level() const { return level_; }

private:
  surface_traversal(const F& surface, const box& domain, const sparse_octree& octree, int level)
      : surface_(surface), domain_(domain), octree_(&octree), level_(level) {}

  static constexpr unsigned flush_bits = 0x8040; // MXCSR: FTZ and DAZ
  struct no_scope {};
  using surface_scope = std::conditional_t<std::is_same_v<typename M::scope, typename B::scope>,
                                           no_scope, typename B::scope>;

  F surface_;
  box domain_;
  const sparse_octree* octree_;
  int level_;
};

} // namespace graze::octree
