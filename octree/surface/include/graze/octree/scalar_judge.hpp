#pragma once
/// What scalar intervals find of an octant's eight children.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/inclusion.hpp>

namespace graze::octree {

/// By scalar intervals over B, for any surface. `f` must outlive it.
template <Surface F, rounding::Backend B = rounding::upward> class scalar_judge {
public:
  using scope = typename B::scope;
  using octant = cube;
  scalar_judge(const F& f, const box& domain) : f_(&f), domain_(domain) {}

  [[nodiscard]] std::uint8_t open(const cube& cell) const {
    const bool cut = is_cut(cell);
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
      if (const box b = part(cell.child(i), cut); !b.empty() && !has_no_zero<B>(*f_, b))
        mask |= 1u << i;
    return static_cast<std::uint8_t>(mask);
  }

  [[nodiscard]] leaf_children leaves(const cube& cell) const {
    const bool cut = is_cut(cell);
    leaf_children r;
    for (unsigned i = 0; i < 8; ++i) {
      const box b = part(cell.child(i), cut);
      if (b.empty() || has_no_zero<B>(*f_, b))
        continue;
      const content c = leaf_content<B>(*f_, b);
      r.mask = static_cast<std::uint8_t>(r.mask | (c != content::none ? 1u << i : 0));
      r.certified =
          static_cast<std::uint8_t>(r.certified | (c == content::certified ? 1u << i : 0));
    }
    return r;
  }

private:
  /// Part of the octant is outside of the domain.
  [[nodiscard]] bool is_cut(const cube& cell) const { return !contains(domain_, closed_box(cell)); }
  /// The part of a child that counts; empty() outside the domain.
  [[nodiscard]] box part(const cube& child, bool cut) const {
    return cut ? intersection(closed_box(child), domain_) : closed_box(child);
  }

  const F* f_;
  box domain_;
};

} // namespace graze::octree
