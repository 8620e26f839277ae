// Rays and segments through voxel sets over grids, judged in rational numbers: both conventions,
// both modes, all paths.
#include "../../support/paths.hpp"
#include "../../support/test_inputs.hpp"
#include "hard_grids.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <graze/octree/voxel_rays.hpp>

using namespace graze;
using namespace graze::grid_tests;
namespace rational = graze::oracle::rational;

namespace {

using index3 = std::array<std::uint32_t, 3>;

template <class F> void on_each_path(F f) {
  test::for_each_path([&](batch::path p) {
    REQUIRE(!batch::force_path(p));
    f(p);
  });
  batch::unforce_path();
}

/// The voxels that a line reports.
std::vector<voxel> all_of(const voxel_set& set, const hard_line& l, convention c, exactness e) {
  std::vector<voxel> found;
  const auto keep = [&](const voxel& v) {
    found.push_back(v);
    return false;
  };
  if (const ray* r = std::get_if<ray>(&l.given))
    visit_voxels(set, *r, c, e, l.part, keep);
  else
    visit_voxels(set, std::get<segment>(l.given), c, e, keep);
  return found;
}
std::optional<voxel> first_of(const voxel_set& set, const hard_line& l) {
  if (const ray* r = std::get_if<ray>(&l.given))
    return first_voxel(set, *r, exactness::exact, l.part);
  return first_voxel(set, std::get<segment>(l.given));
}
std::uint32_t count_of(const voxel_set& set, const hard_line& l, convention c, exactness e) {
  std::uint32_t n = 0;
  if (const ray* r = std::get_if<ray>(&l.given))
    (void)count_voxels(set, std::span(r, 1), c, e, std::span(&n, 1), l.part);
  else
    (void)count_voxels(set, std::span(&std::get<segment>(l.given), 1), c, e, std::span(&n, 1));
  return n;
}

/// What is true of an occupied voxel.
struct judged {
  index3 index;
  bool touched, owned;
  mpq_class first, last; ///< of the t in the closed voxel, if touched
};

bool same_index(const voxel& v, const index3& i) {
  return v.index(0) == i[0] && v.index(1) == i[1] && v.index(2) == i[2];
}

struct tally {
  std::uint64_t lines = 0, touched = 0, owned = 0, extra = 0;
};

void compare(const voxel_set& set, const hard_line& l, const std::vector<judged>& truth, tally& n) {
  ++n.lines;
  for (const judged& j : truth) {
    n.touched += j.touched;
    n.owned += j.owned;
  }
  std::array<std::vector<voxel>, 4> first_path;
  bool first = true;
  on_each_path([&](batch::path p) {
    for (unsigned k = 0; k < 4; ++k) {
      const convention c = (k & 1) != 0 ? convention::owned : convention::closed;
      const exactness e = (k & 2) != 0 ? exactness::exact : exactness::conservative;
      const std::vector<voxel> found = all_of(set, l, c, e);
      INFO(batch::name(p) << (k & 1 ? ", owned" : ", closed") << (k & 2 ? ", exact" : ""));
      std::vector<const judged*> order;
      std::size_t wanted = 0;
      for (const voxel& v : found) {
        const auto is = std::find_if(truth.begin(), truth.end(),
                                     [&](const judged& j) { return same_index(v, j.index); });
        REQUIRE(is != truth.end()); // occupied
        REQUIRE(set.voxel_count() > v.rank);
        const bool right = c == convention::owned ? is->owned : is->touched;
        if (e == exactness::exact)
          REQUIRE(right);
        n.extra += !right;
        wanted += right;
        if (right)
          order.push_back(&*is);
      }
      std::size_t all = 0;
      for (const judged& j : truth)
        all += c == convention::owned ? j.owned : j.touched;
      REQUIRE(wanted == all); // none missed, none twice
      std::vector<std::uint32_t> ranks;
      for (const voxel& v : found)
        ranks.push_back(v.rank);
      std::sort(ranks.begin(), ranks.end());
      REQUIRE(std::unique(ranks.begin(), ranks.end()) == ranks.end());
      if (c == convention::owned)
        for (std::size_t i = 1; i < order.size(); ++i) {
          REQUIRE(order[i - 1]->first <= order[i]->first);
          REQUIRE(order[i - 1]->last <= order[i]->last);
        }
      REQUIRE(count_of(set, l, c, e) == found.size());
      if (k == 3) {
        const auto hit = first_of(set, l);
        REQUIRE(hit.has_value() == !found.empty());
        if (hit)
          REQUIRE(*hit == found.front());
      }
      if (first)
        first_path[k] = found;
      REQUIRE(found == first_path[k]);
    }
    first = false;
  });
}

} // namespace

