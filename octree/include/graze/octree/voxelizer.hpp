#pragma once
/// Voxelization of a surface into a sparse octree.
#include <array>
#include <graze/octree/sparse_octree.hpp>

namespace graze::octree {

namespace detail {
template <Surface F, rounding::Backend B> class voxelization {
public:
  voxelization(const F& f, const box& domain, const root_cube& root)
      : f_(f), domain_(domain), last_level_(root.level()), out_(root) {}

  using inner = sparse_octree::builder::inner;

  /// The node of `cell`, an octant above the last level; mask 0 if nothing is left in it.
  inner node(const cube& cell, int level) {
    const bool cut = !contains(domain_, closed_box(cell));
    return level + 1 == last_level_ ? leaves_below(cell, cut) : nodes_below(cell, level, cut);
  }
  [[nodiscard]] bool overflowed() const { return overflowed_; }
  sparse_octree finish(const inner& root) { return std::move(out_).finish(root); }

private:
  /// The part of a child that counts; empty() outside the domain.
  [[nodiscard]] box part(const cube& child, bool cut) const {
    return cut ? intersection(closed_box(child), domain_) : closed_box(child);
  }

  inner nodes_below(const cube& cell, int level, bool cut) {
    std::array<inner, 8> found;
    unsigned count = 0, mask = 0;
    for (unsigned i = 0; i < 8; ++i) {
      const cube child = cell.child(i);
      const box b = part(child, cut);
      if (b.empty() || has_no_zero<B>(f_, b))
        continue;
      const inner n = node(child, level + 1);
      if (n.mask == 0)
        continue;
      found[count++] = n;
      mask |= 1u << i;
    }
    const inner r{static_cast<std::uint8_t>(mask), out_.next_node()};
    overflowed_ = overflowed_ || out_.full();
    if (!overflowed_)
      for (unsigned i = 0; i < count; ++i)
        out_.add(found[i]);
    return r;
  }

  inner leaves_below(const cube& cell, bool cut) {
    inner r{0, out_.next_leaf()};
    overflowed_ = overflowed_ || out_.full();
    if (overflowed_)
      return r;
    for (unsigned i = 0; i < 8; ++i) {
      const box b = part(cell.child(i), cut);
      if (b.empty() || has_no_zero<B>(f_, b))
        continue;
      const content c = leaf_content<B>(f_, b);
      if (c == content::none)
        continue;
      out_.add(c);
      r.mask = static_cast<std::uint8_t>(r.mask | 1u << i);
    }
    return r;
  }

  const F& f_;
  box domain_;
  int last_level_;
  sparse_octree::builder out_;
  bool overflowed_ = false;
};
} // namespace detail

/// The octants of root.level() that f = 0 meets within `domain`: every closed octant that holds a
/// zero of f in the closed domain is kept; one is left out only where an enclosure proves that
/// there is none. Leaves say whether a zero is certified. The surface is cut at the domain's faces.
/// Refuses an empty domain and an octree of more than 2^32 nodes. Takes a scope of B itself.
/// Source: DESIGN, contract 6; the paper, sections 2.2 and 2.5.
template <Surface F, rounding::Backend B = rounding::upward>
[[nodiscard]] expected<sparse_octree> voxelize(const F& f, const root_cube& root,
                                               const box& domain) {
  if (!(domain.lo[0] <= domain.hi[0] && domain.lo[1] <= domain.hi[1] &&
        domain.lo[2] <= domain.hi[2]))
    return unexpected{"domain is empty"};
  const typename B::scope scope;
  detail::voxelization<F, B> work(f, domain, root);
  const auto top = work.node(root.box(), 0);
  if (work.overflowed())
    return unexpected{"the octree has more than 2^32 nodes at this level"};
  return work.finish(top);
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
