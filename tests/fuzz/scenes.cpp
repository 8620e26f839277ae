/// What rays are led through: random grids and boxes, segments; and that a generator does on a grid what it
/// says.
#include "campaign_of.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <generate/climb.hpp>
#include <generate/margin.hpp>
#include <generate/scenes.hpp>
#include <generate/site.hpp>
#include <generate/tame.hpp>
#include <judge/exact_cells.hpp>
#include <judge/replay.hpp>
#include <map>
#include <set>
#include <traversal/list.hpp>
#include <trial/codec.hpp>

using namespace graze::fuzz;

namespace {

const scene_choice grids{cell_kind::grid, false, nullptr}, boxes{cell_kind::boxes, false, nullptr},
    cubes{};
scene_choice in_segments(scene_choice s) {
  s.segments = true;
  return s;
}

trial made(const char* name, std::uint64_t k, const scene_choice& scene, std::uint64_t seed = 3) {
  const generator* g = find_generator(name);
  REQUIRE(g != nullptr);
  return make_trial(*g, seed, k, 20, scene);
}

/// The largest number of axes on which one step of the ray is on a plane of the block's voxels.
int planes_met(const trial& t) {
  std::array<std::vector<graze::oracle::plane_terms>, 3> planes;
  for (unsigned a = 0; a < 3; ++a)
    for (unsigned k = 0; k <= (t.flat(a) ? 0u : t.extent[a]); ++k)
      planes[a].push_back(exact_plane(t, a, k));
  std::vector<graze::oracle::step> steps;
  graze::oracle::steps_in_grid(line_of(t), {planes[0], planes[1], planes[2]}, steps);
  int most = 0;
  for (const auto& s : steps)
    most = std::max(most, static_cast<int>(std::count_if(
                              s.at.begin(), s.at.end(), [](int place) { return place % 2 == 0; })));
  return most;
}

template <class Holds> double share(const char* name, const scene_choice& scene, Holds holds) {
  constexpr unsigned sample = 4000;
  unsigned holding = 0;
  for (unsigned k = 0; k < sample; ++k)
    holding += holds(made(name, k, scene)) ? 1 : 0;
  return holding / double(sample);
}

bool of_doubles(const trial& t) { return t.grid->rule != plane_rule::exact; }

} // namespace

TEST_CASE("fuzz.scenes: random grids are of every kind that people have", "[property]") {
  std::map<plane_rule, unsigned> rules;
  std::set<double> spacings;
  unsigned flat = 0, large = 0, odd = 0, unlike = 0;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    random_stream random(8, k);
    const grid_planes g = random_grid(random);
    REQUIRE(judgeable(g));
    ++rules[g.rule];
    if (g.rule == plane_rule::given)
      continue;
    for (unsigned a = 0; a < 3; ++a) {
      spacings.insert(g.spacing[a]);
      flat += g.flat(a) ? 1 : 0;
      large += g.count[a] > 100'000 ? 1 : 0;
      odd += (g.count[a] & (g.count[a] - 1)) != 0 ? 1 : 0;
    }
    unlike += g.spacing[0] != g.spacing[1] ? 1 : 0;
  }
  for (const plane_rule rule : {plane_rule::exact, plane_rule::rounded, plane_rule::multiplied,
                                plane_rule::added, plane_rule::binary32, plane_rule::given})
    CHECK(rules[rule] > 150);
  for (const double s : {0.1, 0.05, 1.0 / 3, 25.2165, 27.9808, 0.6051, 1e-7, 0.25})
    CHECK(spacings.count(s) == 1);
  CHECK(flat > 100);
  CHECK(large > 60);
  CHECK(odd > 4000);
  CHECK(unlike > 1000);
}

TEST_CASE("fuzz.scenes: every trial is legal, a seed's the same each time", "[property]") {
  for (const scene_choice& scene :
       {grids, boxes, in_segments(grids), in_segments(boxes), in_segments(cubes)})
    for (const generator& g : generators())
      for (std::uint64_t k = 0; k < 1500; ++k) {
        const trial t = make_trial(g, 4, k, 1 + static_cast<int>(k % 53), scene);
        INFO(g.name << " ray " << k << " " << judgeable(t).reason());
        REQUIRE(judgeable(t));
        REQUIRE(t.cells() == scene.cells);
        REQUIRE(t.end.has_value() == scene.segments);
        if (k % 50 == 0) {
          make_trial(g, 5, k + 1000, 3, scene); // something else in between
          REQUIRE(make_trial(g, 4, k, 1 + static_cast<int>(k % 53), scene) == t);
          const auto again = from_json_line(to_json_line(t));
          INFO(again.reason());
          REQUIRE(again);
          REQUIRE(*again == t);
        }
      }
}

