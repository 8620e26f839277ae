#pragma once
/// The loop over the pixels: tiles in parallel, the same picture for any number of threads.
#include <atomic>
#include <cstdint>
#include <functional>
#include <graze/render/image.hpp>
#include <graze/render/scene.hpp>
#include <vector>

namespace graze::render {

struct settings {
  int size = 512;       ///< pixels a side, 1..largest_size
  unsigned threads = 1; ///< at least 1
};
inline constexpr int largest_size = 16384;

/// Counts over all rays that were cast.
struct tally {
  std::uint64_t rays = 0, hits = 0, misses = 0, undecided = 0;
  octree::traversal_counts visited;

  [[nodiscard]] double octants_a_ray() const {
    return rays == 0 ? 0 : static_cast<double>(visited.cells_opened) / static_cast<double>(rays);
  }
};

/// What is known of one pixel.
struct pixel {
  std::array<float, 3> colour; ///< linear
  float depth;                 ///< from the eye, in scene length; infinity where nothing was hit
};

struct rendering {
  int size = 0;
  std::vector<pixel> pixels; ///< row by row from the top
  tally counts;
  double seconds = 0;
  bool complete = true; ///< false where `stop` was set before the end
};

/// Called from the calling thread about ten times a second: rays cast, rays in all, seconds.
using progress_report = std::function<void(std::uint64_t, std::uint64_t, double)>;

/// Casts one ray a pixel. A hit is lit at the middle of its enclosure of t; an undecided pixel has
/// undecided_colour and the depth of its t_near. Where `stop` becomes true, tiles not yet begun
/// stay unfinished_colour.
rendering cast(const scene& s, const caster& work, const settings& how,
               const std::atomic<bool>* stop = nullptr, const progress_report& report = {});

/// Channels R, G, B and Z of the rendering.
picture to_picture(const rendering& result);

} // namespace graze::render
