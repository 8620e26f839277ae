#include <catch2/catch.hpp>
#include <generate/generators.hpp>
#include <traversal/block_tree.hpp>

using namespace graze::fuzz;

namespace {
const double nan_value = std::nan("");
constexpr cube unit{{0, 0, 0}, 1};
} // namespace

TEST_CASE("fuzz.trial: an octant is found again by its corner at every level", "[unit]") {
  random_stream random(5, 0);
  for (const cube& root : {unit, cube{{-1, -1, -1}, 2}, cube{{-2.5, -2.5, -2.5}, 5}})
    for (int level = 0; level <= 50; ++level)
      for (int i = 0; i < 50; ++i) {
        trial t;
        t.root = root;
        t.level = level;
        for (auto& b : t.base)
          b = random.bits(level);
        const auto again = trial_of_octant(t.origin, t.direction, t.octant(0), root);
        REQUIRE(again);
        REQUIRE(*again == t);
      }
}

TEST_CASE("fuzz.trial: what is not an octant of the root is refused with a reason", "[unit]") {
  const vec3 o{0, 0, 0}, d{1, 0, 0};
  const auto why = [&](const cube& octant) { return trial_of_octant(o, d, octant, unit).reason(); };
  CHECK(why({{0, 0, 0}, 0.5}) == "");
  CHECK(why({{0, 0, 0}, 0.3}) == "octant size is not the root's size halved 0 to 53 times");
  CHECK(why({{0, 0, 0}, 2}) == "octant size is not the root's size halved 0 to 53 times");
  CHECK(why({{0, 0, 0}, 0x1p-54}) == "octant size is not the root's size halved 0 to 53 times");
  CHECK(why({{0.25, 0, 0}, 0.5}) == "octant corner is not on the root's grid");
  CHECK(why({{1, 0, 0}, 0.5}) == "octant lies outside the root");
  CHECK(why({{-0.5, 0, 0}, 0.5}) == "octant lies outside the root");
  CHECK(why({{nan_value, 0, 0}, 0.5}) == "octant corner is not finite");
  CHECK(why({{0, 0, 0}, nan_value}) == "octant size is not positive and finite");
  CHECK(trial_of_octant({nan_value, 0, 0}, d, unit, unit).reason() == "ray origin is not finite");
  CHECK(trial_of_octant(o, {0, 0, 0}, unit, unit).reason() == "ray direction is zero");
  CHECK(trial_of_octant(o, d, {{0.5, 0, 0}, 0.5}, unit, {2, 1, 1}).reason() ==
        "octants lie outside the root");
  CHECK(trial_of_octant(o, d, unit, {{0, 0, 0}, -1}).reason() ==
        "root size is not positive and finite");
}

TEST_CASE("fuzz.block_tree: its leaves are the block's octants, each once", "[unit]") {
  random_stream random(6, 0);
  for (int round = 0; round < 500; ++round) {
    trial t;
    t.level = random.between(1, 6);
    const std::uint64_t count = std::uint64_t{1} << t.level;
    for (unsigned a = 0; a < 3; ++a) {
      t.extent[a] = static_cast<std::uint8_t>(
          1 + random.below(static_cast<unsigned>(std::min<std::uint64_t>(4, count))));
      t.base[a] = random.below(static_cast<unsigned>(count - t.extent[a] + 1));
    }
    const block_tree tree(t);
    octant_set leaves = 0;
    int visits = 0;
    const auto go = [&](const auto& self, const block_tree::node& n, const cube& cell) -> void {
      if (n.level == t.level) {
        const octant_number v = tree.octant_of(n);
        REQUIRE(t.octant(v) == cell);
        leaves |= octant_set{1} << v;
        ++visits;
        return;
      }
      const unsigned mask = tree.child_mask(n, cell, 0xff);
      REQUIRE(mask != 0);
      for (unsigned i = 0; i < 8; ++i)
        if ((mask >> i & 1) != 0)
          self(self, tree.child(n, i), cell.child(i));
    };
    go(go, tree.root(), t.root);
    REQUIRE(leaves == t.all());
    REQUIRE(visits == std::popcount(t.all()));
  }
}
