// On eight boxes at once and on one: the same enclosures of f, of its mean value form, of its
// gradient and of its slope along a line, bit for bit but for zeros' signs; the same signs; and the
// same boxes without a zero.
#include "../../support/paths.hpp"
#include "evaluate.hpp"
#include "inputs.hpp"
#include "surfaces.hpp"

using namespace graze;
using namespace graze::octree;
using namespace graze::twins;

namespace {

using B = rounding::upward;

struct tally {
  long boxes = 0, free = 0, signs = 0, unbounded = 0, differences = 0;
  std::string first;
};

bool same(const bound<B>& scalar, const eight_bounds& by_lanes, std::size_t i) {
  const bounds x = to_bounds(scalar), y{by_lanes.lo[i], by_lanes.hi[i]};
  return x.is_empty() ? y.lo != y.lo && y.hi != y.hi : x.lo == y.lo && x.hi == y.hi;
}

std::string spelled(const bounds& x) {
  char text[80];
  std::snprintf(text, sizeof text, "[%a, %a]", x.lo, x.hi);
  return text;
}

template <class F, class Evaluate>
void compare(const F& f, Evaluate evaluate, std::uint64_t seed, int rounds, tally& t) {
  random_source random(seed);
  for (int round = 0; round < rounds; ++round) {
    eight_inputs in;
    for (int a = 0; a < 3; ++a) {
      in.direction[a] = random.one_in(5) ? some_place(random) : random.in(-1, 1);
      double first_lo = 0, first_hi = 0;
      some_side(random, first_lo, first_hi);
      for (std::size_t i = 0; i < 8; ++i) {
        double &lo = in.axis[a].lo[i], &hi = in.axis[a].hi[i];
        some_side(random, lo, hi);
        if (random.one_in(3)) // as an octant's children share sides
          lo = first_lo, hi = first_hi;
        if (random.one_in(60)) // beyond what a domain holds, rays reach
          hi = std::numeric_limits<double>::infinity();
        if (random.one_in(60))
          lo = -std::numeric_limits<double>::infinity();
      }
    }
    if (random.one_in(4)) // eight points, as corners are
      for (auto& axis : in.axis)
        for (std::size_t i = 0; i < 8; ++i)
          axis.hi[i] = axis.lo[i] =
              std::isfinite(axis.lo[i]) ? axis.lo[i] : (std::isfinite(axis.hi[i]) ? axis.hi[i] : 0);
    evaluation by_lanes;
    evaluate(f, in, by_lanes);
    const B::scope scope;
    for (std::size_t i = 0; i < 8; ++i) {
      const box b{{in.axis[0].lo[i], in.axis[1].lo[i], in.axis[2].lo[i]},
                  {in.axis[0].hi[i], in.axis[1].hi[i], in.axis[2].hi[i]}};
      const bound3<B> x = intervals<B>(b);
      const bound<B> value = natural_extension<B>(f, x);
      const dual<bound<B>> g = value_and_gradient<B>(f, x);
      using slope = dual<bound<B>, 1>;
      const slope s =
          f(slope{x[0], {bound<B>(in.direction[0])}}, slope{x[1], {bound<B>(in.direction[1])}},
            slope{x[2], {bound<B>(in.direction[2])}});
      const bool none = has_no_zero<B>(f, b);
      const int sign = certified_sign(value);
      std::string apart;
      const auto enclosure = [&](const char* name, const bound<B>& scalar,
                                 const eight_bounds& eight) {
        if (apart.empty() && !same(scalar, eight, i))
          apart = std::string(name) + " " + spelled({scalar.lower(), scalar.upper()}) +
                  " by scalar code, " + spelled({eight.lo[i], eight.hi[i]}) + " by lanes";
      };
      const auto verdict = [&](const char* name, bool scalar, unsigned mask) {
        if (apart.empty() && scalar != ((mask >> i & 1) != 0))
          apart = std::string(name) + (scalar ? " by scalar code alone" : " by lanes alone");
      };
      enclosure("value", value, by_lanes.value);
      enclosure("value of duals", g.value, by_lanes.of_dual);
      for (std::size_t a = 0; a < 3; ++a)
        enclosure("gradient", g.partial[a], by_lanes.gradient[a]);
      enclosure("value along a line", s.value, by_lanes.along);
      enclosure("slope", s.partial[0], by_lanes.slope);
      verdict("positive", sign > 0, by_lanes.positive);
      verdict("negative", sign < 0, by_lanes.negative);
      if (std::isfinite(b.lo[0] + b.hi[0]) && std::isfinite(b.lo[1] + b.hi[1]) &&
          std::isfinite(b.lo[2] + b.hi[2])) {
        enclosure("mean value form", mean_value_form<B>(f, x, g.partial), by_lanes.mean_value);
        verdict("no zero", none, by_lanes.no_zero);
      }
      ++t.boxes;
      t.free += none;
      t.signs += sign != 0;
      t.unbounded += !std::isfinite(value.lower() + value.upper());
      if (!apart.empty() && ++t.differences == 1)
        t.first = apart + ", on " + spelled({b.lo[0], b.hi[0]}) + " " +
                  spelled({b.lo[1], b.hi[1]}) + " " + spelled({b.lo[2], b.hi[2]});
    }
  }
}

void of_scenes(batch::path p) {
  const evaluations& of_path = GRAZE_ALL_PATHS(evaluations, evaluations_of).on(p);
  const auto check = [&](const char* name, const auto& f, const auto& evaluate) {
    tally t;
    compare(f, evaluate, 26, 4000, t);
    INFO(name << ": " << t.first);
    CHECK(t.differences == 0);
    CHECK(t.free > 2000);
    CHECK(t.signs > 2000);
  };
  for_each_built_in([&]<class F>(const built_in_surface<F>& row) {
    check(row.name, row.surface(), std::get<evaluator<F>>(of_path.built_in));
  });
  check("loose", loose{}, of_path.loose);
  check("creased", creased{}, of_path.creased);
}

void of_texts(batch::path p, const std::vector<std::string>& texts, int rounds) {
  const auto evaluate = GRAZE_ALL_PATHS(evaluations, evaluations_of).on(p).formula;
  tally all;
  std::uint64_t seed = 0;
  for (const std::string& text : texts) {
    const formula f = parsed(text);
    tally t;
    compare(f.surface(), evaluate, ++seed, rounds, t);
    INFO(text << ": " << t.first);
    CHECK(t.differences == 0);
    all.boxes += t.boxes;
    all.free += t.free;
    all.signs += t.signs;
    all.unbounded += t.unbounded;
  }
  CHECK(all.free > all.boxes / 10);
  CHECK(all.signs > all.boxes / 10);
  CHECK(all.unbounded > all.boxes / 100);
}
void of_operations(batch::path p) { of_texts(p, operation_texts(), 150); }
void of_random_formulas(batch::path p) { of_texts(p, random_texts(20, 200), 80); }

} // namespace

GRAZE_TEST_EACH_PATH("octree.twins", "enclosures of the scenes are the scalar ones", "[property]",
                     of_scenes)
GRAZE_TEST_EACH_PATH("octree.twins", "enclosures of every operation of a tape are the scalar ones",
                     "[property]", of_operations)
GRAZE_TEST_EACH_PATH("octree.twins", "enclosures of random formulas are the scalar ones",
                     "[property]", of_random_formulas)