TEST_CASE("fuzz.scenes: rays of octants are as they were", "[property]") {
  for (const generator& g : generators())
    for (std::uint64_t k = 0; k < 200; ++k)
      REQUIRE(make_trial(g, 9, k, 30, cubes) == make_trial(g, 9, k, 30));
}

TEST_CASE("fuzz.scenes: a grid that is given is that of all trials", "[unit]") {
  grid_planes g{{0, 0, 0}, {0.1, 0.1, 0.1}, {7, 9, 11}, plane_rule::rounded, {}};
  const scene_choice given{cell_kind::grid, false, std::make_shared<const grid_planes>(g)};
  for (std::uint64_t k = 0; k < 500; ++k)
    REQUIRE(*made("vertex", k, given).grid == g);
}

TEST_CASE("fuzz.scenes: generators do on grids what they say", "[property]") {
  const auto through = [](int axes) {
    return [axes](const trial& t) { return !of_doubles(t) || planes_met(t) >= axes; };
  };
  CHECK(share("vertex", grids, through(3)) > 0.99);
  CHECK(share("edge-0", grids, through(2)) > 0.99);
  CHECK(share("edge-1", grids, [](const trial& t) {
          return std::none_of(t.direction.begin(), t.direction.end(),
                              [](double d) { return d == 0; }) &&
                 of_doubles(t) && t.count(0) > 1 && planes_met(t) >= 3;
        }) < 0.3);
  // planes that are no doubles are met too, several at once
  CHECK(share("vertex", grids,
              [](const trial& t) { return !of_doubles(t) && planes_met(t) == 3; }) > 0.015);
  CHECK(share("vertex", grids, [](const trial& t) {
          if (of_doubles(t))
            return false;
          for (unsigned a = 0; a < 3; ++a)
            if (const auto p = exact_plane(t, a, 1);
                t.base[a] > 2 && p[2] == 0 && p[0] + p[1] == p[1])
              return false;
          return planes_met(t) == 3;
        }) > 0.01);
  const auto in_plane = [](const trial& t) {
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned k = 0; k <= t.extent[a]; ++k)
        if (t.direction[a] == 0 && t.origin[a] == t.plane(static_cast<int>(a), k))
          return true;
    return !of_doubles(t);
  };
  CHECK(share("face", grids, in_plane) == 1);
  CHECK(share("mid-plane", grids, in_plane) == 1);
  const auto on = [](int wanted) {
    return [wanted](const trial& t) {
      int axes = 0;
      for (unsigned a = 0; a < 3; ++a)
        for (unsigned k = 0; k <= t.extent[a]; ++k)
          if (t.origin[a] == t.plane(static_cast<int>(a), k)) {
            ++axes;
            break;
          }
      return axes >= wanted || !of_doubles(t);
    };
  };
  CHECK(share("origin-vertex", grids, on(3)) == 1);
  CHECK(share("origin-edge", grids, on(2)) == 1);
  CHECK(share("origin-face", grids, on(1)) == 1);
  CHECK(share("aimed-vertex", grids, [](const trial& t) { return truth_of(t).touched != 0; }) >
        0.6);
  CHECK(share("root-graze", grids,
              [](const trial& t) { return (t.at_near_face() | t.at_far_face()) != 0; }) > 0.99);
  CHECK(share("random", grids, [](const trial& t) { return truth_of(t).touched != 0; }) > 0.2);
}

TEST_CASE("fuzz.scenes: boxes are met, at their corners, edges and faces too", "[property]") {
  unsigned flat = 0, many = 0, shared = 0, only_touched = 0, tiny = 0;
  for (std::uint64_t k = 0; k < 4000; ++k) {
    const trial t = made("vertex", k, boxes);
    const truth exact = truth_of(t);
    only_touched += (exact.touched & ~exact.crossed) != 0 ? 1 : 0;
    many += std::popcount(exact.touched) > 4 ? 1 : 0;
    bool has_flat = false, has_shared = false;
    double least = HUGE_VAL, most = 0;
    for (std::size_t i = 0; i < t.boxes->size(); ++i) {
      const auto& b = (*t.boxes)[i];
      for (unsigned a = 0; a < 3; ++a) {
        has_flat = has_flat || b.lo[a] == b.hi[a];
        least = std::min(least, b.hi[a] - b.lo[a]);
        most = std::max(most, b.hi[a] - b.lo[a]);
        for (std::size_t j = 0; j < i; ++j)
          has_shared = has_shared || b.lo[a] == (*t.boxes)[j].hi[a];
      }
    }
    flat += has_flat ? 1 : 0;
    shared += has_shared ? 1 : 0;
    tiny += least > 0 && most / least > 1e6 ? 1 : 0;
  }
  CHECK(flat > 400);
  CHECK(many > 200);
  CHECK(shared > 1000);
  CHECK(only_touched > 1500);
  CHECK(tiny > 100);
  for (const generator& g : generators())
    CHECK(share(g.name.data(), boxes, [](const trial& t) { return truth_of(t).touched != 0; }) >
          0.15);
}

