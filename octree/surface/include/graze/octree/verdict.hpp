#pragma once
/// What is decided about a ray and a surface, and when nothing is.
#include <graze/needs_cxx20.hpp>

#include <cstdint>
#include <xmmintrin.h>

namespace graze::octree {

/// How a ray ends. Each is proven: `hit` that there is a root, `miss` that there is none.
enum class verdict : std::uint8_t { hit, miss, undecided };

/// Whether results are flushed to zero even within the scopes: nothing is proven then.
[[nodiscard, gnu::always_inline]] inline bool results_are_flushed() {
  constexpr unsigned flush_bits = 0x8040; // MXCSR: FTZ and DAZ
  return (_mm_getcsr() & flush_bits) != 0;
}

} // namespace graze::octree
