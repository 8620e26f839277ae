#pragma once
/// The loop over the pixels: tiles in parallel, the same picture for any number of threads.
#include <atomic>
#include <cstdint>
#include <functional>
#include <graze/render/image.hpp>
#include <graze/render/scene.hpp>
#include <vector>

namespace graze::render {

inline constexpr int largest_size = 16384;

/// Pixels; 1..largest_size each.
struct extent {
  int width, height;
  extent(int side) : width(side), height(side) {} // NOLINT: a number is a square
  extent(int columns, int rows) : width(columns), height(rows) {}
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  friend bool operator==(const extent&, const extent&) = default;
};

/// A part of a picture: its first column and row, and its size.
struct window {
  int column = 0, row = 0;
  extent size;
  friend bool operator==(const window&, const window&) = default;
};

/// `cast`: light, no shadow, no reflection. `trace`: shadows, and reflections of reflections.
enum class mode { cast, trace };

/// Rays follow each other through at most so many reflections.
inline constexpr int most_reflections = 5;

struct settings {
  extent size = 512;
  unsigned threads = 1; ///< at least 1
  render::mode mode = render::mode::cast;
  /// Rays a pixel, side^2 of them: side 1..16. Ray (i, j) of a pixel is that through the centre of
  /// the pixel of a picture with side times the size. What is known of a pixel beside its colour is
  /// always that of its centre.
  int sampling = 1;
  std::optional<window> crop{}; ///< within the picture; the rest is not rendered
  bool facts = false;           ///< fill rendering::facts
  bool show_gaps = false;       ///< rays that end in a pole, a jump or a gap have gap_colour
};

/// Counts over the pixels' centres, and over what else was cast.
struct tally {
  std::uint64_t pixels = 0, hits = 0, misses = 0, undecided = 0;
  std::uint64_t poles = 0, jumps = 0, gaps = 0; ///< free of roots too, and no `misses`
  std::uint64_t camera_rays = 0, shadow_rays = 0, reflected_rays = 0;
  /// Shadow rays and reflected rays that ended undecided, or were not cast since no departure was
  /// proven.
  std::uint64_t secondary_undecided = 0;
  /// No secondary ray begins further away from the point that was hit; proven. Scene length.
  double longest_shift = 0;
  octree::traversal_counts visited;

  [[nodiscard]] std::uint64_t rays() const { return camera_rays + shadow_rays + reflected_rays; }
  [[nodiscard]] double octants_a_ray() const {
    return rays() == 0 ? 0
                       : static_cast<double>(visited.cells_opened) / static_cast<double>(rays());
  }
  tally& operator+=(const tally& part);
};

/// What is seen at one pixel.
struct pixel {
  std::array<float, 3> colour; ///< linear; of a transparent scene times `alpha`
  float depth;                 ///< from the eye, in scene length; infinity where there is no root
  float alpha = 1; ///< the part of the pixel's rays that do not see a transparent background
};

/// What else is known of the ray through a pixel's centre.
struct pixel_facts {
  static constexpr int not_cast = -1; ///< a verdict of pixels that were not reached
  int verdict = not_cast;             ///< octree::verdict's number
  float depth_width = 0;              ///< of the proven enclosure of the depth, rounded up
  std::array<float, 3> normal{};      ///< unit, towards the eye's side; 0 where nothing was hit
  int object = -1;                    ///< index in scene::objects; -1 where nothing was hit
  std::uint32_t steps = 0;            ///< octants whose children were tested
  vec3 direction{};                   ///< of the ray through its centre, not of unit length
  proof proven{};
};

struct rendering {
  window part{0, 0, 1}; ///< of `whole`
  extent whole = 1;
  std::vector<pixel> pixels;      ///< of the part, row by row from the top
  std::vector<pixel_facts> facts; ///< likewise; empty if not wanted
  vec3 eye{};                     ///< the origin of all rays
  tally counts;
  double seconds = 0;
  bool complete = true; ///< false where `stop` was set before the end
};

/// Called from the calling thread about ten times a second: pixels done, pixels in all, seconds.
using progress_report = std::function<void(std::uint64_t, std::uint64_t, double)>;

/// Renders the picture. A hit is lit at the middle of its enclosure of t; a pixel whose ray is
/// undecided has undecided_colour and the depth of its t_near; a reflected ray that is undecided
/// brings undecided_colour, a shadow ray no shadow. A ray that ends in a pole, a jump or a gap sees
/// the background, as a miss does, or gap_colour. Where `stop` becomes true, tiles not yet begun
/// stay unfinished_colour.
rendering render_picture(const scene& s, const caster& surface, const settings& chosen,
                         const std::atomic<bool>* stop = nullptr,
                         const progress_report& report = {});

/// Channels R, G, B, Z, and A where `transparent`; with facts also depth.width, normal.X, normal.Y, normal.Z, object.id,
/// verdict.code, steps.octants, and what is proven: depth.lower.1 to .3, depth.upper.1 to .3 (floats
/// whose sum is the double, or beyond it where floats are too short), normal.lower.X to .Z and
/// normal.upper.X to .Z (rounded outward to floats).
picture to_picture(const rendering& result, bool transparent = false);

} // namespace graze::render
