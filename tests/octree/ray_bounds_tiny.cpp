// The ray/octant test over a tiny float, against integer arithmetic: every ray and box of a small
// set of values with underflow, overflow and zeros in it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <graze/exhaustive/tiny_float.hpp>
#include <graze/octree/ray_bounds.hpp>

using namespace graze;
using namespace graze::octree;

namespace {

using tiny = exhaustive::tiny_float<2, -2, 2>; // +-{0, 1/8, 1/4, 3/8, 1/2, 3/4, ..., 4, 6}
using triple = std::array<tiny, 3>;

/// Exact, in multiples of 1/8: the ray meets the closed box iff the largest entry t is at most the
/// smallest exit t, t >= 0; each t is a fraction with a positive denominator.
bool touches_exactly(const std::array<int, 3>& o, const std::array<int, 3>& d,
                     const std::array<int, 3>& lo, const std::array<int, 3>& hi) {
  struct fraction {
    long n, d;
  };
  const auto less = [](fraction a, fraction b) { return a.n * b.d < b.n * a.d; };
  fraction enter{0, 1};
  fraction leave{1, 0}; // infinity
  for (int a = 0; a < 3; ++a) {
    if (d[a] == 0) {
      if (o[a] < lo[a] || hi[a] < o[a])
        return false;
      continue;
    }
    const int sign = d[a] < 0 ? -1 : 1;
    const fraction in{sign * long((d[a] > 0 ? lo[a] : hi[a]) - o[a]), std::abs(d[a])};
    const fraction out{sign * long((d[a] > 0 ? hi[a] : lo[a]) - o[a]), std::abs(d[a])};
    if (less(enter, in))
      enter = in;
    if (less(out, leave))
      leave = out;
  }
  return !less(leave, enter);
}

int eighths(tiny x) { return static_cast<int>(x.value * 8); }

struct tally {
  std::uint64_t pairs = 0, touched = 0, missed = 0, not_a_number = 0;
};

/// Every ray with components in `values`, against every box with corners in `values`, on axes 1 and
/// 2; axis 0 runs over fewer values so that the whole stays at some 10^7 pairs.
template <class B> tally try_all(const std::vector<tiny>& values, const std::vector<tiny>& few) {
  using bounds = ray_bounds<B>;
  tally result;
  for (const tiny ox : few)
    for (const tiny oy : values)
      for (const tiny oz : few)
        for (const tiny dx : few)
          for (const tiny dy : values)
            for (const tiny dz : few) {
              if (dx.value == 0 && dy.value == 0 && dz.value == 0)
                continue;
              const triple o{ox, oy, oz}, d{dx, dy, dz};
              const auto axes = bounds::prepare(o, d);
              for (std::size_t i = 0; i + 1 < values.size(); i += 4)
                for (std::size_t j = i + 1; j < values.size(); j += 5)
                  for (std::size_t k = 0; k + 1 < few.size(); k += 2) {
                    const triple lo{few[k], values[i], few[k]};
                    const triple hi{few[k + 1], values[j], few[k + 1]};
                    const auto in = [](const triple& t) {
                      return std::array<int, 3>{eighths(t[0]), eighths(t[1]), eighths(t[2])};
                    };
                    ++result.pairs;
                    for (int a = 0; a < 3; ++a) {
                      const auto w =
                          bounds::template within<convention::closed>(axes[a], lo[a], hi[a]);
                      if (w.enter != w.enter || w.leave != w.leave)
                        ++result.not_a_number;
                    }
                    if (!touches_exactly(in(o), in(d), in(lo), in(hi)))
                      continue;
                    ++result.touched;
                    if (!bounds::touches_box(axes, lo, hi))
                      ++result.missed;
                  }
            }
  return result;
}

/// A backend without direction, to see that the test can fail.
struct tiny_undirected : exhaustive::tiny_backend<tiny> {
  static tiny nearest(double exact) {
    const tiny down = tiny::round(exact, false), up = tiny::round(exact, true);
    return exact - down.value < up.value - exact ? down : up;
  }
  static tiny sub_down(tiny x, tiny y) { return nearest(x.value - y.value); }
  static tiny sub_up(tiny x, tiny y) { return nearest(x.value - y.value); }
  static tiny mul_down(tiny x, tiny y) { return nearest(x.value * y.value); }
  static tiny mul_up(tiny x, tiny y) { return nearest(x.value * y.value); }
};

std::vector<tiny> few() {
  return {tiny(-6), tiny(-0.75), tiny(-0.125), tiny(0), tiny(0.375), tiny(1.5), tiny(4)};
}

} // namespace

TEST_CASE("octree.ray_bounds: over a tiny float no touched box is missed", "[exhaustive]") {
  const tally sound = try_all<exhaustive::tiny_backend<tiny>>(tiny::finite(), few());
  INFO(sound.pairs << " pairs, " << sound.touched << " touched");
  CHECK(sound.pairs > 10'000'000);
  CHECK(sound.touched > 100'000);
  CHECK(sound.missed == 0);
  CHECK(sound.not_a_number == 0);
}

TEST_CASE("octree.ray_bounds: over a tiny float without directed rounding boxes are missed",
          "[exhaustive]") {
  CHECK(try_all<tiny_undirected>(few(), few()).missed > 0);
}
