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

namespace {
trial in_grid(const grid_planes& g) {
  trial t;
  t.grid = std::make_shared<const grid_planes>(g);
  return t;
}
std::string why(const trial& t) { return judgeable(t).reason(); }
std::string why(const grid_planes& g) { return why(in_grid(g)); }
} // namespace

TEST_CASE("fuzz.trial: planes that are not finite or not increasing are refused with a way out",
          "[unit]") {
  using enum plane_rule;
  CHECK(why(grid_planes{{-10, 0, 1e6}, {0.1, 25.2165, 1e-7}, {200, 1 << 20, 7}, rounded, {}}) ==
        "");
  CHECK(why(grid_planes{{0, 0, 0}, {0.1, 0, 0.1}, {5, 1, 5}, added, {}}) == ""); // flat on y
  for (const plane_rule rule : {rounded, multiplied, added}) {
    // steps of 1/4 beyond 2^51 are lost: plane 5 is plane 4
    const std::string reason = why(grid_planes{{0x1p53, 0, 0}, {1, 1, 1}, {3, 3, 3}, rule, {}});
    INFO(reason);
    CHECK(reason.starts_with("planes "));
    CHECK(reason.find("of axis x are both 0x1p+53") != std::string::npos);
    CHECK(reason.find("\"planes\": \"exact\"") != std::string::npos);
  }
  CHECK(why(grid_planes{{0x1p53, 0, 0}, {1, 1, 1}, {3, 3, 3}, exact, {}}) == "");
  CHECK(why(grid_planes{{0, 16777216, 0}, {1, 1, 1}, {3, 3, 3}, binary32, {}})
            .starts_with("planes 0 and 1 of axis y are both 0x1p+24: take a larger spacing"));
  CHECK(why(grid_planes{{0, 0, 0}, {1, 1, 1e308}, {3, 3, 2}, rounded, {}}) ==
        "plane 2 of axis z is not finite: take a larger spacing, an origin nearer to 0, or the "
        "planes as "
        "real numbers: \"planes\": \"exact\"");
  CHECK(why(grid_planes{{0, 0, 0}, {1, -1, 1}, {3, 3, 2}, rounded, {}}) ==
        "spacing of axis y is -1: take a positive one, and the lowest plane as the origin");
  CHECK(why(grid_planes{{0, 0, 0}, {1, 0, 1}, {3, 3, 2}, rounded, {}}) ==
        "spacing of axis y is 0: a flat axis has count 1, not 3");
  CHECK(why(grid_planes{{0, 0, 0}, {1, 1, 1}, {3, 0, 2}, rounded, {}}) ==
        "count of axis y is 0, outside 1..1048576: take the part of the grid that matters");
  CHECK(why(grid_planes{{0, nan_value, 0}, {1, 1, 1}, {3, 1, 2}, rounded, {}}) ==
        "origin and spacing of axis y are not finite");
  CHECK(why(grid_of({{{0, 1}, {0, 0.5, 2, 3}, {-1}}})) == "");
  CHECK(why(grid_of({{{0, 1}, {0, 0.5, 0.5, 3}, {-1}}})) ==
        "planes 1 and 2 of axis y are both 0x1p-1: give each plane once, in increasing order");
  CHECK(
      why(grid_of({{{0, 1}, {0, 1}, {1, 0}}})) ==
      "plane 1 of axis z, 0x0p+0, lies below plane 0, 0x1p+0: give each plane once, in increasing "
      "order");
  CHECK(why(grid_of({{{0, 1}, {}, {1, 0}}})) == "axis y has 0 planes: 1 to 1048577 are judged");
  CHECK(why(grid_of({{{0, HUGE_VAL}, {0}, {0}}})) ==
        "plane 1 of axis x is not finite: give each plane once, in increasing order");
  trial outside = in_grid({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, rounded, {}});
  outside.base = {0, 3, 0};
  CHECK(why(outside) == "voxels lie outside the grid, which has 3 on axis y");
}

TEST_CASE("fuzz.trial: planes that are not looked at one by one are increasing", "[property]") {
  random_stream random(7, 0);
  for (unsigned i = 0; i < 300; ++i) {
    grid_planes g;
    g.rule = static_cast<plane_rule>(random.below(5));
    for (unsigned a = 0; a < 3; ++a) {
      g.origin[a] = std::ldexp(static_cast<double>(random.bits(53)), -random.between(0, 90));
      g.spacing[a] = std::ldexp(static_cast<double>(random.bits(53) + 1), -random.between(40, 90));
      g.origin[a] *= random.sign();
      g.count[a] = 1 + random.below(2000);
    }
    const bool well = judgeable(g).has_value();
    bool increasing = true;
    for (unsigned a = 0; a < 3; ++a)
      for (std::uint32_t k = 1; k <= g.count[a]; ++k)
        increasing = increasing && (g.rule == plane_rule::exact ||
                                    nearest_plane(g, a, k - 1) < nearest_plane(g, a, k));
    REQUIRE(well == increasing);
  }
}

TEST_CASE("fuzz.trial: segments and boxes that are none are refused", "[unit]") {
  const trial t;
  CHECK(why(with_end(t, {0, 0, 0}, {1, 0, 0})) == "");
  CHECK(why(with_end(t, {1, 2, 3}, {1, 2, 3})) ==
        "segment's end is its origin: take two points, or ask about a ray");
  CHECK(why(with_end(t, {0, 0, 0}, {1, nan_value, 0})) == "segment end is not finite");
  CHECK(why(with_end(t, {HUGE_VAL, 0, 0}, {1, 0, 0})) == "segment origin is not finite");
  CHECK(why(with_end(t, {-1e308, 0, 0}, {1e308, 0, 0})) ==
        "segment is longer than any double: take one within 2^1023");
  CHECK(with_end(t, {0.1, 0, 0}, {0.3, 0, 0}).direction[0] == 0.3 - 0.1);
  const auto of_boxes = [](std::vector<graze::octree::box> list) {
    trial b;
    b.boxes = std::make_shared<const std::vector<graze::octree::box>>(std::move(list));
    return b;
  };
  CHECK(why(of_boxes({{{-1, -1, 1}, {1, 1, 1}}})) == ""); // a flat one
  CHECK(why(of_boxes({})) == "0 boxes: lists of 1 to 64 are judged");
  CHECK(why(of_boxes(std::vector<graze::octree::box>(65))) ==
        "65 boxes: lists of 1 to 64 are judged");
  CHECK(why(of_boxes({{{0, 0, 0}, {1, 1, 1}}, {{0, 2, 0}, {1, 1, 1}}})) ==
        "box 1 has lo 0x1p+1 above hi 0x1p+0 on axis y: exchange them");
  CHECK(why(of_boxes({{{0, 0, 0}, {1, 1, HUGE_VAL}}})) ==
        "box 0 is not finite on axis z: take large numbers for a box without end");
  CHECK(of_boxes(std::vector<graze::octree::box>(64)).all() == ~octant_set{0});
  CHECK(of_boxes(std::vector<graze::octree::box>(3)).all() == 7);
}
