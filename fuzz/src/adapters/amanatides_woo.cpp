#include "adapters.hpp"

namespace graze::fuzz {

namespace {

/// Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing", in double: a step
/// to the next cell on the axis whose plane is nearest in t, which then is increased by the time
/// that the ray takes through a cell.
///
/// The algorithm walks a grid. Up to level 10 it gets the whole grid of the trial's level; below,
/// where there are too many cells, the block alone is its grid. It gets the ray as it is; where the
/// origin is outside of the grid, the point at which the ray enters it is found by slabs, as the
/// paper says ("find the point in which the ray enters the grid and take the adjacent voxel").
class amanatides_woo final : public traversal {
public:
  explicit amanatides_woo(std::string_view name) : name_(name) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }

  void visit(const trial& t, visited& out) override {
    const bool whole = t.level <= 10;
    const double size = t.size();
    vec3 lo{}; // the grid's corner
    std::array<int, 3> cells{}, block{};
    double enter = 0, leave = INFINITY;
    for (unsigned a = 0; a < 3; ++a) {
      cells[a] = whole ? 1 << t.level : t.extent[a];
      block[a] = whole ? static_cast<int>(t.base[a]) : 0;
      lo[a] = whole ? t.root.lo[a] : t.plane(static_cast<int>(a), 0);
      const double hi = lo[a] + cells[a] * size, d = t.direction[a];
      if (d == 0) {
        if (t.origin[a] < lo[a] || t.origin[a] > hi)
          return;
        continue;
      }
      enter = std::max(enter, ((d > 0 ? lo[a] : hi) - t.origin[a]) / d);
      leave = std::min(leave, ((d > 0 ? hi : lo[a]) - t.origin[a]) / d);
    }
    if (enter > leave)
      return;

    std::array<int, 3> at{}, step{};
    vec3 next{}, delta{}; // the paper's tMax and tDelta
    for (unsigned a = 0; a < 3; ++a) {
      const double d = t.direction[a];
      const double point = enter > 0 ? t.origin[a] + enter * d : t.origin[a];
      at[a] = cell_of((point - lo[a]) / size, cells[a]);
      step[a] = d > 0 ? 1 : d < 0 ? -1 : 0;
      next[a] = d == 0 ? INFINITY : (lo[a] + (at[a] + (d > 0 ? 1 : 0)) * size - t.origin[a]) / d;
      delta[a] = d == 0 ? INFINITY : size / std::fabs(d);
    }
    while (true) {
      report(t, at, block, out);
      const unsigned a =
          next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      at[a] += step[a];
      // where all times have overflowed the axis may be one that the ray does not move on: the
      // paper's loop would not end
      if (step[a] == 0 || at[a] < 0 || at[a] >= cells[a])
        return;
      // behind the block: no later cell is of it
      if (step[a] > 0 ? at[a] >= block[a] + t.extent[a] : at[a] < block[a])
        return;
      next[a] += delta[a];
    }
  }

private:
  /// The cell of a place in the grid, the nearest one where rounding has left the grid.
  static int cell_of(double place, int cells) {
    return !(place > 0) ? 0 : place >= cells ? cells - 1 : static_cast<int>(place);
  }

  static void report(const trial& t, const std::array<int, 3>& at, const std::array<int, 3>& block,
                     visited& out) {
    std::array<unsigned, 3> in{};
    for (unsigned a = 0; a < 3; ++a) {
      in[a] = static_cast<unsigned>(at[a] - block[a]); // wraps below the block
      if (in[a] >= t.extent[a])
        return;
    }
    out.push(voxel_at(in[0], in[1], in[2]));
  }

  std::string_view name_;
};

} // namespace

std::unique_ptr<traversal> make_amanatides_woo(std::string_view name) {
  return std::make_unique<amanatides_woo>(name);
}

} // namespace graze::fuzz