TEST_CASE("fuzz.scenes: segments end on planes, beside them, at vertices, near and far",
          "[property]") {
  for (const scene_choice& scene : {in_segments(grids), in_segments(cubes), in_segments(boxes)}) {
    unsigned on_plane = 0, beside = 0, vertex = 0, tiny = 0, ends_inside = 0, rounded = 0;
    for (std::uint64_t k = 0; k < 6000; ++k) {
      const trial t = made("aimed-edge", k, scene);
      const vec3& e = *t.end;
      unsigned on = 0;
      bool near = false, exact = true;
      for (unsigned a = 0; a < 3; ++a) {
        std::vector<double> planes;
        if (t.boxes)
          for (const auto& b : *t.boxes) {
            planes.push_back(b.lo[a]);
            planes.push_back(b.hi[a]);
          }
        else
          for (unsigned p = 0; p <= t.extent[a]; ++p)
            planes.push_back(t.plane(static_cast<int>(a), p));
        on += std::count(planes.begin(), planes.end(), e[a]) != 0 ? 1 : 0;
        for (const double p : planes)
          near = near || e[a] == step_ulps(p, 1) || e[a] == step_ulps(p, -1);
        exact = exact && mpq_class(e[a]) - mpq_class(t.origin[a]) == mpq_class(t.direction[a]);
      }
      on_plane += on >= 1 ? 1 : 0;
      vertex += on == 3 ? 1 : 0;
      beside += near ? 1 : 0;
      tiny += std::fabs(t.direction[0]) < 1e-12 * std::fabs(t.origin[0]) ? 1 : 0;
      rounded += exact ? 0 : 1;
      ends_inside += truth_of(t).touched != 0 ? 1 : 0;
    }
    CHECK(on_plane > 1500);
    CHECK(vertex > 500);
    CHECK(beside > 400);
    CHECK(tiny > 100);
    CHECK(rounded > 400);
    CHECK(ends_inside > 1500);
  }
}

TEST_CASE("fuzz.scenes: the two oracles agree", "[property]") {
  const auto rational = find_traversal("rational")->make();
  for (const scene_choice& scene :
       {grids, boxes, in_segments(grids), in_segments(boxes), in_segments(cubes)})
    for (const generator& g : generators())
      for (std::uint64_t k = 0; k < 150; ++k) {
        const trial t = make_trial(g, 33, 7 * k, 1 + static_cast<int>(k % 53), scene);
        const replay_result r = replay(t, *rational);
        INFO(to_json_line(t));
        REQUIRE(r.oracles_agree);
        REQUIRE(r.findings == 0);
      }
}

namespace {

campaign_plan plan_in(std::string_view traversal, const scene_choice& scene, std::uint64_t rays) {
  campaign_plan plan = plan_of(traversal, 20, rays);
  plan.scene = scene;
  return plan;
}

const std::array<scene_choice, 6> all_scenes{
    cubes, grids, boxes, in_segments(cubes), in_segments(grids), in_segments(boxes)};

} // namespace

TEST_CASE("fuzz.references: nothing accuses rationals, whatever the cells and the promise",
          "[property]") {
  for (const char* name :
       {"rational", "rational-owned", "rational-first", "rational-any", "rational-count"})
    for (const scene_choice& scene : all_scenes) {
      if (!find_traversal(name)->make()->takes(scene.cells, scene.segments))
        continue;
      const campaign_result result = run(plan_in(name, scene, 1000));
      INFO(name << " " << static_cast<unsigned>(scene.cells) << " " << scene.segments);
      CHECK(result.total.rays == 1000);
      CHECK(result.total.findings == 0);
      CHECK(result.total.declined <= 700); // counts of origins on surfaces
    }
}

TEST_CASE("fuzz.references: what is wrong on purpose is found", "[property]") {
  const std::map<std::string_view, finding> wrong{
      {"mutant-second", finding::crossed_miss}, {"mutant-distance", finding::distance},
      {"mutant-face", finding::face},           {"mutant-hit", finding::crossed_miss},
      {"mutant-parity", finding::count},        {"mutant-open-end", finding::miss}};
  for (const traversal_entry& e : wrong_references())
    for (const scene_choice& scene : all_scenes) {
      if (e.name == "mutant-open-end" && !scene.segments)
        continue;
      const campaign_result result = run(plan_in(e.name, scene, 1000));
      INFO(e.name << " " << static_cast<unsigned>(scene.cells) << " " << scene.segments);
      CHECK(result.total.rays_with[static_cast<unsigned>(wrong.at(e.name))] > 0);
    }
  // textbooks
  for (const char* name : {"slabs", "slabs-first", "grid-amanatides-woo"})
    for (const scene_choice& scene : {grids, in_segments(grids)})
      CHECK(run(plan_in(name, scene, 3000)).total.crossed_missed > 0);
}