TEST_CASE("octree.voxel_rays: over grids exact walks report what rational numbers do",
          "[mpfr][property]") {
  tally n;
  const auto grids = static_cast<std::uint64_t>(test::input_count() / 50);
  for (std::uint64_t i = 0; i < grids; ++i) {
    random_stream r(1620, i);
    const hard_grid g = make_grid(r, r.one_in(6) ? 1u << r.between(8, 14) : 90);
    const place at = make_place(r, g.planes);
    std::vector<index3> occupied;
    const bool all = !r.one_in(3);
    for (std::uint32_t x = 0; x < at.extent[0]; ++x)
      for (std::uint32_t y = 0; y < at.extent[1]; ++y)
        for (std::uint32_t z = 0; z < at.extent[2]; ++z)
          if (all || r.coin())
            occupied.push_back({at.base[0] + x, at.base[1] + y, at.base[2] + z});
    const auto set = voxel_set::make(g.planes, occupied);
    REQUIRE(set);
    // planes once, in rational numbers
    std::array<std::vector<mpq_class>, 3> planes;
    for (unsigned a = 0; a < 3; ++a)
      for (std::uint32_t k = 0; k <= at.extent[a]; ++k)
        planes[a].push_back(g.plane(a, g.planes.flat(static_cast<int>(a)) ? 0 : at.base[a] + k));
    for (int k = 0; k < 4; ++k) {
      const hard_line l = make_line(r, g, at);
      const rational::line exact = l.rational();
      std::vector<judged> truth;
      for (const index3& v : occupied) {
        rational::box c;
        unsigned upper_closed = 0;
        for (unsigned a = 0; a < 3; ++a) {
          c.lo[a] = planes[a][v[a] - at.base[a]];
          c.hi[a] = planes[a][v[a] - at.base[a] + 1];
          if (v[a] + 1 == g.planes.count(static_cast<int>(a)))
            upper_closed |= 1u << a;
        }
        judged j{v, false, rational::meets(exact, c, 7, upper_closed), 0, 0};
        if (const auto p = rational::common_part(exact, c)) {
          j.touched = true;
          j.first = p->first;
          j.last = p->last;
        }
        truth.push_back(std::move(j));
      }
      INFO("grid " << i << " (" << name_of(g.planes.rule()) << "), line " << k);
      compare(*set, l, truth, n);
    }
  }
  CHECK(n.touched > n.lines);
  CHECK(n.owned > n.lines / 2);
  CHECK(n.extra > 0); // lines that no filter decides were among them
}

