#pragma once
/// A walk through a grid as people write it: the next plane on each axis and the t between planes
/// are kept, and t is summed up (Amanatides and Woo, "A fast voxel traversal algorithm for ray
/// tracing", Eurographics 1987). The walk starts at the block's octant of the entry point. A
/// traversal that the shrinker does not know.
#include <cmath>
#include <graze/fuzz/traversal.hpp>
#include <limits>

namespace graze::fuzz {

class amanatides_woo final : public traversal {
public:
  [[nodiscard]] std::string_view name() const override { return "amanatides-woo"; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }

  void visit(const trial& t, visited& out) override {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double size = t.size();
    double enter = 0;
    double leave = never;
    for (int a = 0; a < 3; ++a) {
      if (t.direction[a] == 0)
        continue;
      const double near = (t.plane(a, 0) - t.origin[a]) / t.direction[a];
      const double far = (t.plane(a, t.extent[a]) - t.origin[a]) / t.direction[a];
      enter = std::max(enter, std::min(near, far));
      leave = std::min(leave, std::max(near, far));
    }
    if (!(enter <= leave))
      return;
    std::array<double, 3> next{never, never, never};
    std::array<double, 3> between{never, never, never};
    std::array<int, 3> at{};
    std::array<int, 3> step{};
    for (int a = 0; a < 3; ++a) {
      const double place = t.origin[a] + enter * t.direction[a];
      const double index = std::floor((place - t.plane(a, 0)) / size);
      if (t.direction[a] == 0 && (index < 0 || index >= t.extent[a]))
        return;
      at[a] = static_cast<int>(std::fmin(std::fmax(index, 0), t.extent[a] - 1));
      if (t.direction[a] == 0)
        continue;
      step[a] = t.direction[a] > 0 ? 1 : -1;
      const double plane = t.plane(a, 0) + (at[a] + (step[a] > 0 ? 1 : 0)) * size;
      next[a] = (plane - t.origin[a]) / t.direction[a];
      between[a] = size / std::fabs(t.direction[a]);
    }
    for (int steps = 0; steps < 16; ++steps) {
      out.push(voxel_at(static_cast<unsigned>(at[0]), static_cast<unsigned>(at[1]),
                        static_cast<unsigned>(at[2])));
      unsigned a = next[0] < next[1] ? 0 : 1;
      if (next[2] < next[a])
        a = 2;
      at[a] += step[a];
      if (step[a] == 0 || at[a] < 0 || at[a] >= t.extent[a])
        return;
      next[a] += between[a];
    }
  }
};

} // namespace graze::fuzz
