#pragma once
/// Baseline `published`: the paper's ray voxelization to the letter. It stays in the code to be
/// measured against; it misses octants.
#include <graze/octree/descent.hpp>
#include <graze/octree/ray.hpp>
#include <graze/rounding/nearest.hpp>

namespace graze::peers {

using octree::branches;
using octree::cube;
using octree::vec3;

/// Section 2.4 as printed: c = sign(d) |d'| |d''| rounded once; x - x0 rounded once and only the
/// product rounded both ways; "no overlap when a lower bound of an interval is equal to the upper
/// bound of another"; no rule for a zero component, whose sign, and so whose c, is zero.
/// Section 2.3's rule that octants behind the origin are ignored is the positive upper bound.
class published {
public:
  static constexpr char name[] = "published", title[] = "as published";
  static constexpr char summary[] = "the paper's ray voxelization to the letter";
  using scope = rounding::nearest::scope;
  struct interval {
    double lower, upper;
  };
  using state = std::array<interval, 3>;

  explicit published(const octree::ray& r) : origin_(r.origin()) {
    const vec3& d = r.direction();
    for (int a = 0; a < 3; ++a) {
      const double sign = d[a] < 0 ? -1 : (d[a] > 0 ? 1 : 0);
      c_[a] = sign * (std::fabs(d[(a + 1) % 3]) * std::fabs(d[(a + 2) % 3]));
    }
  }

  [[nodiscard]] bool enter(const cube& root, state& at) const {
    for (int a = 0; a < 3; ++a)
      at[a] = between(a, bound(a, root.lo[a]), bound(a, root.hi(a)));
    return overlap(at[0], at[1], at[2]);
  }

  void split(const cube& cell, const state&, branches<state>& out) const {
    std::array<std::array<interval, 2>, 3> half;
    const unsigned izyx = first_child(cell);
    for (int a = 0; a < 3; ++a) {
      const double mid = cell.mid(a);
      const interval lo = bound(a, cell.lo[a]);
      const interval middle = bound(a, mid);
      const interval hi = bound(a, cell.hi(a));
      half[a] = {between(a, lo, middle), between(a, middle, hi)};
    }
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned index = i ^ izyx;
      const state child{half[0][index & 1], half[1][index >> 1 & 1], half[2][index >> 2 & 1]};
      if (overlap(child[0], child[1], child[2]))
        out.push(index, child);
    }
  }

  /// What split finds out about one child.
  [[nodiscard]] unsigned first_child(const cube& cell) const {
    unsigned izyx = 0;
    for (int a = 0; a < 3; ++a)
      izyx |= (origin_[a] >= cell.mid(a) ? 1u : 0u) << a;
    return izyx;
  }
  [[nodiscard]] bool enter_child(const cube& cell, unsigned index, state& at) const {
    return enter(cell.child(index), at);
  }

private:
  /// f(x) = c (x - x0), rounded both ways after one rounding of the difference.
  [[nodiscard]] interval bound(int a, double x) const {
    const double difference = x - origin_[a];
    return {rounding::nearest::mul_down(c_[a], difference),
            rounding::nearest::mul_up(c_[a], difference)};
  }
  /// [f(lo), f(hi)], turned round where the ray goes backward.
  [[nodiscard]] interval between(int a, const interval& lo, const interval& hi) const {
    return c_[a] < 0 ? interval{hi.lower, lo.upper} : interval{lo.lower, hi.upper};
  }
  [[nodiscard]] static bool overlap(const interval& x, const interval& y, const interval& z) {
    const double upper = std::min({x.upper, y.upper, z.upper});
    return std::max({x.lower, y.lower, z.lower}) < upper && 0 < upper;
  }

  vec3 origin_, c_{};
};

} // namespace graze::peers
