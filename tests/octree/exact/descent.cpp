// The exact descent reports what it promises and nothing else.
#include <campaign/campaign.hpp>
#include <catch2/catch.hpp>
#include <graze/octree/exact.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <report/report.hpp>
#include <traversal/method_traversal.hpp>

using namespace graze;
using namespace graze::octree;

namespace {

constexpr auto exactly_touched = fuzz::promise::exactly_touched;
constexpr auto exactly_owned = fuzz::promise::exactly_owned;

/// Judges a traversal on every generator's rays in a root.
fuzz::counts judge(fuzz::traversal& t, const cube& root, int level, std::uint64_t rays_each) {
  fuzz::counts sum;
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t k = 0; k < rays_each; ++k) {
      const fuzz::trial at = fuzz::make_trial(g, 43, k, level, root);
      REQUIRE(fuzz::judgeable(at));
      sum.add(fuzz::judge(at, t));
    }
  return sum;
}

constexpr std::array<cube, 5> roots{{{{0, 0, 0}, 1},
                                     {{-1, -1, -1}, 2},
                                     {{-2.5, -2.5, -2.5}, 5},
                                     {{0, 0, 0}, 0x1p-500},
                                     {{-0x1p500, -0x1p500, -0x1p500}, 0x1p501}}};

template <class B> void judge_backend() {
  fuzz::method_traversal<exact<B, convention::closed>> closed("closed", exactly_touched);
  fuzz::method_traversal<exact<B, convention::owned>> owned("owned", exactly_owned);
  for (const cube& root : roots)
    for (const int level : {1, 20, 50}) {
      INFO("root size " << root.size << " level " << level);
      const fuzz::counts c = judge(closed, root, level, 300), o = judge(owned, root, level, 300);
      CHECK(c.visited > 1000);
      CHECK(c.visited == c.touched);
      CHECK(c.findings == 0);
      CHECK(o.visited > 1000);
      CHECK(o.findings == 0);
    }
}

/// A predicate that takes equal arrivals for a miss.
template <convention C> class without_ties : public exact<rounding::upward, C> {
  using base = exact<rounding::upward, C>;

public:
  using base::base;
  using typename base::scope;
  using typename base::state;
  bool enter(const cube& root, state& at) const { return base::enter(root, at); }
  void split(const cube& cell, const state& at, branches<state>& out) const {
    branches<state> all;
    base::split(cell, at, all);
    for (unsigned i = 0; i < all.size(); ++i)
      if (strictly(all[i].state))
        out.push(all[i].index, all[i].state);
  }
  bool enter_child(const cube& cell, unsigned index, state& at) const {
    return base::enter_child(cell, index, at) && strictly(at);
  }

private:
  static bool strictly(const state& at) {
    double enter = 0, leave = HUGE_VAL;
    for (const auto& axis : at.possible) {
      enter = std::max(enter, axis.enter);
      leave = std::min(leave, axis.leave);
    }
    return enter < leave;
  }
};

} // namespace

TEST_CASE("octree.exact: no octant too few, none too many (upward)", "[mpfr][hardcase]") {
  judge_backend<rounding::upward>();
}
TEST_CASE("octree.exact: no octant too few, none too many (nearest)", "[mpfr][hardcase]") {
  judge_backend<rounding::nearest>();
}
TEST_CASE("octree.exact: no octant too few, none too many (split)", "[mpfr][hardcase]") {
  judge_backend<rounding::split>();
}
TEST_CASE("octree.exact: no octant too few, none too many (switching)", "[mpfr][hardcase]") {
  judge_backend<rounding::switching>();
}

TEST_CASE("octree.exact: sound reports octants that exact leaves out", "[unit]") {
  fuzz::method_traversal<sound<rounding::upward, convention::closed>> closed("", exactly_touched);
  fuzz::method_traversal<sound<rounding::upward, convention::owned>> owned("", exactly_owned);
  for (fuzz::traversal* t :
       {static_cast<fuzz::traversal*>(&closed), static_cast<fuzz::traversal*>(&owned)}) {
    const fuzz::counts c = judge(*t, roots[0], 50, 300);
    CHECK(c.spurious > 1000);
    CHECK(c.misses == 0);
  }
}

TEST_CASE("octree.exact: the judge finds a descent that loses equal arrivals", "[unit]") {
  fuzz::method_traversal<without_ties<convention::closed>> broken("", exactly_touched);
  CHECK(judge(broken, roots[0], 10, 300).misses > 1000);
}

TEST_CASE("octree.exact: a child that passes implies that its parent does", "[property]") {
  // asked of every octant on the way to a block's corner, not only of those that a descent reaches
  const auto monotone = [](const auto& verdict_of) {
    std::uint64_t broken = 0, passed = 0;
    for (const fuzz::generator& g : fuzz::generators())
      for (std::uint64_t k = 0; k < 300; ++k) {
        const fuzz::trial t = fuzz::make_trial(g, 44, k, 50);
        const exact_touch touch(*ray::make(t.origin, t.direction));
        cube cell = t.root;
        unsigned far = 7;
        bool parent = verdict_of(touch, cell, far);
        for (int level = 1; level <= t.level; ++level) {
          unsigned index = 0;
          for (unsigned a = 0; a < 3; ++a)
            index |= static_cast<unsigned>(t.base[a] >> (t.level - level) & 1) << a;
          cell = cell.child(index);
          far &= index;
          const bool child = verdict_of(touch, cell, far);
          broken += child && !parent;
          passed += child;
          parent = child;
        }
      }
    CHECK(broken == 0);
    CHECK(passed > 10'000);
  };
  monotone([](const exact_touch& t, const cube& c, unsigned) { return t.touches(c); });
  monotone([](const exact_touch& t, const cube& c, unsigned far) { return t.owns(c, far); });
}
