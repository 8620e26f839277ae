#pragma once
/// What every search asks for, of rays, in a campaign's folder or of our own code: which trials, for how
/// long, by how many workers.
#include <external/external.hpp>
#include <generate/climb.hpp>
#include <generate/generators.hpp>
#include <generate/scenes.hpp>
#include <graze/support/status.hpp>
#include <string>
#include <vector>

namespace graze::fuzz {

struct trial_plan {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< number of the first trial
  std::uint64_t trials = 0; ///< 0: no limit
  double seconds = 0;       ///< 0: no limit
  unsigned workers = 1;     ///< threads, or processes: 1..1024
};
/// Refuses a budget of time that is none, and a number of workers that is outside 1..1024.
support::status check(const trial_plan& p);
/// Five seconds where there is no budget.
void limit(trial_plan& p);

/// How rays are looked for: `generators` are asked for each; `climb` starts at a generator's ray
/// and goes on towards the smallest margin (generate/climb.hpp).
enum class search : std::uint8_t { generators, climb };
std::string_view name_of(search s);
/// By the names of name_of().
std::optional<search> search_of(std::string_view name);

/// Each hang costs the whole time that a ray may take.
inline constexpr std::uint64_t usual_hangs = 3;

/// What rays to make, and whom to ask. Ray k of a campaign is trial k of the seed, by generator k mod
/// the number of generators; in a climb, step k mod climb_length of climb k / climb_length, which starts
/// at the trial of that number. So a campaign of a given number of rays counts and finds the same on any
/// number of threads.
struct campaign_plan : trial_plan {
  traversal_entry under_test{};
  std::vector<const generator*> generators;
  scene_choice scene;    ///< what the rays go through
  std::string grid_file; ///< the file of the scene's grid, for commands that ask again; empty: none
  int level = 50;        ///< 1..53, of octants
  int last_level = 50;   ///< rays take the levels from `level` to this one in turn
  search method = search::generators;
  bool until_finding = false; ///< ends soon after the first one
  bool tame = false; ///< rays that are not (generate/tame.hpp) are replaced by such that are
  std::uint64_t hangs =
      usual_hangs; ///< after as many of a generator its rays are sent no more; 0: no limit
};

/// The same by the names that the command line and a campaign's folder use.
struct named_plan {
  std::string traversal = "sound";          ///< its name; a command where there is `external`
  std::optional<external_options> external; ///< how the command is driven
  std::vector<std::string> generators;
  std::string search = "generators"; ///< or "climb"
  std::string level = "50";          ///< "A" or "A-B", taken in turn
  std::string cells = "cube";        ///< or "grid", "boxes"
  bool segments = false;             ///< in place of rays
  std::string grid;                  ///< a JSON grid, as in replay lines; empty: random ones
  std::optional<map_file> scene;     ///< a map, whose occupied voxels are the cells: then no other
  std::uint64_t seed = 1;
  std::uint64_t rays = 0; ///< 0: no limit
  double seconds = 0;     ///< 0: no limit
  bool tame = false;
  std::uint64_t hangs = usual_hangs;
};

/// With "all" replaced by the names of all generators.
std::vector<std::string> all_named(const std::vector<std::string>& generators);
/// Without those of `except`; refused where one of these is no generator.
expected<std::vector<std::string>> all_named(const std::vector<std::string>& generators,
                                             const std::vector<std::string>& except);

/// Whether the traversal takes such trials and its promise says something of them, or why not.
support::status check(const traversal& under_test, const scene_choice& scene);

/// All but the traversal; the reason names what does not exist or is no budget.
expected<campaign_plan> resolve_rays(const named_plan& named);
/// The traversal as well. A command is not started and a map is not read: under_test.make is empty.
expected<campaign_plan> resolve(const named_plan& named);
/// Reads the plan's map, if it has one; `like` is then told of it.
support::status load_map(const named_plan& named, campaign_plan& plan, external_options& like);

} // namespace graze::fuzz
