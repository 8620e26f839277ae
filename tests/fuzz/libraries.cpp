/// The adapters to libraries: each answers rays with nothing special rightly, and is caught where
/// it is known to be wrong. A library that is not there is skipped.
#include "campaign_of.hpp"
#include <external/libraries.hpp>
#include <iostream>

using namespace graze::fuzz;

namespace {

/// Time is no matter: half a minute on a busy machine is no hang.
std::optional<traversal_entry> find_library(std::string_view name) {
  external_options like;
  like.seconds_a_ray = 30;
  for (const traversal_entry& e : library_traversals(like))
    if (e.name == name)
      return e;
  std::cout << "graze: skipped, the adapter of " << name
            << " is not built (its library was not there)\n";
  return std::nullopt;
}

counts counts_of(const traversal_entry& entry, std::string_view generator, std::uint64_t rays) {
  campaign_plan plan = plan_of("sound", 10, rays, generator);
  plan.under_test = entry;
  plan.workers = 1;
  const counts c = run(plan).total;
  CHECK(c.rays == rays);
  CHECK(c.faults == 0);
  CHECK(c.visited > 0);
  return c;
}

/// Right on random rays, wrong on some of those that are aimed at a vertex.
void right_and_wrong(std::string_view name, std::uint64_t random, std::uint64_t aimed) {
  const auto entry = find_library(name);
  if (!entry)
    return;
  INFO(name);
  const counts usual = counts_of(*entry, "random", random);
  CHECK(usual.misses == 0);
  CHECK(usual.gaps == 0);
  CHECK(usual.declined == 0);
  CHECK(counts_of(*entry, "aimed-vertex", aimed).crossed_missed > 0);
}

} // namespace

TEST_CASE("fuzz.libraries: OctoMap", "[property]") {
  right_and_wrong("octomap-ray-keys", 300, 300);
  right_and_wrong("octomap-cast-ray", 200, 200);
}

TEST_CASE("fuzz.libraries: PCL", "[property]") { right_and_wrong("pcl", 1000, 500); }

TEST_CASE("fuzz.libraries: OpenVDB", "[property]") {
  right_and_wrong("openvdb-dda", 300, 300);
  right_and_wrong("openvdb-level-set-hdda", 300, 300);
  right_and_wrong("openvdb-volume-ray-intersector", 50, 100);
}

TEST_CASE("fuzz.libraries: NanoVDB misses voxels of random rays too", "[property]") {
  for (const char* name : {"nanovdb-first-active", "nanovdb-hdda"}) {
    const auto entry = find_library(name);
    if (!entry)
      return;
    INFO(name);
    const counts usual = counts_of(*entry, "random", 50);
    CHECK(usual.gross_missed > 0);
    CHECK(usual.rays_with_miss < 40);
    CHECK(counts_of(*entry, "aimed-vertex", 50).gross_missed > 0);
  }
}

TEST_CASE("fuzz.libraries: Embree", "[property]") {
  for (const char* name :
       {"embree-boxes", "embree-boxes-robust", "embree-triangles", "embree-triangles-robust"})
    right_and_wrong(name, 300, 300);
}

TEST_CASE("fuzz.libraries: CGAL is wrong in double", "[property]") {
  const auto entry = find_library("cgal-inexact");
  if (!entry)
    return;
  CHECK(counts_of(*entry, "random", 1000).misses == 0);
  CHECK(counts_of(*entry, "aimed-vertex", 2000).crossed_missed > 0);
}

TEST_CASE("fuzz.libraries: CGAL's octree is not accused", "[property]") {
  for (const char* name : {"cgal-octree", "cgal-octree-epeck"}) {
    const auto entry = find_library(name);
    if (!entry)
      return;
    campaign_plan plan = plan_of("sound", 10, 1500);
    plan.under_test = *entry;
    const counts c = run(plan).total;
    INFO(name);
    CHECK(c.findings == 0);
    CHECK(c.declined < c.rays / 2);
  }
}

TEST_CASE("fuzz.libraries: CGAL with exact predicates is not accused", "[property]") {
  for (const char* name : {"cgal-epick", "cgal-epeck"}) {
    const auto entry = find_library(name);
    if (!entry)
      return;
    for (const int level : {1, 10, 53}) {
      campaign_plan plan = plan_of("sound", level, 1500);
      plan.under_test = *entry;
      const counts c = run(plan).total;
      INFO(name << " at level " << level);
      CHECK(c.findings == 0);
      CHECK(c.touched > 0);
      CHECK(c.declined < c.rays);
      CHECK((c.declined == 0 || std::string_view(name) == "cgal-epick"));
    }
  }
}
