/// The generators do what their names say, by the oracle.
#include <algorithm>
#include <catch2/catch.hpp>
#include <generate/generators.hpp>
#include <graze/oracle/geometry.hpp>
#include <judge/judge.hpp>

using namespace graze::fuzz;

namespace {

constexpr unsigned sample = 3000;
constexpr std::array<int, 5> levels{1, 10, 30, 50, 53};

std::vector<graze::oracle::step> steps_of(const trial& t) {
  std::array<std::vector<double>, 3> planes;
  for (unsigned a = 0; a < 3; ++a)
    for (unsigned k = 0; k <= t.extent[a]; ++k)
      planes[a].push_back(t.plane(static_cast<int>(a), k));
  return graze::oracle::steps_in_grid(t.origin, t.direction, {planes[0], planes[1], planes[2]});
}

/// The largest number of axes on which one step of the ray is on a plane of the grid.
int planes_met(const trial& t) {
  int most = 0;
  for (const auto& s : steps_of(t))
    most = std::max(most, static_cast<int>(std::count_if(
                              s.at.begin(), s.at.end(), [](int place) { return place % 2 == 0; })));
  return most;
}

/// The share of a generator's trials of which `holds` is true.
template <class Holds> double share(const char* name, Holds holds) {
  const generator* g = find_generator(name);
  REQUIRE(g != nullptr);
  unsigned holding = 0;
  for (const int level : levels)
    for (unsigned k = 0; k < sample; ++k)
      holding += holds(make_trial(*g, 7, k, level)) ? 1 : 0;
  return holding / double(sample * levels.size());
}

bool through_vertex(const trial& t) { return planes_met(t) == 3; }
bool through_edge(const trial& t) { return planes_met(t) >= 2; }

} // namespace

TEST_CASE("fuzz.generators: every trial is legal at every level", "[property]") {
  for (const generator& g : generators())
    for (int level = 1; level <= 53; ++level)
      for (unsigned k = 0; k < 200; ++k) {
        const trial t = make_trial(g, 11, k, level);
        INFO(g.name << " level " << level << " ray " << k);
        REQUIRE(judgeable(t));
        REQUIRE(t.level == level);
      }
}

TEST_CASE("fuzz.generators: they work in other roots too", "[property]") {
  for (const cube& root :
       {cube{{-1, -1, -1}, 2}, cube{{0, 0, 0}, 0x1p40}, cube{{-2.5, -2.5, -2.5}, 5}})
    for (const generator& g : generators())
      for (unsigned k = 0; k < 500; ++k) {
        INFO(g.name << " ray " << k);
        REQUIRE(judgeable(make_trial(g, 12, k, 20, root)));
      }
}

TEST_CASE("fuzz.generators: vertex rays go through a vertex exactly", "[property]") {
  CHECK(share("vertex", through_vertex) == 1);
}

TEST_CASE(
    "fuzz.generators: edge-0 rays go through an edge exactly, edge-1 and edge-2 mostly beside it",
    "[property]") {
  CHECK(share("edge-0", through_edge) == 1);
  CHECK(share("edge-1", through_edge) < 0.5);
  CHECK(share("edge-2", through_edge) < 0.5);
}

TEST_CASE("fuzz.generators: face and mid-plane rays lie in a plane of the grid", "[property]") {
  const auto in_plane = [](const trial& t) {
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned k = 0; k <= t.extent[a]; ++k)
        if (t.direction[a] == 0 && t.origin[a] == t.plane(static_cast<int>(a), k))
          return true;
    return false;
  };
  CHECK(share("face", in_plane) == 1);
  CHECK(share("mid-plane", in_plane) == 1);
}

TEST_CASE("fuzz.generators: near-parallel rays reach down to 5e-324", "[property]") {
  CHECK(share("near-parallel", [](const trial& t) {
          return std::any_of(t.direction.begin(), t.direction.end(),
                             [](double d) { return std::fabs(d) == 5e-324; });
        }) > 0.02);
}

