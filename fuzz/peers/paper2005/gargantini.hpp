#pragma once
/// Baseline `gargantini`: the ray's intersections with the mid-planes, sorted in t. It stays in the
/// code to be measured against; it misses octants.
#include <graze/octree/descent.hpp>
#include <graze/octree/ray.hpp>
#include <limits>

namespace graze::peers {

using octree::branches;
using octree::cube;
using octree::vec3;

/// Gargantini and Atkinson 1993, as the paper's section 2.6 describes it: of the three mid-plane
/// intersections those within the octant's [t_in, t_out] are kept and sorted; they cut the ray into
/// at most four segments, one a child. The first child is that of the point of entry, and each
/// crossing changes its side on one axis.
class gargantini {
public:
  static constexpr char name[] = "gargantini", title[] = "Gargantini";
  static constexpr char summary[] =
      "mid-plane intersections sorted in t (Gargantini and Atkinson 1993)";
  struct scope {};
  struct state {
    double t_in, t_out;
  };

  explicit gargantini(const octree::ray& r) : origin_(r.origin()), direction_(r.direction()) {}

  [[nodiscard]] bool enter(const cube& root, state& at) const {
    at = {0, std::numeric_limits<double>::infinity()};
    for (int a = 0; a < 3; ++a) {
      if (direction_[a] == 0) {
        if (origin_[a] < root.lo[a] || root.hi(a) < origin_[a])
          return false;
        continue;
      }
      const double lo = (root.lo[a] - origin_[a]) / direction_[a];
      const double hi = (root.hi(a) - origin_[a]) / direction_[a];
      at.t_in = std::max(at.t_in, std::min(lo, hi));
      at.t_out = std::min(at.t_out, std::max(lo, hi));
    }
    return at.t_in <= at.t_out;
  }

  void split(const cube& cell, const state& at, branches<state>& out) const {
    struct crossing {
      double t;
      unsigned axis;
    };
    std::array<crossing, 3> crossings;
    unsigned count = 0;
    unsigned index = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const double mid = cell.mid(static_cast<int>(a));
      if (origin_[a] + at.t_in * direction_[a] >= mid)
        index |= 1u << a;
      if (direction_[a] == 0)
        continue;
      const double t = (mid - origin_[a]) / direction_[a];
      if (!(at.t_in < t && t < at.t_out))
        continue;
      unsigned place = count++; // by insertion: gcc 12 warns of std::sort on three elements
      for (; place > 0 && t < crossings[place - 1].t; --place)
        crossings[place] = crossings[place - 1];
      crossings[place] = {t, a};
    }
    double from = at.t_in;
    for (unsigned i = 0; i < count; ++i) {
      out.push(index, {from, crossings[i].t});
      from = crossings[i].t;
      index ^= 1u << crossings[i].axis;
    }
    out.push(index, {from, at.t_out});
  }

private:
  vec3 origin_, direction_;
};

} // namespace graze::peers
