#include <cli/scene_options.hpp>
#include <fmt/format.h>
#include <graze/support/files.hpp>

namespace graze::fuzz {

namespace {
constexpr std::uint64_t longest_grid = std::uint64_t{1} << 26; ///< of a file, in bytes
} // namespace

void add_scene_options(CLI::App& app, scene_options& options) {
  app.add_option("--cells", options.cells,
                 "What rays are led through: cube (octants of a level), grid (planes of any kind), "
                 "boxes (default: what the traversal takes)")
      ->check(CLI::IsMember({"cube", "grid", "boxes"}));
  app.add_flag("--segments", options.segments, "From a point to a point, in place of rays");
  app.add_option(
      "--grid", options.grid,
      "The grid of this file: the JSON object \"grid\" of a replay line (default: random "
      "ones)");
}

support::status take_scene(const scene_options& options, named_plan& plan,
                           traversal_options& traversal) {
  std::string cells = options.cells;
  if (!options.grid.empty()) {
    if (cells.empty())
      cells = "grid";
    auto text = support::read_file(options.grid, longest_grid);
    if (!text)
      return unexpected{text.reason()};
    plan.grid = *std::move(text);
  }
  if (!cells.empty()) {
    plan.cells = cells;
    traversal.external.cells = cell_kind_of(cells);
  }
  plan.segments = options.segments;
  if (options.segments)
    traversal.external.segments = true;
  return {};
}

support::status settle_scene(const scene_options& options, const traversal_entry& under_test,
                             scene_choice& scene, named_plan& plan) {
  const auto made = under_test.make();
  const bool any_cells = options.cells.empty() && options.grid.empty();
  for (const bool segments : {false, true})
    for (const cell_kind cells : {cell_kind::cube, cell_kind::grid, cell_kind::boxes}) {
      if ((!any_cells && cells != scene.cells) || (options.segments && !segments) ||
          !made->takes(cells, segments))
        continue;
      scene.cells = cells;
      scene.segments = segments;
      plan.cells = name_of(cells);
      plan.segments = segments;
      return check(*made, scene);
    }
  return check(*made, scene);
}

} // namespace graze::fuzz
