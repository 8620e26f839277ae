#pragma once
/// The first hit of a ray with a surface: descent through the octree to its level and, on the fly,
/// below it; then proof along the ray itself.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <cstdint>
#include <graze/octree/along_ray.hpp>
#include <graze/octree/descent.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/sparse_octree.hpp>
#include <graze/octree/verdict.hpp>
#include <limits>
#include <memory>
#include <type_traits>

namespace graze::octree {

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

/// Octants opened before a ray is given up as undecided: one that keeps so near to the surface that
/// no enclosure tells them apart, along a ruling of a cone, meets 2^level octants.
inline constexpr std::uint64_t most_cells_opened = std::uint64_t{1} << 17;

/// The octree continued below its last level by the surface's own enclosures. Models Tree; its
/// functions are called within a scope of B.
template <Surface F, rounding::Backend B, class Octree = sparse_octree> class continued_octree {
public:
  struct node {
    typename Octree::node index; ///< at or below the octree's last level without meaning
    int depth;
  };

  continued_octree(const F& f, const box& domain, const Octree& octree)
      : f_(f), domain_(domain), octree_(octree) {}

  [[nodiscard]] node root() const { return {octree_.root(), 0}; }
  [[nodiscard]] std::uint8_t child_mask(const node& n, const cube& cell,
                                        std::uint8_t wanted) const {
    if (++opened_ > most_cells_opened) [[unlikely]]
      return 0;
    return n.depth < octree_.level() ? octree_.child_mask(n.index, cell, wanted)
                                     : evaluated_mask(cell, wanted);
  }
  [[nodiscard]] node child(const node& n, unsigned index) const {
    return {n.depth < octree_.level() ? octree_.child(n.index, index) : n.index, n.depth + 1};
  }

  /// More were asked for than most_cells_opened.
  [[nodiscard]] bool exhausted() const { return opened_ > most_cells_opened; }

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
  const Octree& octree_;
  mutable std::uint64_t opened_ = 0; ///< the tree is one ray's
};

/// What is known of the first root while a ray is followed from octant to octant, front to back. No
/// root lies before `near`, nor between octants that are kept; opposite proven signs at two
/// parameters within the domain prove a root, and that the first one is not after the later of the
/// two.
template <Surface F, rounding::Backend B> class root_search {
public:
  root_search(const along_ray<F, B>& g, const ray_span& domain) : g_(g), domain_(domain) {}

  /// Looks at the ray's part in the next octant, of which `s` is the span; returns true if the
  /// octant is kept, which it is unless g is proven free of zeros there.
  bool keep(const ray_span& s) {
    const double first = std::max(s.entry_down, domain_.entry_down);
    const double last = std::min(s.exit_up, domain_.exit_up);
    if (first > last)
      return false;
    look_between(first);
    if (proven())
      return false;
    const int sign = g_.sign_throughout(first, last);
    if (const double t = clamped(first); sign != 0 && first <= t && t <= last)
      note(sign, t);
    if (sign != 0 && !proven())
      return false;
    // No root is before the first octant that may hold one. An octant that the ray only seems to
    // touch, by rounding, may seem to be entered after the next one; but the later octants are
    // beyond a plane that bounds this one, so that no root in them is before its own exit, rounded
    // down.
    if (!any_)
      near_ = std::min(first, s.exit_down);
    far_ = std::max(far_, last);
    step_ = std::max(step_, last - first);
    if (!any_ && !(std::min(positive_at_, negative_at_) <= near_))
      look_before();
    any_ = true;
    if (sign != 0)
      return false; // an octant after the root, by rounding, met before the root's own
    unresolved_ = !look_at(last);
    return true;
  }

  /// Says that no further octant follows.
  void finish() { look_between(domain_.exit_down); }

  [[nodiscard]] bool proven() const { return positive_at_ < infinity && negative_at_ < infinity; }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] double near() const { return std::max(near_, domain_.entry_down); }
  /// Once proven: the later of the two signs; else the end of the last octant kept.
  [[nodiscard]] double far() const {
    return proven() ? std::max(positive_at_, negative_at_) : far_;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// From the domain's entry up to `near` the sign does not change: any point there will do.
  void look_before() {
    if (look_at(near_) || !(domain_.entry_up < near_))
      return;
    if (!look_at(domain_.entry_up / 2 + near_ / 2))
      look_at(domain_.entry_up);
  }

  /// Nor does it change between the last octant kept and the next one: where rounding hides the
  /// sign at the former's end, it shows a little further on.
  void look_between(double next) {
    double step = std::max(step_, std::nextafter(far_, infinity) - far_); // an octant may look flat
    for (; unresolved_ && far_ + step < next; step += step)
      unresolved_ = !look_at(far_ + step);
    unresolved_ = false;
  }

  bool look_at(double t) {
    t = clamped(t);
    const int sign = g_.sign_at(t);
    note(sign, t);
    return sign != 0;
  }

  void note(int sign, double t) {
    if (!(domain_.entry_up <= domain_.exit_down))
      return; // no parameter is certainly in the domain
    if (sign > 0)
      positive_at_ = std::min(positive_at_, t);
    if (sign < 0)
      negative_at_ = std::min(negative_at_, t);
    if (proven() && !continuous_between())
      forget_first(t);
  }
  [[nodiscard]] bool continuous_between() const {
    return g_.is_continuous_on(std::min(positive_at_, negative_at_),
                               std::max(positive_at_, negative_at_));
  }
  /// Signs that may be opposite because g jumps or has a gap prove nothing. The one before may lie
  /// far back, however: first it is looked for anew where the octants kept begin.
  void forget_first(double t) {
    double& before = positive_at_ < negative_at_ ? positive_at_ : negative_at_;
    const int sign = positive_at_ < negative_at_ ? 1 : -1;
    before = clamped(near_);
    if (!(before < t && g_.sign_at(before) == sign && continuous_between()))
      before = infinity;
  }
  [[nodiscard]] double clamped(double t) const {
    return std::max(domain_.entry_up, std::min(t, domain_.exit_down));
  }

  const along_ray<F, B>& g_;
  ray_span domain_;
  double near_ = infinity, far_ = 0;
  double step_ = 0; ///< the longest part of the ray in an octant kept
  double positive_at_ = infinity, negative_at_ = infinity;
  bool any_ = false, unresolved_ = false;
};

/// How the rays of a surface_traversal go down by the method M: here, by descend(). Specialized for
/// methods that look at eight children at a time (descent_eight.hpp).
template <Method M> struct surface_descent {
  template <rounding::Backend B, Surface F, class Octree, class Visit>
  static bool run(const ray& r, const F& f, const box& domain, const Octree& octree, int level,
                  const Visit& visit, std::uint64_t& cells_opened) {
    const continued_octree<F, B, Octree> tree(f, domain, octree);
    std::uint64_t opened = 0;
    const bool stopped = descend(
        M(r), octree.root_octant(), level, tree,
        [&](const cube& cell, const auto&, const auto&) { return tree.exhausted() || visit(cell); },
        &opened);
    cells_opened += std::min(opened, most_cells_opened);
    return stopped || tree.exhausted();
  }
  template <rounding::Backend B, Surface F>
  static content content_of(const F& f, const cube&, const box& b) {
    return leaf_content<B>(f, b);
  }
};

/// What becomes of one ray while the octants of the last level that it meets are looked at, in the
/// order of M. Within the scopes of M and B.
template <Surface F, Method M, rounding::Backend B> class first_hit_in_progress {
public:
  /// Octants of the last level looked at before a ray is given up as undecided.
  static constexpr std::uint64_t most_leaves = 4096;

  first_hit_in_progress(const F& f, const box& domain, const ray& r)
      : surface_(f), domain_(domain), g_(f, r), in_domain_(g_.within(domain)),
        search_(g_, in_domain_) {}
  first_hit_in_progress(const first_hit_in_progress&) = delete;
  first_hit_in_progress& operator=(const first_hit_in_progress&) = delete;

  /// Not proven to pass by the domain; otherwise there is nothing to visit.
  [[nodiscard]] bool in_domain() const { return !in_domain_.empty(); }

  /// Looks at the next octant; true if no other is needed.
  bool visit(const cube& cell) {
    const box b = intersection(closed_box(cell), domain_);
    if (b.empty())
      return false;
    if (result_.leaf.size == 0) {
      const content c = surface_descent<M>::template content_of<B>(surface_, cell, b);
      if (c == content::none)
        return false;
      result_.leaf = cell;
      result_.certified_leaf = c == content::certified;
    }
    if (search_.keep(g_.within(b)))
      ++leaves_kept_;
    return search_.proven() || ++looked_at_ == most_leaves;
  }

  /// The ray's end. `stopped`: visit returned true.
  surface_hit finish(bool stopped, traversal_counts& counts) {
    if (in_domain() && !stopped)
      search_.finish();
    counts.leaves_kept += leaves_kept_;
    if (search_.proven()) {
      result_.outcome = verdict::hit;
      result_.t_near = search_.near();
      result_.t_far = search_.far();
    } else if (stopped) {
      result_.outcome = verdict::undecided;
      result_.t_near = search_.any() ? search_.near() : in_domain_.entry_down;
      result_.t_far = in_domain_.exit_up;
    } else if (search_.any()) {
      result_.outcome = verdict::undecided;
      result_.t_near = search_.near();
      result_.t_far = search_.far();
    }
    return result_;
  }

  [[nodiscard]] static surface_hit nothing_proven() {
    return {verdict::undecided, 0, infinity, {{}, 0}, false};
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const F& surface_;
  const box& domain_;
  along_ray<F, B> g_;
  ray_span in_domain_;
  root_search<F, B> search_;
  surface_hit result_{verdict::miss, infinity, infinity, {{}, 0}, false};
  std::uint64_t leaves_kept_ = 0, looked_at_ = 0;
};

/// First hits with one surface. M is the Method by which the ray descends; the verdicts are proven
/// for the sound one in the convention `owned`, which is front to back; with a baseline they are
/// what that baseline makes of the scene. B evaluates the surface; its scope must be compatible
/// with M's: the same, or one that sets no mode. Octree is a sparse_octree or a lazy_octree, with
/// the same result at any level that is not above the octree's own. Sources: docs/definitions.md,
/// contracts 4 to 7; the paper, Fig. 1.
template <Surface F, Method M = sound<rounding::upward, convention::owned>,
          rounding::Backend B = rounding::upward, class Octree = sparse_octree>
class surface_traversal {
public:
  static constexpr std::uint64_t most_leaves = first_hit_in_progress<F, M, B>::most_leaves;

  /// `octree` must come from voxelizing the same surface in the same domain, and outlive this
  /// object. Refuses a level outside 1..53 or at which the octree's root is not exact.
  [[nodiscard]] static expected<surface_traversal> make(const F& surface, const box& domain,
                                                        const Octree& octree, int level) {
    const expected<root_cube> root = root_cube::make(octree.root_octant(), level);
    if (!root)
      return unexpected{root.reason()};
    return surface_traversal(surface, domain, octree, level);
  }

  /// The same for arguments that make() has accepted before.
  [[nodiscard]] static surface_traversal accepted(const F& surface, const box& domain,
                                                  const Octree& octree, int level) {
    return surface_traversal(surface, domain, octree, level);
  }

  /// Takes the rounding scopes itself. Where flushing to zero would remain on, nothing is proven:
  /// undecided, [0, infinity].
  [[nodiscard]] surface_hit first_hit(const ray& r, traversal_counts* counts = nullptr) const {
    [[maybe_unused]] const typename M::scope method_scope;
    [[maybe_unused]] const surface_scope scope;
    if (results_are_flushed())
      return progress::nothing_proven();
    traversal_counts seen;
    progress found(surface_, domain_, r);
    const bool stopped =
        found.in_domain() &&
        surface_descent<M>::template run<B>(
            r, surface_, domain_, *octree_, level_,
            [&found](const cube& cell) { return found.visit(cell); }, seen.cells_opened);
    const surface_hit result = found.finish(stopped, seen);
    if (counts != nullptr) {
      counts->cells_opened += seen.cells_opened;
      counts->leaves_kept += seen.leaves_kept;
    }
    return result;
  }

  [[nodiscard]] int level() const { return level_; }

private:
  surface_traversal(const F& surface, const box& domain, const Octree& octree, int level)
      : surface_(surface), domain_(domain), octree_(&octree), level_(level) {}

  using progress = first_hit_in_progress<F, M, B>;
  struct no_scope {};
  using surface_scope = std::conditional_t<std::is_same_v<typename M::scope, typename B::scope>,
                                           no_scope, typename B::scope>;

  F surface_;
  box domain_;
  const Octree* octree_;
  int level_;
};

} // namespace graze::octree
