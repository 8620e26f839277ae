// Segments of rays: exactly the points with first <= t <= last. Judged by intervals of rationals.
#include "adversarial.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <gmpxx.h>
#include <graze/octree/tree_rays.hpp>
#include <optional>

using namespace graze;
using namespace graze::interface_tests;

namespace {

/// An interval of t whose ends may be left out; no upper end: unbounded.
struct times {
  mpq_class first = 0;
  std::optional<mpq_class> last;
  bool first_in = true, last_in = true;

  void from(const mpq_class& t, bool in) {
    if (first < t || (first == t && !in)) {
      first = t;
      first_in = in;
    }
  }
  void until(const mpq_class& t, bool in) {
    if (!last || t < *last || (t == *last && !in)) {
      last = t;
      last_in = in;
    }
  }
  [[nodiscard]] bool empty() const {
    return last && (*last < first || (*last == first && !(first_in && last_in)));
  }
};

bool meets(const ray& r, const ray_segment& s, const cube& c, convention reported, unsigned far) {
  times t;
  t.from(mpq_class(s.first()), true);
  if (s.last() < std::numeric_limits<double>::infinity())
    t.until(mpq_class(s.last()), true);
  for (int a = 0; a < 3; ++a) {
    const double o = r.origin()[a], d = r.direction()[a], lo = c.lo[a], hi = c.hi(a);
    const bool hi_in = reported == convention::closed || (far >> a & 1) != 0;
    if (d == 0) {
      if (o < lo || hi < o || (o == hi && !hi_in))
        return false;
      continue;
    }
    const mpq_class to_lo = (mpq_class(lo) - mpq_class(o)) / mpq_class(d),
                    to_hi = (mpq_class(hi) - mpq_class(o)) / mpq_class(d);
    if (d > 0) {
      t.from(to_lo, true);
      t.until(to_hi, hi_in);
    } else {
      t.from(to_hi, hi_in);
      t.until(to_lo, true);
    }
  }
  return !t.empty();
}

/// Ends at, or a few ulps from, the time of a plane of the block; or anywhere.
double hard_time(fuzz::random_stream& random, const fuzz::trial& t) {
  const unsigned a = random.below(3);
  if (random.one_in(8) || t.direction[a] == 0)
    return random.coin() ? 0 : std::ldexp(1.0, random.between(-1074, 1023));
  const double plane = t.plane(static_cast<int>(a), random.below(t.extent[a] + 1u));
  double x = (plane - t.origin[a]) / t.direction[a];
  if (random.coin())
    for (int k = random.between(-2, 2); k != 0; k += k < 0 ? 1 : -1)
      x = std::nextafter(x, k < 0 ? -1e308 : 1e308);
  return x > 0 && std::isfinite(x) ? x : 0;
}

} // namespace

