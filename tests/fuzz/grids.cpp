/// Grids, boxes and segments judged: answers that are known by hand.
#include <catch2/catch.hpp>
#include <judge/first.hpp>
#include <judge/judge.hpp>
#include <judge/replay.hpp>
#include <traversal/list.hpp>

using namespace graze::fuzz;

namespace {

using graze::octree::box;

trial in_grid(const grid_planes& g, std::array<std::uint64_t, 3> base,
              std::array<std::uint8_t, 3> extent, const vec3& o, const vec3& d) {
  trial t = with_ray({}, o, d);
  t.grid = std::make_shared<const grid_planes>(g);
  t.base = base;
  t.extent = extent;
  REQUIRE(judgeable(t));
  return t;
}

trial of_boxes(std::vector<box> list, const vec3& o, const vec3& d) {
  trial t = with_ray({}, o, d);
  t.boxes = std::make_shared<const std::vector<box>>(std::move(list));
  REQUIRE(judgeable(t));
  return t;
}

visited seen(std::initializer_list<octant_number> cells) {
  visited v;
  v.clear();
  for (const octant_number c : cells)
    v.push(c);
  return v;
}

finding_set found(const trial& t, const visited& answer, promise p) {
  return judge(t, truth_of(t), answer, p).findings;
}

constexpr octant_number at(unsigned x, unsigned y, unsigned z) { return octant_at(x, y, z); }
constexpr octant_set set_of(std::initializer_list<octant_number> cells) {
  octant_set s = 0;
  for (const octant_number c : cells)
    s |= octant_set{1} << c;
  return s;
}

} // namespace

TEST_CASE("fuzz.grids: planes at tenths, each rule with its own third one", "[unit]") {
  // 0.3 in double lies below the rounded plane 3 of spacing 0.1, 0.30000000000000004; above it is the
  // real number 3 * 0.1 of the double 0.1, which is larger than 0.3 and lies between the two
  const double below = 0.3, above = 0.30000000000000004;
  for (const auto& [rule, o, owner] :
       {std::tuple{plane_rule::exact, below, 2u}, std::tuple{plane_rule::exact, above, 3u},
        std::tuple{plane_rule::rounded, below, 2u}, std::tuple{plane_rule::rounded, above, 3u},
        std::tuple{plane_rule::binary32, below, 2u}, std::tuple{plane_rule::binary32, above, 2u}}) {
    const trial t = in_grid({{0, 0, 0}, {0.1, 1, 1}, {10, 4, 4}, rule, {}}, {1, 0, 0}, {4, 1, 1},
                            {o, 0.5, -1}, {0, 0, 1});
    const truth exact = truth_of(t);
    INFO(name_of(rule) << " " << o);
    CHECK(exact.owned == set_of({at(owner - 1, 0, 0)}));
    const bool on_plane = rule == plane_rule::rounded && o == above;
    CHECK(exact.crossed == (on_plane ? 0 : exact.owned));
    CHECK(exact.touched == (on_plane ? set_of({at(1, 0, 0), at(2, 0, 0)}) : exact.owned));
  }
}

