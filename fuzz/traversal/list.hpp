#pragma once
/// The traversals that can be put to the test, by their names.
#include <functional>
#include <memory>
#include <traversal/traversal.hpp>
#include <vector>

namespace graze::fuzz {

struct external_options;

/// A traversal that can be chosen by name.
struct traversal_entry {
  std::string_view name;
  std::string_view summary;
  std::function<std::unique_ptr<traversal>()> make;
  std::string options{};              ///< how a user asks for it; empty: "--traversal NAME"
  std::vector<std::string> notices{}; ///< lines for the user
  /// Of a traversal in another process: how it is asked, its first line taken over.
  std::shared_ptr<const external_options> external{};

  /// One that is made again after each exception, which may leave it in any state: its visit()
  /// tells what is thrown, by making it too, as fault::exception and throws nothing. The first is
  /// made at once, and may throw.
  [[nodiscard]] std::unique_ptr<traversal> guarded() const;

  /// The options of graze-fuzz that choose it.
  [[nodiscard]] std::string asked_for() const {
    return options.empty() ? "--traversal " + std::string(name) : options;
  }
};

/// All that can be chosen, the sound ones first.
const std::vector<traversal_entry>& traversals();
/// Those of fuzz/peers/paper2005 and of octree/voxel_rays.hpp; traversals() has them.
std::vector<traversal_entry> baselines_of_2005();
std::vector<traversal_entry> lane_traversals();
/// Those of voxel sets over grids, and of boxes; traversals() has them.
std::vector<traversal_entry> grid_traversals();
/// The rational reference for each promise, and textbook methods in double, for any cells; adapters() has
/// the first. References that are wrong on purpose; mutants() has them.
const std::vector<traversal_entry>& rational_references();
std::vector<traversal_entry> wrong_references();
/// The traversals that are wrong on purpose: the harness is tested with them.
const std::vector<traversal_entry>& mutants();
/// Traversals of others, written here from their papers (fuzz/peers/papers), and the exact reference.
const std::vector<traversal_entry>& adapters();
/// What the program has added, before it runs anything: traversals that it links to.
const std::vector<traversal_entry>& linked_traversals();
void add_traversals(const std::vector<traversal_entry>& more);
/// Null when there is none of this name (mutants are named "mutant-...").
const traversal_entry* find_traversal(std::string_view name);

} // namespace graze::fuzz
