#pragma once
/// The options of graze-fuzz that choose what rays are led through.
#include <campaign/plan.hpp>
#include <cli/traversal_options.hpp>

namespace graze::fuzz {

struct scene_options {
  std::string cells; ///< empty: what the traversal takes
  bool segments = false;
  std::string grid; ///< a file
};

/// Adds --cells, --segments and --grid.
void add_scene_options(CLI::App& app, scene_options& options);

/// What they say, in a plan's names and for a command; a grid's file is read. The reason says what is wrong.
support::status take_scene(const scene_options& options, named_plan& plan,
                           traversal_options& traversal);

/// What the options leave open, by what the traversal takes; in a plan's names too.
support::status settle_scene(const scene_options& options, const traversal_entry& under_test,
                             scene_choice& scene, named_plan& plan);

} // namespace graze::fuzz