TEST_CASE("fuzz.grids: the far faces belong to the last voxels, a flat axis to its voxel",
          "[unit]") {
  const grid_planes g{{0, 0, 5}, {0.1, 0.25, 0}, {10, 8, 1}, plane_rule::added, {}};
  // plane 10 of repeated addition is 0.9999999999999999
  trial t = in_grid(g, {9, 7, 0}, {1, 1, 1}, {0.9999999999999999, 2, 4}, {0, 0, 1});
  truth exact = truth_of(t);
  CHECK(exact.touched == 1);
  CHECK(exact.owned == 1);
  CHECK(exact.crossed == 0); // through the corner of a flat voxel
  t.origin[0] = 1;
  CHECK(truth_of(t).touched == 0);
  t.origin = {0.95, 1.9, 4}; // through its interior, which is in its plane
  exact = truth_of(t);
  CHECK(exact.crossed == 1);
  CHECK(exact.length_count == 0);
  CHECK(found(t, seen({}), promise::owned) == bit(finding::crossed_miss));
  t.direction = {0, 0, -1};
  CHECK(truth_of(t).touched == 0);
  // within the plane
  t = in_grid(g, {8, 7, 0}, {2, 1, 1}, {0, 1.9, 5}, {1, 0, 0});
  exact = truth_of(t);
  CHECK(exact.crossed == set_of({at(0, 0, 0), at(1, 0, 0)}));
  CHECK(exact.owners == 2);
  CHECK(exact.length_count == 2);
  CHECK(found(t, seen({at(1, 0, 0), at(0, 0, 0)}), promise::owned) == bit(finding::order));
  CHECK((found(t, seen({at(0, 0, 0)}), promise::owned) & bit(finding::gross_miss)) != 0);
}

TEST_CASE("fuzz.grids: segments end where they end", "[unit]") {
  trial t;
  t.level = 1;
  t.extent = {2, 2, 2};
  const auto between = [&](const vec3& o, const vec3& e) { return truth_of(with_end(t, o, e)); };
  const octant_number first = at(0, 0, 0), second = at(1, 0, 0);
  CHECK(between({0.1, 0.1, 0.1}, {0.5, 0.1, 0.1}).touched == set_of({first, second}));
  CHECK(between({0.1, 0.1, 0.1}, {0.5, 0.1, 0.1}).crossed == set_of({first}));
  CHECK(between({0.1, 0.1, 0.1}, {0.5, 0.1, 0.1}).owned == set_of({first, second}));
  CHECK(between({0.1, 0.1, 0.1}, {step_ulps(0.5, -1), 0.1, 0.1}).touched == set_of({first}));
  CHECK(between({0.1, 0.1, 0.1}, {step_ulps(0.5, 1), 0.1, 0.1}).crossed == set_of({first, second}));
  CHECK(between({0.6, 0.1, 0.1}, {0.5, 0.1, 0.1}).crossed == set_of({second}));
  // to the corner of the root, and past it by an ulp: from a place whose difference to it is rounded
  const vec3 o{-0.1, -0.3, -0.7};
  CHECK(between(o, {0, 0, 0}).touched == set_of({first}));
  CHECK(between(o, {0, 0, 0}).crossed == 0);
  CHECK(between(o, {0, 0, -0x1p-1074}).touched == 0);
}

TEST_CASE("fuzz.grids: boxes of a list, flat ones too", "[unit]") {
  const trial t = of_boxes({{{-1, -1, 1}, {1, 1, 1}},
                            {{-1, -1, 2}, {0, 1, 5}},
                            {{0, 0, 3}, {0, 0, 3}},
                            {{1, 1, 1}, {2, 2, 2}}},
                           {0, 0, 0}, {0, 0, 1});
  const truth exact = truth_of(t);
  CHECK(exact.touched == 0b0111);
  CHECK(exact.crossed == 0b0101); // the second one runs in a face
  CHECK(exact.soonest == 0b0001);
  CHECK(exact.first_crossed == 0);
  CHECK(exact.not_after == 0b0001);
  CHECK(found(t, seen({0, 2}), promise::crossed) == 0);
  CHECK(found(t, seen({2}), promise::crossed) ==
        bit(finding::crossed_miss)); // a flat one: not gross
  CHECK(found(t, seen({0, 1, 2}), promise::exactly_touched) == 0);
  CHECK(found(t, seen({0, 1, 2, 3}), promise::touched) == bit(finding::far_spurious));
  CHECK(judge(t, exact, seen({0}), promise::owned).declined);
  CHECK(judgeable(promise::owned, cell_kind::boxes)
            .reason()
            .starts_with("promise owned says nothing"));
  CHECK(judgeable(promise::first, cell_kind::boxes));
}

