#pragma once
/// A ray's descent through a voxelized surface and on below it, with the children in the lanes of a
/// path: the cells of descend(sound<B, C>, continued_octree), in their order.
#include <graze/needs_cxx20.hpp>

#include <bit>
#include <graze/octree/inclusion_eight.hpp>
#include <graze/octree/sound_eight.hpp>
#include <graze/octree/sparse_octree.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <new>

namespace graze::octree {

/// A descent, a step at a time, so that those of several rays can be taken in turn: a step waits
/// for its own results for most of its time, and another ray's step does not depend on them.
///
/// Meets, in their order, the cells of `level` that the ray passes and in which, and in the
/// ancestors of which, f may have a zero within `domain`. The root, the octree's box, must be exact
/// at `level`. Within a scope of the method.
///
/// A frame holds what its children are made of, not the children: the corner, the bounds at the
/// octant's planes and at its mid-planes. Those of a child are chosen when it is descended into.
template <class Path, convention C, class F> class eight_descent {
public:
  using method_type = sound_eight<Path, C>;
  using numbers = octet<Path>;

  // not all is initialized: a frame is written before it is read
  GRAZE_BATCH_INLINE eight_descent(const ray& r, const F& f, const box& domain,
                                   const sparse_octree& octree, int level)
      : method_(r), f_(f), domain_(domain), octree_(octree), level_(level) {}

  /// Whether the ray passes the root; only then steps may be taken.
  GRAZE_BATCH_INLINE bool enter() {
    const cube& root = octree_.root_octant();
    corner_ = method_type::corner(root);
    half_ = root.size / 2;
    node_ = octree_.root();
    return method_.enter(root, at_);
  }

  /// Tests the children of one octant, calls visit(cell) for those that are of the last level until
  /// it returns true, and goes on to the next octant. False at the end, or where visit returned
  /// true.
  template <class Visit> GRAZE_BATCH_INLINE bool step(const Visit& visit) {
    const unsigned mirror = method_.mirror();
    const typename method_type::halves h = method_.open(corner_, half_, at_);
    if (opened_ == most_cells_opened) [[unlikely]] {
      stopped_ = true;
      return false;
    }
    ++opened_;
    const unsigned present = depth_ < octree_.level()
                                 ? octree_.child_mask(node_, octree_.root_octant(), 0xff)
                                 : evaluated(h);
    // the order of visits numbers a child by its index XOR the nearest one's
    unsigned pending = reordered(h.passed, h.nearest) & reordered(present, h.nearest ^ mirror);
    if (depth_ + 1 == level_) [[unlikely]] {
      for (; pending != 0; pending &= pending - 1) {
        const unsigned mirrored = static_cast<unsigned>(std::countr_zero(pending)) ^ h.nearest;
        alignas(64) double lo[8];
        method_type::child_corner(corner_, h.mid, mirrored ^ mirror).store(lo);
        if (visit(cube{{lo[0], lo[1], lo[2]}, half_})) {
          stopped_ = true;
          return false;
        }
      }
    }
    frame& here = stack_[depth_];
    here.corner = corner_;
    here.mid = h.mid;
    here.at = at_;
    here.at_mid = h.at_mid;
    here.half = half_;
    here.node = node_;
    here.nearest = h.nearest;
    here.within = within_;
    here.pending = pending;
    open_depths_ |= std::uint64_t{pending != 0} << depth_;
    if (open_depths_ == 0) [[unlikely]]
      return false;
    // The deepest octant that has children left is most often this one; without a branch, since
    // how often is anybody's guess.
    depth_ = 63 - std::countl_zero(open_depths_);
    frame& from = stack_[depth_];
    const unsigned mirrored = static_cast<unsigned>(std::countr_zero(from.pending)) ^ from.nearest;
    const unsigned index = mirrored ^ mirror;
    from.pending &= from.pending - 1;
    open_depths_ &= ~(std::uint64_t{from.pending == 0} << depth_);
    node_ = from.node;
    if (depth_ + 1 < octree_.level())
      node_ = octree_.child(node_, index);
    corner_ = method_type::child_corner(from.corner, from.mid, index);
    at_ = method_type::child_state(from.at_mid, from.at, mirrored);
    half_ = from.half / 2;
    within_ = from.within;
    ++depth_;
    return true;
  }

  /// visit returned true.
  [[nodiscard]] GRAZE_BATCH_INLINE bool stopped() const { return stopped_; }
  /// Cells whose children were tested.
  [[nodiscard]] GRAZE_BATCH_INLINE std::uint64_t opened() const { return opened_; }

private:
  struct frame {
    numbers corner, mid, at, at_mid;
    double half;
    sparse_octree::node node;
    unsigned nearest;
    unsigned pending; ///< in the order of visits
    bool within;      ///< the octant is known to be within the domain
  };

  GRAZE_BATCH_INLINE unsigned evaluated(const typename method_type::halves& h) {
    auto boxes = eight_boxes<Path>::children(corner_, h.mid, half_);
    unsigned outside = 0;
    if (!within_) [[unlikely]] {
      alignas(64) double lo[8];
      corner_.store(lo);
      within_ = true;
      for (int a = 0; a < 3; ++a)
        within_ = within_ && domain_.lo[a] <= lo[a] && lo[a] + 2 * half_ <= domain_.hi[a];
      if (!within_)
        outside = boxes.cut(domain_);
    }
    return ~(have_no_zero(f_, boxes, reordered(h.passed, method_.mirror()) & ~outside) | outside) &
           0xff;
  }

  method_type method_;
  const F& f_;
  const box& domain_;
  const sparse_octree& octree_;
  int level_, depth_ = 0;
  numbers corner_, at_;
  double half_;
  sparse_octree::node node_;
  bool within_ = false, stopped_ = false;
  std::uint64_t open_depths_ = 0, opened_ = 0;
  union {
    frame stack_[max_level];
  };
};

template <class Path, convention C> struct surface_descent<sound_eight<Path, C>> {
  using method = sound_eight<Path, C>;
  template <rounding::Backend B, Surface F, class Visit>
  static GRAZE_BATCH_INLINE bool run(const ray& r, const F& f, const box& domain,
                                     const sparse_octree& octree, int level, const Visit& visit,
                                     std::uint64_t& cells_opened) {
    eight_descent<Path, C, F> d(r, f, domain, octree, level);
    if (!d.enter())
      return false;
    while (d.step(visit)) {
    }
    cells_opened += d.opened();
    return d.stopped();
  }
  /// leaf_content, with its corners in the lanes.
  template <rounding::Backend B, Surface F>
  static GRAZE_BATCH_INLINE content content_of(const F& f, const cube& cell, const box& b) {
    if (b.hi[0] == cell.hi(0) && b.hi[1] == cell.hi(1) && b.hi[2] == cell.hi(2) &&
        b.lo == cell.lo && is_continuous(f)) {
      const eight_signs s =
          signs_at(f, eight_boxes<Path>::corners(method::corner(cell), cell.size));
      if (s.positive != 0 && s.negative != 0)
        return content::certified;
      if (s.positive != 0xff && s.negative != 0xff)
        return content::possible;
    }
    return leaf_content<B>(f, b);
  }
};

/// first_hit of each ray, two rays in turn. Within no scope.
template <class Path, Surface F>
void first_hits_eight(const F& f, const box& domain, const sparse_octree& octree, int level,
                      const ray* rays, std::size_t count, surface_hit* hits,
                      traversal_counts* counts) {
  using B = backend_beside<Path>;
  using method = sound_eight<Path, convention::owned>;
  using progress = first_hit_in_progress<F, method, B>;
  const typename method::scope scope;
  if (results_are_flushed()) {
    for (std::size_t i = 0; i < count; ++i)
      hits[i] = progress::nothing_proven();
    return;
  }
  traversal_counts seen;
  /// A ray on its way.
  struct traveller {
    progress found;
    eight_descent<Path, convention::owned, F> descent;
    GRAZE_BATCH_INLINE traveller(const F& f, const box& domain, const sparse_octree& octree,
                                 int level, const ray& r)
        : found(f, domain, r), descent(r, f, domain, octree, level) {}
    GRAZE_BATCH_INLINE bool step() {
      return descent.step([this](const cube& cell) { return found.visit(cell); });
    }
  };
  union slot {
    GRAZE_BATCH_INLINE slot() {}
    traveller at;
  } slots[2];
  std::size_t next = 0, index[2] = {0, 0};
  // Starts the next ray that enters the root; false where there is none.
  const auto start = [&](int k) {
    for (; next < count; ++next) {
      traveller* const t = ::new (&slots[k].at) traveller(f, domain, octree, level, rays[next]);
      if (t->found.in_domain() && t->descent.enter()) {
        index[k] = next++;
        return true;
      }
      hits[next] = t->found.finish(false, seen);
    }
    return false;
  };
  const auto end = [&](int k) {
    traveller& t = slots[k].at;
    seen.cells_opened += t.descent.opened();
    hits[index[k]] = t.found.finish(t.descent.stopped(), seen);
  };
  bool first = start(0), second = first && start(1);
  while (first && second) {
    if (!slots[0].at.step()) [[unlikely]] {
      end(0);
      first = start(0);
    }
    if (!slots[1].at.step()) [[unlikely]] {
      end(1);
      second = start(1);
    }
  }
  if (first || second) {
    const int k = first ? 0 : 1;
    while (slots[k].at.step()) {
    }
    end(k);
  }
  if (counts != nullptr) {
    counts->cells_opened += seen.cells_opened;
    counts->leaves_kept += seen.leaves_kept;
  }
}

} // namespace graze::octree
