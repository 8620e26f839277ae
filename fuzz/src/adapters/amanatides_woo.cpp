#include "adapters.hpp"
#include "grid_walk.hpp"

namespace graze::fuzz {

namespace {

/// The algorithm walks a grid (grid_walk.hpp). Up to level 10 it gets the whole grid of the trial's
/// level; below, where there are too many cells, the block alone is its grid.
class amanatides_woo final : public traversal {
public:
  explicit amanatides_woo(std::string_view name) : name_(name) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }

  void visit(const trial& t, visited& out) override {
    const bool whole = t.level <= 10;
    cell_grid grid{{}, t.size(), {}};
    std::array<int, 3> block{};
    for (unsigned a = 0; a < 3; ++a) {
      grid.cells[a] = whole ? 1 << t.level : t.extent[a];
      block[a] = whole ? static_cast<int>(t.base[a]) : 0;
      grid.lo[a] = whole ? t.root.lo[a] : t.plane(static_cast<int>(a), 0);
    }
    walk_grid(grid, t.origin, t.direction, [&](const std::array<int, 3>& at) {
      bool inside = true, behind = false; // behind the block no later cell is of it
      for (unsigned a = 0; a < 3; ++a) {
        const int in = at[a] - block[a];
        inside = inside && in >= 0 && in < t.extent[a];
        behind = behind || (t.direction[a] < 0 ? in < 0 : in >= t.extent[a]);
      }
      if (inside)
        out.push(voxel_at(static_cast<unsigned>(at[0] - block[0]),
                          static_cast<unsigned>(at[1] - block[1]),
                          static_cast<unsigned>(at[2] - block[2])));
      return behind;
    });
  }

private:
  std::string_view name_;
};

} // namespace

std::unique_ptr<traversal> make_amanatides_woo(std::string_view name) {
  return std::make_unique<amanatides_woo>(name);
}

} // namespace graze::fuzz
