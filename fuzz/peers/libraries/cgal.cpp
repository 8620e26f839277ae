/// CGAL: do_intersect of a ray and a box, which its AABB tree and its octree ask, box by box; and its
/// octree (since 5.3), intersected_nodes.
///
/// A kernel of doubles keeps a ray as two points, origin and origin + direction: a sum that rounds is
/// another ray. EPICK decides such rays exactly; EPECK's constructions are exact, too, and take every
/// ray, at many times the cost.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Octree.h>
#include <CGAL/Simple_cartesian.h>
#include <peers/library.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

vec3 second_point(const octree::ray& r) {
  const vec3 &o = r.origin(), &d = r.direction();
  return {o[0] + d[0], o[1] + d[1], o[2] + d[2]};
}

template <class Kernel> typename Kernel::Ray_3 ray_by_direction(const octree::ray& r) {
  const vec3 &o = r.origin(), &d = r.direction();
  return {typename Kernel::Point_3(o[0], o[1], o[2]), typename Kernel::Vector_3(d[0], d[1], d[2])};
}

/// Voxel by voxel.
template <class Kernel> class boxes final : public structure {
public:
  explicit boxes(const occupied_octants& octants) {
    for (const octant_index& at : octants.indices) {
      const vec3 lo = octants.corner(at, 0), hi = octants.corner(at, 1);
      boxes_.emplace_back(lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]);
      keys_.push_back(key_of(at));
    }
  }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    if constexpr (!std::is_same_v<Kernel, CGAL::Epeck>)
      for (unsigned a = 0; a < 3; ++a)
        if (!exact_difference(r.origin()[a], -r.direction()[a]))
          return std::nullopt;
    return r;
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const auto ray = ray_by_direction<Kernel>(r);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (CGAL::do_intersect(ray, boxes_[i]))
        found.push_back(keys_[i]);
  }

private:
  std::vector<CGAL::Bbox_3> boxes_;
  std::vector<octant_key> keys_;
};

using points = std::vector<CGAL::Epick::Point_3>;
using octree_of_points = CGAL::Octree<CGAL::Epick, points>;
using node = octree_of_points::Node;

points centres_and_corners(const occupied_octants& octants) {
  points p;
  p.reserve(octants.indices.size() + 2);
  for (const octant_index& at : octants.indices) {
    const vec3 c = octants.corner(at, 0.5);
    p.emplace_back(c[0], c[1], c[2]);
  }
  // The tree takes its root from its points: the root's corners give it ours.
  const octree::cube& root = octants.root;
  p.emplace_back(root.lo[0], root.lo[1], root.lo[2]);
  p.emplace_back(root.hi(0), root.hi(1), root.hi(2));
  return p;
}

/// A tree of octants' centres, asked with rays of a kernel.
template <class Kernel> class tree final : public structure {
public:
  tree(const occupied_octants& octants, const unit_cells& cells)
      : level_(static_cast<std::size_t>(octants.level)), cells_(cells),
        points_(centres_and_corners(octants)),
        tree_(points_, CGAL::Identity_property_map<CGAL::Epick::Point_3>(), 1.0) {
    tree_.refine([this](const node& n) { return n.depth() < level_ && !n.empty(); });
    const int last = cells.side - 1;
    corners_ = {key({0, 0, 0}), key({last, last, last})};
    for (const octant_index& at : octants.indices)
      for (octant_key& corner : corners_)
        if (key_of(at) == corner)
          corner = ~octant_key{0}; // an occupied octant after all
  }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    if constexpr (std::is_same_v<Kernel, CGAL::Epeck>)
      return r;
    else
      return ray_by_points(r.origin(), second_point(r));
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    if constexpr (std::is_same_v<Kernel, CGAL::Epeck>) {
      tree_.intersected_nodes(ray_by_direction<Kernel>(r), kept_leaves{this, &found});
    } else {
      const vec3 &o = r.origin(), e = second_point(r);
      const typename Kernel::Point_3 from(o[0], o[1], o[2]), to(e[0], e[1], e[2]);
      if (from != to) // else the direction is lost in the sum: no ray in CGAL
        tree_.intersected_nodes(typename Kernel::Ray_3(from, to), kept_leaves{this, &found});
    }
  }

private:
  /// An output iterator that keeps the occupied octants among the leaves.
  struct kept_leaves {
    using iterator_category = std::output_iterator_tag;
    using value_type = void;
    using difference_type = void;
    using pointer = void;
    using reference = void;
    const tree* from;
    std::vector<octant_key>* found;

    kept_leaves& operator*() { return *this; }
    kept_leaves& operator++() { return *this; }
    kept_leaves& operator++(int) { return *this; }
    kept_leaves& operator=(const node& leaf) {
      if (leaf.depth() != from->level_ || leaf.empty())
        return *this;
      const auto at = leaf.global_coordinates();
      const octant_key key =
          from->key({static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2])});
      if (key != from->corners_[0] && key != from->corners_[1])
        found->push_back(key);
      return *this;
    }
  };

  /// Of a place in the root.
  [[nodiscard]] octant_key key(const std::array<int, 3>& at) const {
    return cells_.key(cells_.root[0] + at[0], cells_.root[1] + at[1], cells_.root[2] + at[2]);
  }

  std::size_t level_;
  unit_cells cells_;
  points points_;
  octree_of_points tree_;
  std::array<octant_key, 2> corners_{}; ///< where the corners alone make a leaf
};

} // namespace

std::vector<variant> cgal_variants() {
  return {
      {"cgal-inexact", "crossed", timed::no, "CGAL box test, double", "CGAL, ray and box in double",
       built<boxes<CGAL::Simple_cartesian<double>>>},
      {"cgal-epick", "exactly-touched", timed::no, "CGAL box test, EPICK",
       "CGAL, exact predicates; rays that two points hold", built<boxes<CGAL::Epick>>},
      {"cgal-epeck", "exactly-touched", timed::no, "CGAL box test, EPECK",
       "CGAL, exact constructions too", built<boxes<CGAL::Epeck>>},
      {"cgal-octree", "exactly-touched", timed::yes, "CGAL",
       "CGAL's octree, EPICK; rays that two points hold", built_in_cells<tree<CGAL::Epick>>},
      {"cgal-octree-epeck", "exactly-touched", timed::yes, "CGAL, exact rays",
       "CGAL's octree asked with EPECK's rays", built_in_cells<tree<CGAL::Epeck>>},
  };
}

} // namespace graze::peers
