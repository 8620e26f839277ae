// Voxelizations by scalar code and by lanes: the same octants, and the same of them certified.
#include "../../support/paths.hpp"
#include "inputs.hpp"
#include "surfaces.hpp"
#include <graze/octree_formula/lane_kernels.hpp>

using namespace graze;
using namespace graze::octree;
using namespace graze::twins;

namespace {

struct tally {
  std::size_t trees = 0, refused = 0, kept = 0, certified = 0;
  std::uint64_t possible = 0;
};

template <class F> void compare(const F& f, const box& domain, int level, batch::path p, tally& t) {
  INFO("level " << level << ", domain from " << domain.lo[0] << ' ' << domain.lo[1] << ' '
                << domain.lo[2] << " to " << domain.hi[0] << ' ' << domain.hi[1] << ' '
                << domain.hi[2]);
  const auto scalar = voxelize(f, domain, level);
  const auto by_lanes = voxelize_in_lanes(f, domain, level, p);
  ++t.trees;
  if (!scalar) {
    ++t.refused;
    CHECK_FALSE(by_lanes);
    CHECK(by_lanes.reason() == scalar.reason());
    return;
  }
  REQUIRE(by_lanes);
  CHECK(*scalar == *by_lanes);
  t.kept += scalar->leaf_count();
  for (const content c : scalar->leaves())
    ++(c == content::certified ? t.certified : t.possible);
}

void of_scenes(batch::path p) {
  for_each_built_in([p](const auto& row) {
    INFO(row.name);
    const auto f = row.surface();
    tally t;
    std::vector<box> domains = some_domains();
    domains.push_back({{-0.8, -2.5, 0.1}, {2.5, 0.3, 2.5}});
    domains.push_back({{-1024, -1024, -1024}, {1024, 1024, 1024}});
    domains.push_back({{10, 10, 10}, {12.5, 12.5, 12.5}});
    for (const box& domain : domains)
      for (const int level : {1, 2, 4, 6})
        compare(f, domain, level, p, t);
    const double reach = 2.5;
    compare(f, {{-reach, -reach, -reach}, {reach, reach, reach}}, 8, p, t);
    compare(f, {{1, 0, 0}, {0, 1, 1}}, 3, p, t); // empty
    compare(f, {{-1, -1, -1}, {1, 1, 1}}, 54, p, t);
    CHECK(t.refused >= 2);
    CHECK(t.certified > 5000);
    CHECK(t.possible > 50);
  });
}

void of_texts(batch::path p, const std::vector<std::string>& texts, std::size_t domains_each) {
  const std::vector<box> domains = some_domains();
  tally t;
  std::size_t next = 0;
  for (const std::string& text : texts) {
    INFO(text);
    const formula f = parsed(text);
    compare(f.surface(), domains[0], 4, p, t);
    for (std::size_t k = 0; k < domains_each; ++k, ++next)
      compare(f.surface(), domains[1 + next % (domains.size() - 1)], 3, p, t);
  }
  CHECK(t.refused < t.trees / 4);
  CHECK(t.certified > 5000);
  CHECK(t.possible > 1000);
}
void of_operations(batch::path p) { of_texts(p, operation_texts(), 5); }
void of_random_formulas(batch::path p) { of_texts(p, random_texts(21, 300), 3); }

} // namespace

GRAZE_TEST_EACH_PATH("octree.twins", "octrees of the scenes are the scalar ones", "[property]",
                     of_scenes)
GRAZE_TEST_EACH_PATH("octree.twins", "octrees of every operation of a tape are the scalar ones",
                     "[property]", of_operations)
GRAZE_TEST_EACH_PATH("octree.twins", "octrees of random formulas are the scalar ones", "[property]",
                     of_random_formulas)
