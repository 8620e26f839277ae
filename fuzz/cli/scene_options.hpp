#pragma once
/// The options of graze-fuzz that choose what rays go through.
#include <CLI/CLI.hpp>
#include <campaign/plan.hpp>
#include <optional>

namespace graze::fuzz {

struct scene_options {
  std::string cells; ///< empty: as the traversal takes them
  bool segments = false;
  std::string grid; ///< a file
  std::string map;  ///< a file, and what it leaves open
  std::optional<double> voxel_size;
  bool cell_centred = false;
};

void add_scene_options(CLI::App& app, scene_options& options);

/// Puts what is asked for into the plan and, where there is a program, into what it is asked to take. Reads
/// the grid's file; refuses what contradicts itself.
support::status take_scene(const scene_options& options, named_plan& plan,
                           external_options& external);

/// Where no cells are asked for: the traversal's own, octants and rays if it takes them.
void take_scene_of(const traversal& under_test, const scene_options& options, named_plan& plan);

} // namespace graze::fuzz