TEST_CASE("octree.voxel_rays: segments between points through octants", "[mpfr][property]") {
  // the same sets as root cubes and as grids: the same answers
  std::uint64_t found = 0;
  for (std::uint64_t i = 0; i < 3'000; ++i) {
    random_stream r(1621, i);
    const int level = r.between(1, 12);
    const double size = std::ldexp(r.coin() ? 1.0 : 3.0, r.one_in(8) ? -1000 : 0);
    const std::uint32_t side = 1u << level;
    const double edge = std::ldexp(size, -level);
    const hard_grid g{*grid::make({-size, 0, 0}, {edge, edge, edge}, {side, side, side},
                                  r.coin() ? plane_rule::exact : plane_rule::rounded),
                      {axis_plan{-size, edge, side}, {0, edge, side}, {0, edge, side}},
                      edge};
    const place at = make_place(r, g.planes);
    std::vector<index3> occupied;
    for (std::uint32_t x = 0; x < at.extent[0]; ++x)
      for (std::uint32_t y = 0; y < at.extent[1]; ++y)
        for (std::uint32_t z = 0; z < at.extent[2]; ++z)
          occupied.push_back({at.base[0] + x, at.base[1] + y, at.base[2] + z});
    const voxel_set octants =
        *voxel_set::make(*root_cube::make({{-size, 0, 0}, size}, level), occupied);
    const voxel_set voxels = *voxel_set::make(g.planes, occupied);
    for (int k = 0; k < 4; ++k) {
      const hard_line l = make_line(r, g, at);
      on_each_path([&](batch::path p) {
        INFO(batch::name(p) << ", " << i << ", line " << k);
        for (const convention c : {convention::closed, convention::owned}) {
          const std::vector<voxel> a = all_of(octants, l, c, exactness::exact);
          REQUIRE(a == all_of(voxels, l, c, exactness::exact));
          const std::vector<voxel> b = all_of(octants, l, c, exactness::conservative);
          REQUIRE(b.size() >= a.size());
          REQUIRE(b == all_of(voxels, l, c, exactness::conservative));
          found += a.size();
          // cells say the same
          std::size_t met = 0;
          for (std::uint32_t rank = 0; const index3& v : occupied) {
            const slabs cell =
                octants.cell({v[0] | std::uint64_t{v[1]} << 21 | std::uint64_t{v[2]} << 42, rank});
            met += c == convention::closed ? touches(l.prepared(), cell) : owns(l.prepared(), cell);
          }
          REQUIRE(met == a.size());
        }
      });
    }
  }
  CHECK(found > 20'000);
}

TEST_CASE("octree.voxel_rays: nothing is certain where a bound is beyond the doubles",
          "[regression]") {
  // Upward, a plane less the origin is infinite; to nearest it is the greatest double. The ray is in
  // the plane y = z.
  const double most = 0x1.fffffffffffffp+1023;
  const std::vector<double> planes{0, 0.25, 0.5, 0.75, 1};
  const std::vector<index3> occupied{{1, 0, 2}};
  const voxel_set of_root = *voxel_set::make(*root_cube::make({{0, 0, 0}, 1}, 2), occupied);
  const voxel_set of_grid = *voxel_set::make(*grid::make({planes, planes, planes}), occupied);
  const ray r = *ray::make({0.5, -most, -most}, {-0x1p-286, most, most});
  on_each_path([&](batch::path) {
    for (const voxel_set* set : {&of_root, &of_grid}) {
      CHECK_FALSE(first_voxel(*set, r));
      const bool any = visit_voxels(*set, r, convention::closed, exactness::exact, {},
                                    [](const voxel&) { return true; });
      CHECK_FALSE(any);
    }
  });
}

TEST_CASE("octree.voxel_rays: a grid of the most voxels on an axis, and one of one voxel",
          "[unit]") {
  const std::uint32_t most = grid::most_voxels;
  const grid g = *grid::make({0, 0, 0}, {0.1, 0.1, 0}, {most, 3, 1}, plane_rule::exact);
  const voxel_set set = *voxel_set::make(g, std::vector<index3>{{most - 1, 2, 0}, {0, 0, 0}});
  CHECK(set.level() == 20);
  const double far = g.lower(0, most);
  on_each_path([&](batch::path) {
    CHECK(first_voxel(set, *segment::make({far, 0.25, 0}, {-1, 0.25, 0}))->index(0) == most - 1);
    CHECK(first_voxel(set, *ray::make({far - 0.05, 0.25, 0}, {1, 0, 0}))->index(0) == most - 1);
    CHECK(first_voxel(set, *ray::make({-1, 0.05, 0}, {1, 0, 0}))->index(0) == 0);
    CHECK_FALSE(first_voxel(set, *ray::make({-1, 0.15, 0}, {1, 0, 0})));
    CHECK_FALSE(first_voxel(set, *ray::make({-1, 0.05, 0x1p-1074}, {1, 0, 0})));
  });
  const grid point = *grid::make({1, 2, 3}, {0, 0, 0}, {1, 1, 1}, plane_rule::exact);
  const voxel_set one = *voxel_set::make(point, std::vector<index3>{{0, 0, 0}});
  on_each_path([&](batch::path) {
    CHECK(first_voxel(one, *ray::make({0, 0, 0}, {1, 2, 3})));
    CHECK_FALSE(first_voxel(one, *ray::make({0, 0, 0}, {1, 2, 0x1.8000000000001p+1})));
  });
  const auto outside = voxel_set::make(g, std::vector<index3>{{0, 3, 0}});
  REQUIRE_FALSE(outside);
  CHECK_THAT(outside.reason(), Catch::Contains("3 on axis 1"));
}
