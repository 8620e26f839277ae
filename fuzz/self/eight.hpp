#pragma once
/// interval8's operations on each path. Plain arrays only, so that no inline function is emitted in a
/// path's object for the linker to choose.
#include <graze/batch/per_path.hpp>

namespace graze::fuzz::self {

inline constexpr int eight_operations = 13, eight_predicates = 7;
struct eight_operands {
  double lo[3][8], hi[3][8];
};
struct eight_results {
  double lo[eight_operations][8], hi[eight_operations][8];
  unsigned masks[eight_predicates];
};

using eight_kernel = void (*)(const eight_operands& o, eight_results& r);
GRAZE_DECLARE_ON_PATHS(eight_kernel, evaluate_eight);
extern const eight_kernel evaluate_eight_portable;

} // namespace graze::fuzz::self
