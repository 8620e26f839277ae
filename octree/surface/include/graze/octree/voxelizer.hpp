#pragma once
/// Voxelization of a surface into a sparse octree. lane_kernels.hpp does the same eight children at
/// a time, parallel_voxelizer.hpp on several threads: the same bytes. lazy_octree.hpp does it only
/// where it is looked at: the same leaves.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/scalar_judge.hpp>
#include <graze/octree/sparse_octree.hpp>

namespace graze::octree {

namespace detail {
/// Adds what is below octants to an octree, in post-order.
template <ChildrenJudge J> class voxelization {
public:
  using octant = typename J::octant;
  using inner = sparse_octree::builder::inner;
  voxelization(const J& judge, int last_level, sparse_octree::builder& out)
      : judge_(judge), last_level_(last_level), out_(out) {}

  /// The node of an octant above the last level; mask 0 if nothing is left in it. Within a scope of
  /// the judge. Without meaning once the builder is full.
  inner node(octant o, int level) {
    return level + 1 == last_level_ ? leaves_below(o) : nodes_below(o, level);
  }

private:
  inner nodes_below(octant& o, int level) {
    inner found[8];
    unsigned count = 0, mask = 0;
    for (unsigned rest = judge_.open(o); rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(__builtin_ctz(rest));
      const inner n = node(o.child(i), level + 1);
      if (n.mask == 0)
        continue;
      found[count++] = n;
      mask |= 1u << i;
    }
    const inner r{static_cast<std::uint8_t>(mask), out_.next_node()};
    if (!out_.full()) [[likely]]
      out_.add(found, count);
    return r;
  }

  inner leaves_below(octant& o) {
    inner r{0, out_.next_leaf()};
    if (out_.full()) [[unlikely]]
      return r;
    const leaf_children leaves = judge_.leaves(o);
    r.mask = leaves.mask;
    if (leaves.mask != 0)
      out_.add(leaves);
    return r;
  }

  const J& judge_;
  int last_level_;
  sparse_octree::builder& out_;
};

/// The same for any judge; one that can do all below an octant by itself, does.
template <ChildrenJudge J>
sparse_octree::builder::inner voxelize_below(const J& judge, const typename J::octant& o, int level,
                                             int last_level, sparse_octree::builder& out) {
  if constexpr (requires { judge.voxelize(o, level, last_level, out); })
    return judge.voxelize(o, level, last_level, out);
  else
    return voxelization<J>(judge, last_level, out).node(o, level);
}

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
  const auto top =
      detail::voxelize_below(judge, typename J::octant(root.root_octant()), 0, root.level(), out);
  if (out.full())
    return unexpected{detail::too_many_nodes};
  return std::move(out).finish(top);
}

/// The octants of root.level() that f = 0 meets within `domain`: every closed octant that holds a
/// zero of f in the closed domain is kept; one is left out only where an enclosure proves that
/// there is none. Leaves say whether a zero is certified. The surface is cut at the domain's faces.
/// Refuses an empty domain and an octree of more than 2^32 nodes. Takes a scope of B itself.
/// Source: docs/definitions.md, contract 6; the paper, sections 2.2 and 2.5.
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
