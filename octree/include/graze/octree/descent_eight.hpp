#pragma once
/// A ray's descent through a voxelized surface and on below it, with the children in the lanes of a
/// path: the cells of descend(sound<B, C>, continued_octree), in their order.
#include <bit>
#include <graze/octree/inclusion_eight.hpp>
#include <graze/octree/sound_eight.hpp>
#include <graze/octree/sparse_octree.hpp>
#include <graze/octree/surface_traversal.hpp>

namespace graze::octree {

/// Calls visit(cell) for each cell of `level` that the ray passes
/// and in which, and in the ancestors of which, f may have a zero within `domain`; stops when visit
/// returns true, and then returns true. `cells_opened` counts the cells whose children were tested.
/// The root, the octree's box, must be exact at `level`. Within a scope of the method.
///
/// A frame holds what its children are made of, not the children: the corner, the bounds at the
/// octant's planes and at its mid-planes. Those of a child are chosen when it is descended into.
template <class Path, convention C, class F, class Visit>
GRAZE_BATCH_INLINE bool descend_eight(const sound_eight<Path, C>& method, const F& f,
                                      const box& domain, const sparse_octree& octree, int level,
                                      const Visit& visit, std::uint64_t& cells_opened) {
  using method_type = sound_eight<Path, C>;
  using lanes = octet<Path>;
  struct frame {
    lanes corner, mid, at, at_mid;
    double half;
    sparse_octree::node node;
    unsigned nearest;
    unsigned pending; ///< in the order of visits
    bool within;      ///< the octant is known to be within the domain
  };
  // not initialized: a frame is written before it is read
  union storage {
    GRAZE_BATCH_INLINE storage() {}
    frame of[max_level];
  } stack;

  const cube& root = octree.box();
  lanes at;
  if (!method.enter(root, at))
    return false;
  const unsigned mirror = method.mirror();
  const int stored = octree.level();
  lanes corner = method_type::corner(root);
  double half = root.size / 2;
  sparse_octree::node node = octree.root();
  bool within = false;
  std::uint64_t open_depths = 0, opened = 0;
  int depth = 0;
  bool stopped = false;
  for (;;) {
    const typename method_type::halves h = method.open(corner, half, at);
    ++opened;
    unsigned present;
    if (depth < stored) {
      present = octree.child_mask(node, root, 0xff);
    } else {
      auto boxes = eight_boxes<Path>::children(corner, h.mid, half);
      unsigned outside = 0;
      if (!within) [[unlikely]] {
        alignas(64) double lo[8];
        corner.store(lo);
        const cube cell{{lo[0], lo[1], lo[2]}, 2 * half};
        within = true;
        for (int a = 0; a < 3; ++a)
          within = within && domain.lo[a] <= cell.lo[a] && cell.hi(a) <= domain.hi[a];
        if (!within)
          outside = boxes.cut(domain);
      }
      present = ~(have_no_zero(f, boxes, reordered(h.passed, mirror) & ~outside) | outside) & 0xff;
    }
    // the order of visits numbers a child by its index XOR the nearest one's
    unsigned pending = reordered(h.passed, h.nearest) & reordered(present, h.nearest ^ mirror);
    frame& here = stack.of[depth];
    here.corner = corner;
    here.mid = h.mid;
    here.at = at;
    here.at_mid = h.at_mid;
    here.half = half;
    here.node = node;
    here.nearest = h.nearest;
    here.within = within;

    if (depth + 1 == level) {
      for (; pending != 0; pending &= pending - 1) {
        const unsigned mirrored = static_cast<unsigned>(std::countr_zero(pending)) ^ h.nearest;
        const lanes leaf = method_type::child_corner(corner, h.mid, mirrored ^ mirror);
        alignas(64) double lo[8];
        leaf.store(lo);
        if (visit(cube{{lo[0], lo[1], lo[2]}, half})) {
          stopped = true;
          break;
        }
      }
      if (stopped)
        break;
    }
    here.pending = pending;
    open_depths |= std::uint64_t{pending != 0} << depth;
    if (open_depths == 0)
      break;
    depth = 63 - std::countl_zero(open_depths);
    frame& from = stack.of[depth];
    const unsigned mirrored = static_cast<unsigned>(std::countr_zero(from.pending)) ^ from.nearest;
    const unsigned index = mirrored ^ mirror;
    from.pending &= from.pending - 1;
    open_depths &= ~(std::uint64_t{from.pending == 0} << depth);
    if (depth + 1 < stored)
      node = octree.child(from.node, index);
    corner = method_type::child_corner(from.corner, from.mid, index);
    at = method_type::child_state(from.at_mid, from.at, mirrored);
    half = from.half / 2;
    within = from.within;
    ++depth;
  }
  cells_opened += opened;
  return stopped;
}

template <class Path, convention C> struct surface_descent<sound_eight<Path, C>> {
  using method = sound_eight<Path, C>;
  template <rounding::Backend B, Surface F, class Visit>
  static GRAZE_BATCH_INLINE bool run(const ray& r, const F& f, const box& domain,
                                     const sparse_octree& octree, int level, const Visit& visit,
                                     std::uint64_t& cells_opened) {
    return descend_eight(method(r), f, domain, octree, level, visit, cells_opened);
  }
  /// leaf_content, with its corners in the lanes.
  template <rounding::Backend B, Surface F>
  static GRAZE_BATCH_INLINE content content_of(const F& f, const cube& cell, const box& b) {
    if (b.hi[0] == cell.hi(0) && b.hi[1] == cell.hi(1) && b.hi[2] == cell.hi(2) &&
        b.lo == cell.lo) {
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

} // namespace graze::octree