TEST_CASE("octree.voxel_rays: a segment is its points with first <= t <= last, exactly",
          "[mpfr][property]") {
  std::uint64_t found_all = 0, cut_off = 0, touching = 0;
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t i = 0; i < 400; ++i) {
      const sparse_trial t = make_sparse(g, 6, i);
      fuzz::random_stream random(66, i);
      double first = hard_time(random, t.trial), last = hard_time(random, t.trial);
      if (last < first)
        std::swap(first, last);
      if (random.one_in(4))
        first = 0;
      else if (random.one_in(4))
        last = std::numeric_limits<double>::infinity();
      else if (random.one_in(4))
        last = first; // a point
      const ray_segment s = *ray_segment::make(first, last);
      const unsigned block_far = t.trial.at_far_face();
      for (unsigned k = 0; k < 4; ++k) {
        const convention c = (k & 1) != 0 ? convention::owned : convention::closed;
        const exactness e = (k & 2) != 0 ? exactness::exact : exactness::conservative;
        fuzz::octant_set wanted = 0;
        for (unsigned v = 0; v < 64; ++v) {
          if ((t.occupied >> v & 1) == 0)
            continue;
          unsigned far = 0;
          for (unsigned a = 0; a < 3; ++a)
            if ((v >> (2 * a) & 3) + 1u == t.trial.extent[a])
              far |= block_far & 1u << a;
          if (meets(t.the_ray, s, t.trial.octant(static_cast<fuzz::octant_number>(v)), c, far))
            wanted |= fuzz::octant_set{1} << v;
        }
        std::optional<std::vector<voxel>> before;
        on_each_path([&](batch::path) {
          const auto found = all_of(t, c, e, s);
          const fuzz::octant_set answer = numbers(t, found);
          INFO(g.name << " " << i << " " << k);
          REQUIRE((wanted & ~answer) == 0);
          if (e == exactness::exact)
            REQUIRE(answer == wanted);
          if (before)
            REQUIRE(*before == found);
          before = found;
          found_all += found.size();
        });
        if (e == exactness::exact) {
          const fuzz::octant_set whole = numbers(t, all_of(t, c, e));
          cut_off += std::popcount(whole & ~wanted);
          touching += first == last && wanted != 0;
        }
      }
      // the same through a Tree
      const fuzz::block_tree tree(t.trial);
      fuzz::octant_set by_tree = 0;
      visit_cells<convention::closed>(tree, t.root, t.trial.level, t.the_ray, s,
                                      [&](const cube&, const fuzz::block_tree::node& n) {
                                        by_tree |= fuzz::octant_set{1} << tree.octant_of(n);
                                        return false;
                                      });
      REQUIRE((by_tree & t.occupied) ==
              numbers(t, all_of(t, convention::closed, exactness::exact, s)));
    }
  CHECK(found_all > 5'000);
  CHECK(cut_off > 1'000);
  CHECK(touching > 100);
}

TEST_CASE(
    "octree.voxel_rays: a segment's ends are in the units of the direction as given, of any size",
    "[property]") {
  // a direction 2^k times as long, and ends 2^-k times as far: the same points
  std::uint64_t found_all = 0, cut_off = 0;
  for (std::uint64_t i = 0; i < 3'000; ++i) {
    const sparse_trial t = make_sparse(fuzz::generators()[i % 8], 12, i); // ordinary directions
    const auto extreme = [](double d) { return d != 0 && std::fabs(std::ilogb(d)) > 60; };
    if (t.trial.root.size != 1 || std::ranges::any_of(t.trial.direction, extreme))
      continue;
    fuzz::random_stream random(67, i);
    const double middle = std::ldexp(hard_time(random, t.trial), -1);
    double first = random.coin() ? 0 : middle, last = hard_time(random, t.trial);
    if (last < first)
      std::swap(first, last);
    const auto scaled_by = [&](int k) {
      sparse_trial s = t;
      for (unsigned a = 0; a < 3; ++a)
        s.trial.direction[a] = std::ldexp(t.trial.direction[a], k);
      s.the_ray = *ray::make(s.trial.origin, s.trial.direction);
      return s;
    };
    const auto same_numbers = [&](const sparse_trial& s, int k) {
      for (unsigned a = 0; a < 3; ++a)
        if (std::ldexp(s.trial.direction[a], -k) != t.trial.direction[a])
          return false;
      return std::ldexp(std::ldexp(first, -k), k) == first &&
             std::ldexp(std::ldexp(last, -k), k) == last && std::isfinite(std::ldexp(last, -k));
    };
    for (const int k : {-960, -500, 500, 960}) {
      const sparse_trial s = scaled_by(k);
      if (!same_numbers(s, k))
        continue;
      const ray_segment of_t = *ray_segment::make(first, last),
                        of_s = *ray_segment::make(std::ldexp(first, -k), std::ldexp(last, -k));
      for (const convention c : {convention::closed, convention::owned})
        for (const exactness e : {exactness::exact, exactness::conservative}) {
          std::vector<std::vector<voxel>> all;
          on_each_path([&](batch::path) {
            all.push_back(all_of(t, c, e, of_t));
            all.push_back(all_of(s, c, e, of_s));
          });
          INFO(i << " " << k);
          for (const auto& found : all)
            REQUIRE(found == all[0]);
          found_all += all[0].size();
          cut_off += all_of(t, c, e).size() - all[0].size();
        }
      const fuzz::block_tree tree(t.trial);
      const auto by_tree = [&](const ray& r, const ray_segment& segment) {
        std::vector<fuzz::octant_number> cells;
        visit_cells<convention::owned, exactness::conservative>(
            tree, t.root, t.trial.level, r, segment,
            [&](const cube&, const fuzz::block_tree::node& n) {
              cells.push_back(tree.octant_of(n));
              return false;
            });
        return cells;
      };
      REQUIRE(by_tree(t.the_ray, of_t) == by_tree(s.the_ray, of_s));
    }
  }
  CHECK(found_all > 10'000);
  CHECK(cut_off > 10'000);
}

TEST_CASE("octree.ray_segment: refuses what is no segment", "[unit]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(ray_segment::make(-1, 1));
  CHECK_FALSE(ray_segment::make(2, 1));
  CHECK_FALSE(ray_segment::make(infinity, infinity));
  CHECK_FALSE(ray_segment::make(std::nan(""), 1));
  CHECK_FALSE(ray_segment::make(0, std::nan("")));
  CHECK(ray_segment::make(1, 1));
  CHECK(ray_segment::make(-0.0, infinity)->whole());
}

TEST_CASE("octree.ray_segment: the side of a point on a ray, exactly", "[mpfr]") {
  fuzz::random_stream random(8, 8);
  for (int i = 0; i < 20'000; ++i) {
    const auto any = [&] {
      const double m = std::ldexp(static_cast<double>(random.bits(random.between(1, 53))),
                                  random.between(-1074, 970));
      return random.coin() ? m : -m;
    };
    double o = any(), d = any(), t = any(), p = any();
    if (random.coin()) {
      o = std::ldexp(o, -std::ilogb(o == 0 ? 1 : o));
      d = std::ldexp(d, -std::ilogb(d == 0 ? 1 : d));
      t = std::ldexp(t, -std::ilogb(t == 0 ? 1 : t));
      p = o + t * d;
    }
    if (!std::isfinite(o) || !std::isfinite(d) || !std::isfinite(t) || !std::isfinite(p))
      continue;
    const mpq_class exact = mpq_class(o) + mpq_class(t) * mpq_class(d) - mpq_class(p);
    REQUIRE(octree::detail::side_at(o, d, t, p) == sgn(exact));
  }
  // a product of 104 ones and one more: carries run through words that are all ones
  const double d = 0x1p52 - 1, t = 0x1p52 + 1;
  for (int j = -70; j <= 70; ++j)
    for (const double sign : {1.0, -1.0}) {
      const double o = std::ldexp(sign, j), p = std::ldexp(sign, 104 + j);
      REQUIRE(octree::detail::side_at(o, d, std::ldexp(sign * t, j), p) == 0);
    }
}
