#include "mask_tree.hpp"
#include "peers.hpp"
#include <limits>

namespace graze::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct times {
  double x, y, z;
};

/// One ray, mirrored so that no component of its direction is negative (section 3.2).
struct walk {
  const mask_tree& tree;
  std::vector<voxel_key>& found;
  unsigned mirrored = 0; ///< bit a: axis a is
  unsigned resting = 0;  ///< bit a: the ray does not move on axis a
  octree::vec3 origin{}, corner{};
  double voxel = 0;
  unsigned levels = 0;

  /// When the ray is at the mid-plane. An axis without motion (section 3.3) is never at it; +-
  /// infinity says on which side the ray stays.
  double middle(unsigned axis, double in, double out, std::uint32_t position,
                unsigned level) const {
    if ((resting >> axis & 1) == 0) [[likely]]
      return 0.5 * (in + out);
    const double cells = static_cast<double>(1u << (levels - level - 1));
    const double plane = corner[axis] + (2.0 * position + 1.0) * cells * voxel;
    return origin[axis] < plane ? infinity : -infinity;
  }

  /// proc_subtree. `at` is the node's position, mirrored, in nodes of its level.
  void visit(unsigned level, std::uint32_t node, const voxel_index& at, const times& in,
             const times& out) const {
    if (out.x < 0 || out.y < 0 || out.z < 0)
      return;
    if (level == levels) {
      const std::uint32_t last = (1u << levels) - 1;
      found.push_back(key_of({(mirrored & 1) != 0 ? last - at[0] : at[0],
                              (mirrored & 2) != 0 ? last - at[1] : at[1],
                              (mirrored & 4) != 0 ? last - at[2] : at[2]}));
      return;
    }
    const times mid{middle(0, in.x, out.x, at[0], level), middle(1, in.y, out.y, at[1], level),
                    middle(2, in.z, out.z, at[2], level)};
    // first_node: the face of entry is that of the last plane entered (tables 1 and 2).
    unsigned index = 0;
    if (in.x > in.y && in.x > in.z)
      index = (mid.y < in.x ? 2u : 0u) | (mid.z < in.x ? 4u : 0u);
    else if (in.y > in.z)
      index = (mid.x < in.y ? 1u : 0u) | (mid.z < in.y ? 4u : 0u);
    else
      index = (mid.x < in.z ? 1u : 0u) | (mid.y < in.z ? 2u : 0u);
    const std::uint32_t mask = tree.mask(level, node);
    while (true) {
      const bool x = (index & 1) != 0, y = (index & 2) != 0, z = (index & 4) != 0;
      const times from{x ? mid.x : in.x, y ? mid.y : in.y, z ? mid.z : in.z};
      const times to{x ? out.x : mid.x, y ? out.y : mid.y, z ? out.z : mid.z};
      const unsigned child = index ^ mirrored;
      if ((mask >> child & 1) != 0)
        visit(level + 1, level + 1 == levels ? 0 : tree.child(level, node, child),
              {2 * at[0] + x, 2 * at[1] + y, 2 * at[2] + z}, from, to);
      // new_node: through the face that is left first (table 3).
      const unsigned exit = to.x < to.y ? (to.x < to.z ? 1u : 4u) : (to.y < to.z ? 2u : 4u);
      if ((index & exit) != 0)
        return;
      index |= exit;
    }
  }
};

} // namespace

template <> struct peer<revelles>::structure {
  explicit structure(const voxel_grid& grid)
      : tree(grid), root(grid.root.box()), voxel(grid.voxel_size()),
        levels(static_cast<unsigned>(grid.level())) {}
  mask_tree tree;
  octree::cube root;
  double voxel;
  unsigned levels;
};

template <>
peer<revelles>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<revelles>::~peer() = default;

template <> void peer<revelles>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  if (structure_->tree.empty())
    return;
  walk w{structure_->tree, found};
  w.voxel = structure_->voxel;
  w.levels = structure_->levels;
  w.corner = structure_->root.lo;
  octree::vec3 in{}, out{};
  for (unsigned a = 0; a < 3; ++a) {
    const double lo = structure_->root.lo[a], hi = structure_->root.hi(static_cast<int>(a));
    double o = r.origin()[a], d = r.direction()[a];
    if (d < 0) {
      o = lo + hi - o;
      d = -d;
      w.mirrored |= 1u << a;
    }
    w.origin[a] = o;
    if (d == 0) {
      w.resting |= 1u << a;
      in[a] = o < lo ? infinity : -infinity;
      out[a] = o < hi ? infinity : -infinity;
    } else {
      in[a] = (lo - o) / d;
      out[a] = (hi - o) / d;
    }
  }
  if (std::max({in[0], in[1], in[2]}) < std::min({out[0], out[1], out[2]}))
    w.visit(0, 0, {0, 0, 0}, {in[0], in[1], in[2]}, {out[0], out[1], out[2]});
}

} // namespace graze::bench