TEST_CASE("fuzz.generators: diagonal rays meet several planes at one t", "[property]") {
  CHECK(share("diagonal", through_edge) > 0.5);
  // and some of them in a plane across an axis; where origins are far coarser than octants, more are
  int across = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const trial t = make_trial(*find_generator("diagonal"), 5, k, 4);
    across += t.direction[0] == 0 || t.direction[1] == 0 || t.direction[2] == 0;
  }
  CHECK(across > 300);
}

TEST_CASE("fuzz.generators: origins lie on a vertex, an edge, a face", "[property]") {
  const auto on = [](int wanted) {
    return [wanted](const trial& t) {
      int axes = 0;
      for (unsigned a = 0; a < 3; ++a)
        for (unsigned k = 0; k <= t.extent[a]; ++k)
          axes += t.origin[a] == t.plane(static_cast<int>(a), k) ? 1 : 0;
      return axes >= wanted;
    };
  };
  CHECK(share("origin-vertex", on(3)) == 1);
  CHECK(share("origin-edge", on(2)) == 1);
  CHECK(share("origin-face", on(1)) == 1);
}

TEST_CASE("fuzz.generators: aimed rays pass near, mostly not through", "[property]") {
  CHECK(share("aimed-vertex", through_vertex) < 0.5);
  CHECK(share("aimed-edge", through_edge) < 0.5);
  CHECK(share("aimed-vertex", [](const trial& t) { return truth_of(t).touched != 0; }) > 0.7);
}

TEST_CASE("fuzz.generators: root-graze blocks lie at the root's faces", "[property]") {
  CHECK(share("root-graze",
              [](const trial& t) { return (t.at_near_face() | t.at_far_face()) != 0; }) == 1);
}

TEST_CASE("fuzz.generators: subnormal and huge directions are that", "[property]") {
  const auto any = [](auto is) {
    return [is](const trial& t) { return std::any_of(t.direction.begin(), t.direction.end(), is); };
  };
  CHECK(share("subnormal", any([](double d) { return d != 0 && std::fabs(d) < 0x1p-1022; })) > 0.3);
  CHECK(share("subnormal", any([](double d) { return std::fabs(d) < 0x1p-400; })) == 1);
  CHECK(share("huge", any([](double d) { return std::fabs(d) > 0x1p250; })) > 0.9);
  CHECK(share("huge", any([](double d) { return std::fabs(d) > 0x1p1000; })) > 0.05);
}

TEST_CASE("fuzz.generators: exponent-gap directions span up to 2000 binades, and some rays go "
          "through a vertex",
          "[property]") {
  const auto span = [](const trial& t) {
    double least = HUGE_VAL, most = 0;
    for (const double d : t.direction)
      if (d != 0)
        least = std::min(least, std::fabs(d)), most = std::max(most, std::fabs(d));
    return std::ilogb(most) - std::ilogb(least);
  };
  CHECK(share("exponent-gap", [&](const trial& t) { return span(t) >= 1990; }) > 0.05);
  CHECK(share("exponent-gap", [&](const trial& t) { return span(t) >= 500; }) > 0.3);
  CHECK(share("exponent-gap", [](const trial& t) { return truth_of(t).touched != 0; }) > 0.1);
  CHECK(share("exponent-gap", [&](const trial& t) { return span(t) >= 500 && through_vertex(t); }) >
        0.005);
}

TEST_CASE("fuzz.generators: far origins are far", "[property]") {
  CHECK(share("far-origin", [](const trial& t) {
          return std::any_of(t.origin.begin(), t.origin.end(),
                             [](double o) { return std::fabs(o) > 1; });
        }) > 0.85);
  CHECK(share("far-origin", [](const trial& t) {
          return std::any_of(t.origin.begin(), t.origin.end(),
                             [](double o) { return std::fabs(o) > 0x1p1000; });
        }) > 0.001);
}

TEST_CASE("fuzz.generators: the control touches its block and meets no edge", "[property]") {
  CHECK(share("random", [](const trial& t) { return truth_of(t).touched != 0; }) > 0.3);
  const generator* g = find_generator("random");
  unsigned edges = 0;
  for (unsigned k = 0; k < sample; ++k)
    edges += through_edge(make_trial(*g, 7, k, 10)) ? 1 : 0;
  CHECK(edges == 0);
}
