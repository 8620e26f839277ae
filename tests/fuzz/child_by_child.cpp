/// What makes campaigns fast says what the slow way says.
#include <catch2/catch.hpp>
#include <generate/generators.hpp>
#include <graze/octree/exact.hpp>
#include <graze/octree/sound.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/upward.hpp>
#include <judge/judge.hpp>
#include <peers/paper2005/published.hpp>
#include <traversal/method_traversal.hpp>

using namespace graze::fuzz;
using namespace graze::octree;
using namespace graze::peers;

namespace {

/// M without first_child and enter_child: all eight children by split.
template <class M> class by_split {
public:
  using state = typename M::state;
  using scope = typename M::scope;
  explicit by_split(const ray& r) : method_(r) {}
  [[nodiscard]] bool enter(const cube& root, state& at) const { return method_.enter(root, at); }
  void split(const cube& cell, const state& at, branches<state>& out) const {
    method_.split(cell, at, out);
  }

private:
  M method_;
};

/// calls check(trial) for trials of every generator and level.
template <class Check> void for_trials(std::uint64_t each, const Check& check) {
  for (const generator& g : generators())
    for (int level = 1; level <= 53; ++level)
      for (std::uint64_t i = 0; i < each; ++i)
        check(make_trial(g, 2026, i, level), g, i);
}

std::vector<octant_number> answer(traversal& under_test, const trial& t) {
  visited visits;
  under_test.visit(t, visits);
  std::vector<octant_number> order;
  for (unsigned i = 0; i < visits.size(); ++i)
    order.push_back(visits[i]);
  return order;
}

} // namespace

TEMPLATE_TEST_CASE("octree.descent: child by child visits what split visits, in the same order",
                   "[property][hardcase]", (sound<graze::rounding::upward, convention::owned>),
                   (sound<graze::rounding::upward, convention::closed>),
                   (sound<graze::rounding::nearest, convention::owned>),
                   (sound<graze::rounding::split, convention::closed>),
                   (exact<graze::rounding::upward, convention::owned>),
                   (exact<graze::rounding::upward, convention::closed>),
                   (exact<graze::rounding::nearest, convention::closed>), published) {
  static_assert(goes_child_by_child<TestType, block_tree>);
  static_assert(!goes_child_by_child<by_split<TestType>, block_tree>);
  method_traversal<TestType> fast("fast", promise::touched);
  method_traversal<by_split<TestType>> slow("slow", promise::touched);
  std::uint64_t visits = 0;
  for_trials(40, [&](const trial& t, const generator& g, std::uint64_t i) {
    const std::vector<octant_number> order = answer(fast, t);
    visits += order.size();
    if (order != answer(slow, t)) {
      CAPTURE(g.name, t.level, i);
      REQUIRE(order == answer(slow, t));
    }
  });
  CHECK(visits > 50'000);
}

TEMPLATE_TEST_CASE("octree.ray_bounds: both bounds at a plane are those of enter_at and leave_at",
                   "[property][hardcase]", graze::rounding::upward, graze::rounding::nearest) {
  using bounds = ray_bounds<TestType>;
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  std::uint64_t at_origin = 0, wrong = 0;
  for_trials(10, [&](const trial& t, const generator&, std::uint64_t) {
    const typename TestType::scope scope;
    const auto axes = bounds::prepare(t.origin, t.direction);
    for (unsigned a = 0; a < 3; ++a)
      for (const double p : {t.plane(static_cast<int>(a), 0), t.plane(static_cast<int>(a), 1),
                             t.origin[a], -t.origin[a]}) {
        const auto check = [&](const auto& both, double enter, double leave) {
          wrong += same(both.enter, enter) && same(both.leave, leave) ? 0 : 1;
        };
        check(bounds::template at_plane<convention::closed>(axes[a], p),
              bounds::enter_at(axes[a], p),
              bounds::template leave_at<convention::closed>(axes[a], p));
        check(bounds::template at_plane<convention::owned>(axes[a], p),
              bounds::enter_at(axes[a], p),
              bounds::template leave_at<convention::owned>(axes[a], p));
        at_origin += p == t.origin[a] && std::isinf(axes[a].c_up) ? 1 : 0;
      }
  });
  CHECK(wrong == 0);
  CHECK(at_origin > 100); // 0 times infinity, if the comparisons were not strict
}

TEST_CASE("fuzz.properties: the truth is that of rationals, for every generator and level",
          "[property][hardcase]") {
  std::uint64_t trials = 0, touched = 0, crossed = 0, owned = 0;
  for_trials(100, [&](const trial& t, const generator& g, std::uint64_t i) {
    ++trials;
    const truth exact = truth_of(t);
    // one octant of the block
    const auto v = octant_at(static_cast<unsigned>(i % t.extent[0]),
                             static_cast<unsigned>(i / 2 % t.extent[1]),
                             static_cast<unsigned>(i / 4 % t.extent[2]));
    const cube box = t.octant(v);
    const vec3 hi{box.hi(0), box.hi(1), box.hi(2)};
    unsigned far = t.at_far_face();
    for (unsigned a = 0; a < 3; ++a)
      if ((v >> (2 * a) & 3u) + 1 != t.extent[a])
        far &= ~(1u << a);
    const bool touches = graze::oracle::rational::touches(t.origin, t.direction, box.lo, hi);
    const bool crosses = graze::oracle::rational::crosses(t.origin, t.direction, box.lo, hi);
    const bool owns = graze::oracle::rational::owns(t.origin, t.direction, box.lo, hi, far);
    touched += touches ? 1 : 0;
    crossed += crosses ? 1 : 0;
    owned += owns ? 1 : 0;
    if (((exact.touched >> v & 1) != 0) != touches || ((exact.crossed >> v & 1) != 0) != crosses ||
        ((exact.owned >> v & 1) != 0) != owns) {
      CAPTURE(g.name, t.level, i, static_cast<int>(v), touches, crosses, owns);
      REQUIRE(((exact.touched >> v & 1) != 0) == touches);
      REQUIRE(((exact.crossed >> v & 1) != 0) == crosses);
      REQUIRE(((exact.owned >> v & 1) != 0) == owns);
    }
  });
  CHECK(trials >= 100'000);
  CHECK(touched > 20'000);
  CHECK(crossed > 5'000);
  CHECK(owned > 5'000);
}
