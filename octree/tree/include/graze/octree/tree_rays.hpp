#pragma once
/// Rays through anybody's octree: all touched cells of a level that a Tree holds, in order, by
/// callback or as a range; the first one; a segment of the ray; batches of rays. Header only: a
/// Tree (descent.hpp) tells which children there are, and everything else is a template over it,
/// with no virtual call. voxel_rays.hpp is several times faster where the cells fit a voxel_set.
///
/// Conventions and exactness as in voxel_rays.hpp, as template parameters. Arithmetic is that of
/// the backend `nearest`, which needs no rounding mode but the one that programs start in.
#include <graze/needs_cxx20.hpp>

#include <cstddef>
#include <graze/octree/ray_segment.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/voxel_rays_state.hpp>
#include <graze/rounding/nearest.hpp>
#include <iterator>
#include <optional>
#include <span>

namespace graze::octree {

/// A cell that a ray meets, and the tree's node of it.
template <Tree T> struct met_cell {
  cube cell;
  typename T::node node;
};

/// A walk through the cells of `level` that the tree holds and the ray's segment meets: a generator
/// whose whole state is in the object; nothing is allocated. `owned` comes front to back. Levels
/// 1 .. root.level(); the tree must outlive the walk.
template <Tree T, convention C = convention::owned, exactness E = exactness::exact>
class tree_walk {
  using method = sound<rounding::nearest, C>;
  using state = typename method::state;
  using bounds = typename method::bounds;

public:
  tree_walk(const T& tree, const root_cube& root, int level, const ray& r,
            const ray_segment& segment = {})
      : tree_(&tree), root_(root.root_octant()), level_(level), ray_(r), segment_(segment),
        touch_(r), method_(r) {
    assert(1 <= level && level <= root.level());
    scale_segment();
    state at;
    if (method_.enter(root_, at) && within_segment(at))
      open(root_, tree.root(), at);
  }

  /// The next cell; nothing at the end.
  std::optional<met_cell<T>> next() {
    while (depth_ > 0) {
      frame& f = stack_[static_cast<unsigned>(depth_ - 1)];
      if (f.next == f.children.size()) {
        --depth_;
        continue;
      }
      const branch<state> b = f.children[f.next++];
      if ((f.present >> b.index & 1) == 0 || !within_segment(b.state))
        continue;
      const cube cell = f.cell.child(b.index);
      const typename T::node node = tree_->child(f.node, b.index);
      if (depth_ < level_)
        open(cell, node, b.state);
      else if (E == exactness::conservative ||
               segment_meets<C>(touch_, ray_, segment_, cell, far_faces(cell)))
        return met_cell<T>{cell, node};
    }
    return std::nullopt;
  }

  class iterator {
  public:
    using value_type = met_cell<T>;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::input_iterator_tag;
    iterator() = default;
    explicit iterator(tree_walk& w) : walk_(&w), at_(w.next()) {}
    const value_type& operator*() const { return *at_; }
    const value_type* operator->() const { return &*at_; }
    iterator& operator++() {
      at_ = walk_->next();
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const iterator& i, std::default_sentinel_t) { return !i.at_; }

  private:
    tree_walk* walk_ = nullptr;
    std::optional<value_type> at_;
  };
  /// A single pass: begins where the walk is.
  iterator begin() { return iterator(*this); }
  static std::default_sentinel_t end() { return std::default_sentinel; }

private:
  struct frame {
    cube cell;
    typename T::node node;
    branches<state> children;
    unsigned next;
    std::uint8_t present;
  };

  void open(const cube& cell, const typename T::node& node, const state& at) {
    frame& f = stack_[static_cast<unsigned>(depth_++)];
    f.cell = cell;
    f.node = node;
    f.children.clear();
    f.next = 0;
    method_.split(cell, at, f.children);
    f.present = tree_->child_mask(node, cell, f.children.mask());
  }

  void scale_segment() {
    using B = rounding::nearest;
    const vec3& given = ray_.direction();
    const double per_unit = scaling_of(given[0], given[1], given[2]).of_parameter;
    const vec3 d = scaled_direction(given);
    const auto x = bounds::mag(d[0]), y = bounds::mag(d[1]), z = bounds::mag(d[2]);
    if (segment_.first() > 0)
      from_ =
          B::mul_down(B::mul_down(B::mul_down(x, y), z), B::mul_down(per_unit, segment_.first()));
    if (segment_.last() == 0)
      to_ = 0;
    else if (segment_.last() < bounds::infinity)
      to_ = B::mul_up(B::mul_up(B::mul_up(x, y), z), B::mul_up(per_unit, segment_.last()));
  }
  [[nodiscard]] bool within_segment(const state& at) const {
    const auto all = bounds::common(bounds::common(at[0], at[1]), at[2]);
    return !(all.leave < from_) && !(to_ < all.enter);
  }
  [[nodiscard]] unsigned far_faces(const cube& c) const {
    unsigned far = 0;
    for (int a = 0; a < 3; ++a)
      if (c.hi(a) == root_.hi(a))
        far |= 1u << a;
    return far;
  }

  const T* tree_;
  cube root_;
  int level_;
  ray ray_;
  ray_segment segment_;
  exact_touch touch_;
  method method_;
  double from_ = 0, to_ = bounds::infinity; ///< the segment in scaled t, rounded outwards
  int depth_ = 0;                           ///< cells that are open
  std::array<frame, max_level> stack_;
};

/// Calls visit(cell, node) for each cell of `level` that the tree holds and the ray's segment
/// meets; stops when visit returns true, and then returns true.
template <convention C = convention::owned, exactness E = exactness::exact, Tree T, class Visit>
bool visit_cells(const T& tree, const root_cube& root, int level, const ray& r,
                 const ray_segment& segment, Visit&& visit) {
  tree_walk<T, C, E> walk(tree, root, level, r, segment);
  while (const auto met = walk.next())
    if (visit(met->cell, met->node))
      return true;
  return false;
}

/// The first cell of `level` that owns a point of the ray's segment (or, conservative, may).
template <exactness E = exactness::exact, Tree T>
[[nodiscard]] std::optional<met_cell<T>> first_cell(const T& tree, const root_cube& root, int level,
                                                    const ray& r, const ray_segment& segment = {}) {
  return tree_walk<T, convention::owned, E>(tree, root, level, r, segment).next();
}

/// visit_cells for each ray, with its number: visit(i, cell, node); true ends that ray.
template <convention C = convention::owned, exactness E = exactness::exact, Tree T, class Visit>
void visit_cells(const T& tree, const root_cube& root, int level, std::span<const ray> rays,
                 const ray_segment& segment, Visit&& visit) {
  for (std::size_t i = 0; i < rays.size(); ++i)
    visit_cells<C, E>(
        tree, root, level, rays[i], segment,
        [&](const cube& cell, const typename T::node& node) { return visit(i, cell, node); });
}

} // namespace graze::octree