TEST_CASE("fuzz.first: the first cell that is crossed, or one that is touched no later", "[unit]") {
  const trial t = of_boxes({{{4, -1, -1}, {6, 1, 1}},    // crossed second
                            {{1, -1, -1}, {2, 1, 1}},    // crossed first
                            {{0.5, 0, -1}, {3, 0.5, 1}}, // only touched, and before
                            {{1.5, 0, -1}, {3, 0.5, 1}}, // only touched, and after
                            {{1, 2, -1}, {3, 5, 1}}},    // not at all
                           {0, 0, 0}, {2, 0, 0});
  const auto first = [&](std::initializer_list<octant_number> c) {
    return found(t, seen(c), promise::first);
  };
  const auto first_touched = [&](std::initializer_list<octant_number> c) {
    return found(t, seen(c), promise::first_touched);
  };
  const finding_set gross = bit(finding::crossed_miss) | bit(finding::gross_miss);
  CHECK(first({1}) == 0);
  CHECK(first({2}) == 0);
  CHECK(first({3}) == gross);
  CHECK(first({0}) == gross);
  CHECK(first({}) == gross);
  CHECK(first({4}) == bit(finding::far_spurious));
  CHECK(first({1, 2}) == bit(finding::malformed));
  CHECK(first_touched({2}) == 0);
  CHECK(first_touched({1}) == bit(finding::miss));
  CHECK(first_touched({}) == gross);
  CHECK(first_touched({3}) == gross);
  // where nothing is crossed
  const trial beside =
      of_boxes({{{1, 0, -1}, {2, 1, 1}}, {{3, 0, -1}, {4, 1, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(found(beside, seen({}), promise::first) == 0);
  CHECK(found(beside, seen({1}), promise::first) == 0);
  CHECK(found(beside, seen({}), promise::first_touched) == bit(finding::miss));
  CHECK(found(beside, seen({1}), promise::first_touched) == bit(finding::miss));
  CHECK(found(beside, seen({0}), promise::first_touched) == 0);
  // by less than rounding, nothing is touched: no miss, but one too many for who promises touched cells
  const trial past = of_boxes({{{1, 0x1p-60, -1}, {2, 1, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(found(past, seen({0}), promise::first) == 0);
  CHECK(judge(past, truth_of(past), seen({0}), promise::first).spurious == 1);
  CHECK(found(past, seen({0}), promise::first_touched) == bit(finding::spurious));
  // one that rounding may explain, but which comes after the first crossed one has been left
  const trial behind =
      of_boxes({{{1, -1, -1}, {2, 1, 1}}, {{3, 0x1p-60, -1}, {4, 1, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(found(behind, seen({1}), promise::first) == gross);
}

TEST_CASE("fuzz.first: in a grid the first voxel is told from those behind it", "[unit]") {
  const grid_planes g{{-0.3, 0, 0}, {0.1, 0.1, 0.1}, {10, 10, 10}, plane_rule::multiplied, {}};
  const trial t = in_grid(g, {3, 3, 3}, {3, 3, 3}, {-1, 0.35, 0.35}, {1, 0, 0});
  CHECK(truth_of(t).soonest == set_of({at(0, 0, 0)}));
  CHECK(found(t, seen({at(0, 0, 0)}), promise::first) == 0);
  CHECK((found(t, seen({at(1, 0, 0)}), promise::first) & bit(finding::gross_miss)) != 0);
  // from within a voxel: that one
  trial within = t;
  within.origin[0] = 0.15;
  CHECK(found(within, seen({at(1, 0, 0)}), promise::first) == 0);
  CHECK((found(within, seen({at(2, 0, 0)}), promise::first) & bit(finding::gross_miss)) != 0);
  // along an edge of the planes 0.3 of y and z (which are 0.30000000000000004): four are touched at once
  trial edge = t;
  edge.origin = {-1, 0.30000000000000004, 0.30000000000000004};
  edge.base = {3, 2, 2};
  edge.extent = {2, 2, 2};
  const truth exact = truth_of(edge);
  CHECK(exact.soonest == set_of({at(0, 0, 0), at(0, 1, 0), at(0, 0, 1), at(0, 1, 1)}));
  CHECK(exact.crossed == 0);
  CHECK(found(edge, seen({at(0, 1, 0)}), promise::first_touched) == 0);
  CHECK(found(edge, seen({at(1, 1, 0)}), promise::first_touched) == bit(finding::miss));
}

TEST_CASE("fuzz.first: t, distance and face against the exact entry", "[unit]") {
  const trial t = of_boxes({{{1, -1, -1}, {2, 1, 1}}}, {0, 0, 0}, {2, 0.5, 0});
  const auto told = [&](auto say, promise p = promise::first) {
    visited answer = seen({0});
    say(answer.said());
    return found(t, answer, p);
  };
  const double length = std::sqrt(4.25) / 2;
  CHECK(told([](remarks& r) { r.t = 0.5; }) == 0);
  CHECK(told([](remarks& r) { r.t = step_ulps(0.5, 8); }) == 0);
  CHECK(told([](remarks& r) { r.t = step_ulps(0.5, 80); }) == bit(finding::distance));
  CHECK(told([](remarks& r) { r.t = HUGE_VAL; }) == bit(finding::distance));
  CHECK(told([&](remarks& r) { r.distance = length; }) == 0);
  CHECK(told([&](remarks& r) { r.distance = 0.5; }) == bit(finding::distance));
  CHECK(told([](remarks& r) { r.entered = face{0, false}; }) == 0);
  CHECK(told([](remarks& r) { r.entered = face{0, true}; }) == bit(finding::face));
  CHECK(told([](remarks& r) { r.entered = face{1, false}; }) == bit(finding::face));
  CHECK(told([](remarks& r) { r.no_face = true; }) == bit(finding::face));
  // into a corner: each of the three faces
  const trial corner = of_boxes({{{1, 1, 1}, {2, 2, 2}}}, {0, 0, 0}, {1, 1, 1});
  for (std::uint8_t a = 0; a < 3; ++a)
    for (const bool upper : {false, true}) {
      visited answer = seen({0});
      answer.said().entered = face{a, upper};
      CHECK(found(corner, answer, promise::first) == (upper ? bit(finding::face) : 0));
    }
  // from within: no face, t = 0
  const trial inside = of_boxes({{{-1, -1, -1}, {2, 2, 2}}}, {0, 0, 0}, {1, 1, 1});
  visited answer = seen({0});
  answer.said().no_face = true;
  answer.said().t = 0;
  CHECK(found(inside, answer, promise::first) == 0);
  answer.said().t = -1;
  CHECK(found(inside, answer, promise::first) == bit(finding::distance));
  // a segment's t is of its own length, its distance is not
  trial s = with_end(t, {0, 0, 0}, {4, 0, 0});
  answer = seen({0});
  answer.said().t = 0.25;
  answer.said().distance = 1;
  CHECK(found(s, answer, promise::first) == 0);
  answer.said().t = 1;
  CHECK(found(s, answer, promise::first) == bit(finding::distance));
}

TEST_CASE("fuzz.first: entries beyond the doubles at either end are not accused", "[unit]") {
  const auto told = [](const trial& t, double when, double distance) {
    visited answer = seen({0});
    answer.said().t = when;
    answer.said().distance = distance;
    return found(t, answer, promise::first);
  };
  // t = 2^-2074: 0 is as good as any
  CHECK(told(of_boxes({{{0x1p-1074, -1, -1}, {1, 1, 1}}}, {0, 0, 0}, {0x1p1000, 0, 0}), 0,
             0x1p-1074) == 0);
  // a distance of 2^-1074 at t = 1/3
  trial small = of_boxes({{{0, -1, -1}, {1, 1, 1}}}, {-0x1p-1074, 0, 0}, {1, 0, 0});
  small = with_end(small, {-0x1p-1074, 0, 0}, {0x1p-1073, 0, 0});
  CHECK(told(small, 1.0 / 3, 0x1p-1074) == 0);
  CHECK(told(small, 1.0 / 3, 0x1p-1060) == bit(finding::distance));
  // t = 2^1074
  const trial slow = of_boxes({{{1, -1, -1}, {2, 1, 1}}}, {0, 0, 0}, {0x1p-1074, 0, 0});
  CHECK(told(slow, HUGE_VAL, 1) == 0);
  CHECK(told(slow, -HUGE_VAL, 1) == bit(finding::distance));
}

TEST_CASE("fuzz.grids: gross is a chord of more than 1e-3 of the greatest edge", "[regression]") {
  const auto is_gross = [](const trial& t) { return gross(t, 1) != 0; };
  const box plate{{0, 0, 0}, {8, 1, 0x1p-54}};
  CHECK_FALSE(is_gross(of_boxes({plate}, {4, 0.5, 1}, {0, 0, -1})));
  CHECK_FALSE(is_gross(of_boxes({plate}, {7.993, 0, 0x1p-55}, {1, 0, 0})));
  CHECK(is_gross(of_boxes({plate}, {7.991, 0, 0x1p-55}, {1, 0, 0})));
  CHECK(is_gross(of_boxes({{{0, 0, 0}, {8, 1, 0}}}, {-1, 0.5, 0}, {1, 0, 0})));
  CHECK_FALSE(is_gross(of_boxes({{{1, 1, 1}, {1, 1, 1}}}, {0, 1, 1}, {1, 0, 0}))); // a point
  for (const plane_rule rule : {plane_rule::exact, plane_rule::rounded}) {
    const grid_planes thin{{0, 0, 0}, {1, 1, 1e-53}, {4, 4, 4}, rule, {}};
    CHECK_FALSE(is_gross(in_grid(thin, {1, 1, 1}, {1, 1, 1}, {1.5, 1.5, 1}, {0, 0, -1})));
    CHECK(is_gross(in_grid(thin, {1, 1, 1}, {1, 1, 1}, {0, 1.5, 1.5e-53}, {1, 0, 0})));
  }
}

TEST_CASE("fuzz.any: hit or not", "[unit]") {
  const auto said = [](const trial& t, bool hit) {
    visited answer;
    answer.clear();
    answer.said().hit = hit;
    return judge(t, truth_of(t), answer, promise::any);
  };
  const trial crossed = of_boxes({{{1, -1, -1}, {2, 1, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(said(crossed, true).findings == 0);
  CHECK(said(crossed, false).findings == (bit(finding::crossed_miss) | bit(finding::gross_miss)));
  const trial touched = of_boxes({{{1, 0, -1}, {2, 1, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(said(touched, true).findings == 0);
  CHECK(said(touched, false).findings == 0);
  const trial past = of_boxes({{{1, 2, -1}, {2, 3, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(said(past, false).findings == 0);
  CHECK(said(past, true).findings == bit(finding::far_spurious));
  const trial near = of_boxes({{{1, 0x1p-60, -1}, {2, 3, 1}}}, {0, 0, 0}, {1, 0, 0});
  CHECK(said(near, true).findings == 0);
  CHECK(said(near, true).spurious == 1);
}

TEST_CASE("fuzz.count: crossings of the surface of all boxes together", "[unit]") {
  const auto number = [](const trial& t) -> int {
    const auto known = crossings_of(t);
    if (!known)
      return -1;
    CHECK((!known->number || (*known->number % 2 != 0) == known->odd));
    return known->number ? static_cast<int>(*known->number) : (known->odd ? -3 : -2);
  };
  const box one{{1, -1, -1}, {2, 1, 1}}, next{{2, -1, -1}, {3, 1, 1}},
      over{{1.5, -2, -2}, {4, 2, 2}}, apart{{5, -1, -1}, {6, 1, 1}};
  const vec3 o{0, 0, 0}, d{1, 0.1, 0};
  CHECK(number(of_boxes({one}, o, d)) == 2);
  CHECK(number(of_boxes({one, next}, o, d)) == 2); // nothing is crossed between them
  CHECK(number(of_boxes({one, over}, o, d)) == 2);
  CHECK(number(of_boxes({one, over, apart}, o, d)) == 4);
  CHECK(number(of_boxes({one, apart}, {1.5, 0, 0}, d)) == 3);
  CHECK(number(of_boxes({one, apart}, {2, 0, 0}, d)) == -1);  // from the surface
  CHECK(number(of_boxes({one, over}, {2, 0, 0}, d)) == 1);    // from a face inside the other
  CHECK(number(of_boxes({one, apart}, o, {1, 1, 0})) == -2);  // along an edge's point: parity alone
  CHECK(number(of_boxes({one}, {0, 1, 0}, {1, 0, 0})) == -2); // in a face
  CHECK(number(of_boxes({one, apart}, {1.5, 0.5, 0}, {1, 1, 0})) == -3); // out at an edge
  CHECK(number(of_boxes({{{1, 1, 1}, {1, 2, 2}}}, o, d)) == -1);         // flat: without inside
  // out of the interior of one box's face into that of another's, on the edge in which they meet
  CHECK(number(of_boxes({{{-5, -6, -1}, {1, 5, 1}}, {{-5, 1, -1}, {5, 9, 1}}}, {0, 0, 0},
                        {1, 1, 0})) == -3);
  // out of one face into another box's other face over the edge in which they meet
  CHECK(number(of_boxes({{{-1, -1, -1}, {1, 1, 1}}, {{-3, 1, -1}, {3, 2, 1}}}, {0, 0, 0},
                        {1, 1, 0})) == -3);
  CHECK(number(with_end(of_boxes({one, apart}, o, d), o, {1.5, 0.15, 0})) == 1);
  CHECK(number(with_end(of_boxes({one, apart}, o, d), o, {4, 0.4, 0})) == 2);
  CHECK(number(with_end(of_boxes({one, apart}, o, d), o, {1, 0.1, 0})) == -1);
  const trial two = of_boxes({one, apart}, o, d);
  const auto said = [&](std::uint64_t n) {
    visited answer;
    answer.clear();
    answer.said().crossings = n;
    return judge(two, truth_of(two), answer, promise::count);
  };
  CHECK(said(4).findings == 0);
  CHECK(said(2).findings == bit(finding::count));
  CHECK(said(3).findings == bit(finding::count));
  // a block of voxels is one body
  const trial block = in_grid({{0, 0, 0}, {0.1, 0.1, 0.1}, {10, 10, 10}, plane_rule::exact, {}},
                              {2, 2, 2}, {4, 4, 4}, {-1, 0.3, 0.3}, {1, 0.01, 0.02});
  CHECK(number(block) == 2);
}

TEST_CASE("fuzz.replay: enclosures of entry and exit", "[unit]") {
  const auto t = from_json_line(
      R"({"origin":[0,0.5,0.5],"direction":[3,0,0],"box":{"lo":[1,0,0],"hi":[2,1,1]}})");
  REQUIRE(t);
  const auto r = replay(*t, *find_traversal("rational")->make());
  CHECK(r.oracles_agree);
  CHECK(r.passages[0][0].lo < r.passages[0][0].hi);
  CHECK(r.passages[0][0].lo == 0x1.5555555555555p-2);
  CHECK(r.passages[0][0].hi == 0x1.5555555555556p-2);
  const std::string line = to_json_line({1, *t}, r, "rational");
  CHECK(line.find("\"enter\":[0.3333333333333333,") != std::string::npos);
  const auto past = from_json_line(
      R"({"origin":[0,0.5,0.5],"direction":[-3,0,0],"box":{"lo":[1,0,0],"hi":[2,1,1]}})");
  CHECK(to_json_line({1, *past}, replay(*past, *find_traversal("rational")->make()), "rational")
            .find("\"enter\":null") != std::string::npos);
}
