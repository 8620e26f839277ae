#include <cli/scene_options.hpp>
#include <cmath>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

void add_scene_options(CLI::App& app, scene_options& options) {
  app.add_option("--cells", options.cells,
                 "What the rays go through: cube (the octants of a level), grid (voxels between "
                 "planes of any kind), boxes (a list of them)")
      ->check(CLI::IsMember({"cube", "grid", "boxes"}));
  app.add_flag("--segments", options.segments, "Segments from point to point in place of rays");
  app.add_option("--grid", options.grid,
                 "The grid of all rays, a JSON file as the member grid of a replay line; otherwise "
                 "random ones");
  CLI::Option* scene = app.add_option("--scene", options.map,
                                      "A map (.bt .ot .npy .vdb .nvdb .pcd .ply), whose occupied "
                                      "voxels rays are led to (docs/maps.md)");
  app.add_option("--voxel-size", options.voxel_size,
                 "The edge of a map's voxels, for points and arrays, which have none")
      ->needs(scene);
  app.add_flag("--cell-centred", options.cell_centred,
               "OpenVDB, NanoVDB: an index is at a voxel's centre, not at its lowest corner")
      ->needs(scene);
}

support::status take_scene(const scene_options& options, named_plan& plan,
                           external_options& external) {
  constexpr std::uint64_t largest_grid = std::uint64_t{1} << 28;
  if (!options.grid.empty()) {
    if (!options.cells.empty() && options.cells != "grid")
      return unexpected{fmt::format("--grid is given, but --cells is {}", options.cells)};
    const auto text = support::read_file(options.grid, largest_grid);
    if (!text)
      return unexpected{text.reason()};
    const auto grid = grid_from_text(*text);
    if (!grid)
      return unexpected{fmt::format("{}: {}", options.grid, grid.reason())};
    plan.grid = grid_text(*grid);
    plan.cells = "grid";
  }
  if (!options.map.empty()) {
    if (!options.grid.empty() || (!options.cells.empty() && options.cells != "grid"))
      return unexpected{"--scene has a grid of its own: without --grid, and --cells grid"};
    const double size = options.voxel_size.value_or(1);
    if (!(size > 0) || !std::isfinite(size))
      return unexpected{"--voxel-size is not a length above 0"};
    plan.scene = map_file{options.map, options.voxel_size.value_or(0), options.cell_centred};
    plan.cells = "grid";
  }
  if (!options.cells.empty())
    plan.cells = options.cells;
  plan.segments = options.segments;
  if (!options.cells.empty() || !options.grid.empty() || plan.scene)
    external.cells = cell_kind_of(plan.cells);
  if (options.segments)
    external.segments = true;
  return {};
}

void take_scene_of(const traversal& under_test, const scene_options& options, named_plan& plan) {
  for (const cell_kind cells : {cell_kind::cube, cell_kind::grid, cell_kind::boxes})
    for (const bool segments : {false, true}) {
      if ((!options.cells.empty() || !options.grid.empty() || plan.scene) &&
          name_of(cells) != plan.cells)
        continue;
      if (options.segments && !segments)
        continue;
      if (!under_test.takes(cells, segments))
        continue;
      plan.cells = name_of(cells);
      plan.segments = segments;
      return;
    }
}

} // namespace graze::fuzz
