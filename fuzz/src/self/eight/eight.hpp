#pragma once
/// interval8's operations by each path: a file a path, compiled for its instructions. Plain arrays
/// only, so that no inline function is emitted there for the linker to choose.

namespace graze::fuzz::self {

inline constexpr int eight_operations = 13, eight_predicates = 7;
struct eight_operands {
  double lo[3][8], hi[3][8];
};
struct eight_results {
  double lo[eight_operations][8], hi[eight_operations][8];
  unsigned masks[eight_predicates];
};

void eight_by_baseline(const eight_operands& o, eight_results& r);
void eight_by_portable(const eight_operands& o, eight_results& r);
void eight_by_avx2(const eight_operands& o, eight_results& r);
void eight_by_avx512(const eight_operands& o, eight_results& r);

} // namespace graze::fuzz::self
