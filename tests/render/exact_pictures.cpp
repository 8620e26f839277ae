// Pictures against exact roots along each pixel's ray.
#include <catch2/catch.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/oracle/polynomial.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/oracle/roots.hpp>
#include <graze/render/render.hpp>
#include <optional>
#include <vector>

using namespace graze;
using namespace graze::render;

namespace {

/// The surface's polynomials along the ray; the surface is where one of them is 0.
std::vector<oracle::polynomial> along(const std::string& name, const octree::ray& r) {
  const auto [x, y, z] = oracle::along(r.origin(), r.direction());
  if (name == "quartdef")
    return {octree::quartdef{}(x, y, z)};
  if (name == "tanglecube")
    return {octree::tanglecube{}(x, y, z)};
  if (name == "holesrot")
    return {octree::holesrot{}(x, y, z)};
  std::vector<oracle::polynomial> parts;
  for (const auto& sphere : octree::spheres::parts)
    parts.push_back(octree::spheres::part(sphere, x, y, z));
  return parts;
}

/// The first root of the surface on the ray within the domain, to 2^-100.
std::optional<oracle::root> first(const scene& s, const octree::ray& r) {
  const auto range =
      oracle::rational::range_in(r.origin(), r.direction(), s.domain.lo, s.domain.hi);
  std::optional<oracle::root> least;
  if (!range)
    return least;
  for (const auto& g : along(s.name, r))
    if (const auto root = oracle::first_root(g, range->first, range->second, 100))
      if (!least || root->lo < least->lo)
        least = root;
  return least;
}

} // namespace

TEST_CASE("render.pictures: verdicts and depth enclosures hold the exact first root", "[mpfr]") {
  const char* const name = GENERATE("spheres", "quartdef", "tanglecube", "holesrot");
  const scene& s = *find_scene(name);
  const camera view = s.view();
  const auto coarse = s.prepare(s, 9, 30);
  const auto fine = s.prepare(s, 9, 50);
  REQUIRE(coarse);
  REQUIRE(fine);
  int hits = 0, misses = 0;
  for (int row = 2; row < 512; row += 6)
    for (int column = 3; column < 512; column += 6) {
      const octree::ray r = view.ray_through(column, row, 512);
      const auto root = first(s, r);
      ++(root ? hits : misses);
      for (const auto* work : {&*coarse, &*fine}) {
        const octree::surface_hit h = (*work)->first_hit(r, nullptr);
        INFO(name << " column " << column << " row " << row);
        REQUIRE(h.outcome == (root ? octree::verdict::hit : octree::verdict::miss));
        if (!root)
          continue;
        REQUIRE(mpq_class(h.t_near) <= root->hi);
        REQUIRE(root->lo <= mpq_class(h.t_far));
        REQUIRE(h.t_far - h.t_near < (work == &*coarse ? 0x1p-25 : 0x1p-42));
      }
    }
  INFO(name << ": " << hits << " hits, " << misses << " misses");
  CHECK(hits >= 1000);
  CHECK(misses >= 1000);
}

TEST_CASE("render.pictures: 512x512 has the exact number of hits at 30 and at 50 levels",
          "[mpfr]") {
  // The exact counts of quartdef and tanglecube come with the design; a hole would be one less.
  const auto expect = [](const char* name, std::uint64_t hits) {
    const scene& s = *find_scene(name);
    for (const int levels : {30, 50}) {
      const auto work = s.prepare(s, 9, levels);
      REQUIRE(work);
      const rendering picture = cast(s, **work, {512, 2});
      CHECK(picture.counts.hits == hits);
      CHECK(picture.counts.undecided == 0);
      CHECK(picture.counts.rays == 262144);
    }
  };
  expect("tanglecube", 97549);
  expect("quartdef", 109209);
}

TEST_CASE("render.pictures: the same picture for one thread, two, and seven", "[unit]") {
  const scene& s = *find_scene("holesrot");
  const auto work = s.prepare(s, 7, 30);
  REQUIRE(work);
  const auto bytes = [&](unsigned threads) {
    return *encode(to_picture(cast(s, **work, {100, threads})), file_format::exr);
  };
  const auto one = bytes(1);
  CHECK(bytes(2) == one);
  CHECK(bytes(7) == one);
}
