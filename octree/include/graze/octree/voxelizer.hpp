#pragma once
/// Voxelization of a surface into a sparse octree. parallel_voxelizer.hpp does the same on several
/// threads, lazy_octree.hpp only where it is looked at, voxelizer_kernels.hpp eight children at
/// once; all give the same leaves, the first two and the last the same bytes.
#include <array>
#include <graze/octree/children.hpp>
#include <graze/octree/sparse_octree.hpp>

namespace graze::octree {

namespace detail {
/// Adds what is below octants to an octree, in post-order.
template <ChildrenJudge J> class voxelization {
public:
  using inner = sparse_octree::builder::inner;
  voxelization(const J& judge, int last_level, sparse_octree::builder& out)
      : judge_(judge), last_level_(last_level), out_(out) {}

  /// The node of `cell`, an octant above the last level; mask 0 if nothing is left in it. Within a
  /// scope of the judge. Without meaning once the builder is full.
  inner node(const cube& cell, int level) {
    return level + 1 == last_level_ ? leaves_below(cell) : nodes_below(cell, level);
  }

private:
  inner nodes_below(const cube& cell, int level) {
    std::array<inner, 8> found;
    unsigned count = 0, mask = 0;
    for (unsigned rest = judge_.open(cell); rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      const inner n = node(cell.child(i), level + 1);
      if (n.mask == 0)
        continue;
      found[count++] = n;
      mask |= 1u << i;
    }
    const inner r{static_cast<std::uint8_t>(mask), out_.next_node()};
    if (!out_.full())
      for (unsigned i = 0; i < count; ++i)
        out_.add(found[i]);
    return r;
  }

  inner leaves_below(const cube& cell) {
    const inner nothing{0, out_.next_leaf()};
    if (out_.full())
      return nothing;
    const leaf_children leaves = judge_.leaves(cell);
    if (leaves.mask != 0)
      out_.add(leaves);
    return {leaves.mask, nothing.first_child};
  }

  const J& judge_;
  int last_level_;
  sparse_octree::builder& out_;
};

inline bool is_proper(const box& domain) {
  return domain.lo[0] <= domain.hi[0] && domain.lo[1] <= domain.hi[1] &&
         domain.lo[2] <= domain.hi[2];
}
inline constexpr const char* too_many_nodes = "the octree has more than 2^32 nodes at this level";
} // namespace detail

/// The octants of root.level() that the judge keeps. Refuses an octree of more than 2^32 nodes.
/// Takes a scope of the judge itself.
template <ChildrenJudge J>
[[nodiscard]] expected<sparse_octree> voxelize_by(const J& judge, const root_cube& root) {
  [[maybe_unused]] const typename J::scope scope;
  sparse_octree::builder out(root);
  const auto top = detail::voxelization<J>(judge, root.level(), out).node(root.box(), 0);
  if (out.full())
    return unexpected{detail::too_many_nodes};
  return std::move(out).finish(top);
}

/// The octants of root.level() that f = 0 meets within `domain`: every closed octant that holds a
/// zero of f in the closed domain is kept; one is left out only where an enclosure proves that
/// there is none. Leaves say whether a zero is certified. The surface is cut at the domain's faces.
/// Refuses an empty domain and an octree of more than 2^32 nodes. Takes a scope of B itself.
/// Source: DESIGN, contract 6; the paper, sections 2.2 and 2.5.
template <Surface F, rounding::Backend B = rounding::upward>
[[nodiscard]] expected<sparse_octree> voxelize(const F& f, const root_cube& root,
                                               const box& domain) {
  if (!detail::is_proper(domain))
    return unexpected{"domain is empty"};
  return voxelize_by(scalar_judge<F, B>(f, domain), root);
}

/// The same in the smallest symmetric root that holds the domain.
template <Surface F, rounding::Backend B = rounding::upward>
[[nodiscard]] expected<sparse_octree> voxelize(const F& f, const box& domain, int level) {
  const expected<root_cube> root = enclosing_root(domain, level);
  if (!root)
    return unexpected{root.reason()};
  return voxelize<F, B>(f, *root, domain);
}

} // namespace graze::octree