TEST_CASE("fuzz.grids: the product's voxel sets over grids, and its boxes, keep their promises",
          "[property]") {
  for (const traversal_entry& e : grid_traversals())
    for (const scene_choice& scene : all_scenes) {
      if (!e.make()->takes(scene.cells, scene.segments))
        continue;
      const campaign_result result = run(plan_in(e.name, scene, 3000));
      INFO(e.name << " " << static_cast<unsigned>(scene.cells) << " " << scene.segments);
      CHECK(result.total.rays == 3000);
      CHECK(result.total.touched > 1000);
      CHECK(result.total.findings == 0);
      CHECK(result.total.declined == 0);
    }
}

TEST_CASE("fuzz.tame: the edges of a tame campaign's grids and boxes are within bounds",
          "[regression]") {
  double least = 1e300, greatest = 0, steepest = 1;
  unsigned untamed = 0;
  for (const scene_choice& scene : {grids, boxes})
    for (std::uint64_t k = 0; k < 20'000; k += scene.cells == cell_kind::grid ? 64 : 8) {
      const trial t = make_trial(generators()[0], 3, k, 20, scene, true);
      double low = 1e300, high = 0;
      const auto see = [&](double edge) {
        if (edge != 0)
          low = std::min(low, edge), high = std::max(high, edge);
      };
      for (unsigned a = 0; a < 3; ++a) {
        if (t.boxes)
          for (const auto& b : *t.boxes)
            see(b.hi[a] - b.lo[a]);
        else if (t.grid->rule != plane_rule::given)
          see(t.grid->spacing[a]);
        else
          for (std::size_t i = 1; i < t.grid->given[a].size(); ++i)
            see(t.grid->given[a][i] - t.grid->given[a][i - 1]);
      }
      if (high == 0)
        continue;
      least = std::min(least, low);
      greatest = std::max(greatest, high);
      steepest = std::max(steepest, high / low);
      const trial wild = make_trial(generators()[0], 3, k, 20, scene);
      untamed += (wild.boxes ? has_tame_edges(*wild.boxes) : has_tame_edges(*wild.grid)) ? 0 : 1;
    }
  CHECK(least >= 0x1p-40);
  CHECK(greatest <= 0x1p40);
  CHECK(steepest <= 0x1p20);
  CHECK(untamed > 100);
}

TEST_CASE("fuzz.scenes: tame rays are tame in grids and boxes too", "[property]") {
  for (const scene_choice& scene : all_scenes)
    for (const generator& g : generators())
      for (std::uint64_t k = 0; k < 200; ++k) {
        const trial t = make_trial(g, 12, k, 20, scene, true);
        INFO(g.name << " " << to_json_line(t));
        REQUIRE(judgeable(t));
        // a scene may lie so far from 0 that no origin is near it, and none as fine
        if (scene.cells == cell_kind::cube && !scene.segments)
          REQUIRE(is_tame(t));
      }
}

TEST_CASE("fuzz.scenes: mutated trials stay legal, and margins fall on a climb", "[property]") {
  for (const scene_choice& scene : all_scenes)
    for (const char* name : {"aimed-vertex", "vertex", "random"})
      for (std::uint64_t k = 0; k < 20; ++k) {
        climber c(made(name, k, scene), 3, k);
        const double start = margin(c.at());
        for (int i = 0; i < 100; ++i) {
          const trial t = c.next();
          REQUIRE(judgeable(t));
          REQUIRE(t.cells() == scene.cells);
          REQUIRE(t.end.has_value() == scene.segments);
        }
        REQUIRE(margin(c.at()) <= std::max(start, 0x1p-4));
      }
}

TEST_CASE("fuzz.codec: grids, boxes and segments come back from bytes", "[property]") {
  for (const scene_choice& scene : all_scenes)
    for (const generator& g : generators())
      for (std::uint64_t k = 0; k < 40; ++k) {
        const trial t = make_trial(g, 14, 31 * k, 20, scene);
        const auto bytes = encode(t);
        const auto again = decode(bytes);
        INFO(to_json_line(t));
        REQUIRE(again);
        REQUIRE(*again == t);
        REQUIRE_FALSE(decode({bytes.data(), bytes.size() - 1}));
        auto longer = bytes;
        longer.push_back(0);
        REQUIRE_FALSE(decode(longer));
        random_stream random(k, 3); // any bytes are a trial that is legal, or none
        auto damaged = bytes;
        for (int i = 0; i < 5; ++i)
          damaged[random.below(static_cast<unsigned>(damaged.size()))] =
              static_cast<std::uint8_t>(random.bits(8));
        if (const auto other = decode(damaged)) {
          REQUIRE(judgeable(*other));
        }
      }
}
