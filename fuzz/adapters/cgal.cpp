/// CGAL: do_intersect of a ray and a box, which its AABB tree and its octree ask, voxel by voxel;
/// and its octree (bench/peers/cgal.cpp).
///
///   graze-adapter-cgal inexact|epick|epeck|octree|octree-epeck
///
/// inexact: plain double. epick: exact predicates on doubles; CGAL keeps a ray as two points, so it
/// is asked only where origin + direction is exact. epeck: exact constructions too, every ray.
#include "peer.hpp"
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <string_view>

namespace {

/// origin + direction is a triple of doubles, other than origin. (The error of a sum: Knuth.)
bool exact_sum(const adapter::vec3& o, const adapter::vec3& d) {
  for (unsigned a = 0; a < 3; ++a) {
    const double sum = o[a] + d[a], part = sum - o[a];
    if (!std::isfinite(sum) || (o[a] - (sum - part)) + (d[a] - part) != 0)
      return false;
  }
  return true;
}

template <class Kernel> void traverse(const adapter::request& r, adapter::answer& a) {
  const adapter::vec3 &o = r.origin, d = adapter::scaled(r.direction);
  if constexpr (!std::is_same_v<Kernel, CGAL::Epeck>)
    if (!exact_sum(o, d))
      return a.skip();
  a.received(o, d);
  const typename Kernel::Ray_3 ray(typename Kernel::Point_3(o[0], o[1], o[2]),
                                   typename Kernel::Vector_3(d[0], d[1], d[2]));
  for (const adapter::index3& voxel : r.voxels()) {
    const adapter::vec3 lo = r.corner(voxel, 0), hi = r.corner(voxel, 1);
    if (CGAL::do_intersect(ray, CGAL::Bbox_3(lo[0], lo[1], lo[2], hi[0], hi[1], hi[2])))
      a.visit(voxel);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view variant = argc > 1 ? argv[1] : "";
  if (variant == "inexact")
    return adapter::serve("crossed", traverse<CGAL::Simple_cartesian<double>>);
  if (variant == "epick")
    return adapter::serve("exactly-touched", traverse<CGAL::Epick>);
  if (variant == "epeck")
    return adapter::serve("exactly-touched", traverse<CGAL::Epeck>);
  if (variant == "octree")
    return adapter::serve("exactly-touched", adapter::ask_peer<graze::bench::cgal>);
  if (variant == "octree-epeck")
    return adapter::serve("exactly-touched", adapter::ask_peer<graze::bench::cgal_exact>);
  std::fprintf(stderr, "usage: graze-adapter-cgal inexact|epick|epeck|octree|octree-epeck\n");
  return 2;
}
