#pragma once
/// The eight lanes of sound_eight, one path a file (lanes.cpp): what they say of a line. Plain
/// data, so that a file compiled for a path's instructions emits nothing that others could be
/// linked to.
#include <array>
#include <cstdint>
#include <graze/octree/ray.hpp>
#include <span>

namespace graze::tie {

struct lane_question {
  char kind;
  std::array<double, 3> lo, mid;
  double size;
  std::array<double, 3> enter, leave; ///< within<closed>(lo, hi) on each axis
};

/// [0] closed, [1] owned.
struct lane_answer {
  double leave[2][3], minus_enter[2][3]; ///< at the mid-planes
  unsigned children[2], origin_side[2];
  bool entered[2]; ///< of c and t, as what follows
  unsigned count[2];
  std::uint8_t order[2][8];
  unsigned visited[2];
  std::uint64_t visits[2];
};

struct lane_path {
  const char* name;
  bool (*runs_here)();
  bool clears_flushing;
  void (*ask)(const octree::ray&, const lane_question&, lane_answer&);
};

#if defined(GRAZE_TIE_LANES)
extern const lane_path portable_path, baseline_path, avx2_path, avx512_path;
inline constexpr const lane_path* lane_paths[] = {
#if defined(GRAZE_TIE_ONE_PATH)
    &baseline_path,
#else
    &portable_path,
#if defined(__x86_64__)
    &baseline_path,
    &avx2_path,
    &avx512_path,
#endif
#endif
};
#else
inline constexpr std::span<const lane_path* const> lane_paths;
#endif

} // namespace graze::tie
