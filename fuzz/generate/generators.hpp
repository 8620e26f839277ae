#pragma once
/// Adversarial rays. Each generator makes a trial around a special vertex of the grid: independent
/// random operands find nothing, rays through and beside vertices, edges and faces find at once.
#include <generate/random.hpp>
#include <string_view>
#include <trial/trial.hpp>
#include <vector>

namespace graze::fuzz {

/// A way of making rays. `make` fills a trial whose root and level are set (level 1..53, a root
/// that root_cube accepts at that level); what it makes passes judgeable().
struct generator {
  std::string_view name;
  std::string_view summary;
  void (*make)(random_stream& random, trial& t);
};

const std::vector<generator>& generators();
/// Null when there is none of this name.
const generator* find_generator(std::string_view name);

/// Trial `index` of `seed`: the same on every machine and in any order of making.
trial make_trial(const generator& g, std::uint64_t seed, std::uint64_t index, int level,
                 const cube& root = {{0, 0, 0}, 1});

} // namespace graze::fuzz
