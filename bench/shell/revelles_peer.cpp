// Revelles, Urena, Lastra, "An efficient parametric algorithm for octree traversal" (WSCG 2000),
// written from the paper: parameters t0 and t1 of the planes of a node on each axis, t_m their
// means, the first child by the entry plane (table 1) and the next by the exit plane (table 2).
// Top-down and recursive, as there; negative components by reflecting the ray in the middle of the
// octree. It tests a node by its parameters alone and is not exact.
#include "peer.hpp"
#include <algorithm>
#include <limits>

namespace graze::bench::shell {

namespace {

class revelles {
public:
  revelles(const scene& s, findings& out) : s_(s), out_(out) {}

  void trace(const octree::ray& r) {
    const octree::cube& root = s_.tree.box();
    octree::vec3 o = r.origin(), d = r.direction();
    flip_ = 0;
    for (int a = 0; a < 3; ++a) {
      if (d[a] < 0) {
        o[a] = root.lo[a] + root.hi(a) - o[a];
        d[a] = -d[a];
        flip_ |= 1u << a;
      }
      const double inverse = 1 / d[a]; // zero components: infinite, the paper's section 3.3
      t0_[a] = (root.lo[a] - o[a]) * inverse;
      t1_[a] = (root.hi(a) - o[a]) * inverse;
    }
    if (std::max({t0_[0], t0_[1], t0_[2]}) < std::min({t1_[0], t1_[1], t1_[2]}))
      node(t0_[0], t0_[1], t0_[2], t1_[0], t1_[1], t1_[2], s_.tree.root(), 0, {0, 0, 0});
  }

private:
  using position = std::array<std::uint32_t, 3>;

  /// Table 1: the entry plane is that of the greatest t0; the other two axes' bits are set where
  /// their middle planes come before it.
  static unsigned first_child(double x0, double y0, double z0, double xm, double ym, double zm) {
    unsigned child = 0;
    if (x0 > y0 && x0 > z0) {
      child |= ym < x0 ? 2u : 0;
      child |= zm < x0 ? 4u : 0;
    } else if (y0 > z0) {
      child |= xm < y0 ? 1u : 0;
      child |= zm < y0 ? 4u : 0;
    } else {
      child |= xm < z0 ? 1u : 0;
      child |= ym < z0 ? 2u : 0;
    }
    return child;
  }
  /// Table 2: the child across the exit plane, 8 at the end.
  static unsigned next(unsigned child, double x1, double y1, double z1) {
    const unsigned axis = x1 < y1 ? (x1 < z1 ? 1u : 4u) : (y1 < z1 ? 2u : 4u);
    return (child & axis) != 0 ? 8 : child | axis;
  }

  void node(double x0, double y0, double z0, double x1, double y1, double z1, std::uint32_t n,
            int level, const position& at) {
    if (x1 < 0 || y1 < 0 || z1 < 0)
      return;
    if (level == s_.tree.level()) {
      out_.voxels.push_back(std::uint64_t{at[0]} | std::uint64_t{at[1]} << 21 |
                            std::uint64_t{at[2]} << 42);
      return;
    }
    const double xm = 0.5 * (x0 + x1), ym = 0.5 * (y0 + y1), zm = 0.5 * (z0 + z1);
    const unsigned there = s_.tree.child_mask(n, {}, 0xff);
    unsigned child = first_child(x0, y0, z0, xm, ym, zm);
    do {
      const bool x = (child & 1) != 0, y = (child & 2) != 0, z = (child & 4) != 0;
      const double cx = x ? x1 : xm, cy = y ? y1 : ym, cz = z ? z1 : zm;
      const unsigned real = child ^ flip_;
      if ((there >> real & 1) != 0)
        node(x ? xm : x0, y ? ym : y0, z ? zm : z0, cx, cy, cz, s_.tree.child(n, real), level + 1,
             {at[0] * 2 + (real & 1), at[1] * 2 + (real >> 1 & 1), at[2] * 2 + (real >> 2)});
      child = next(child, cx, cy, cz);
    } while (child < 8);
  }

  const scene& s_;
  findings& out_;
  unsigned flip_ = 0;
  octree::vec3 t0_{}, t1_{};
};

} // namespace

peer revelles_peer(const scene& s) {
  return {"revelles", [&s](std::size_t first, std::size_t last, findings& out) {
            revelles r(s, out);
            for (std::size_t i = first; i < last; ++i) {
              const std::size_t before = out.voxels.size();
              r.trace(s.rays[i]);
              out.counts.push_back(static_cast<std::uint32_t>(out.voxels.size() - before));
            }
          }};
}

} // namespace graze::bench::shell
