#pragma once
/// What is decided about a ray and a surface, and when nothing is.
#include <graze/needs_cxx20.hpp>

#include <cstdint>
#include <xmmintrin.h>

namespace graze::octree {

/// How a ray ends. Each is proven: `hit` that there is a root, and all others but `undecided` that
/// there is none. Of these, a `miss` was proven by enclosures of f alone. On the way of the others
/// there is a break of f that enclosures alone do not tell from a zero, the first of which is
///   pole  one at which f diverges, as 1/x does at 0;
///   jump  one at which f has two values beside each other, as floor(x) does at 1;
///   gap   a point at which f is not defined: a hole, as sin(x)/x has at 0, or the domain's edge.
/// The numbers are those of a picture's verdict.code.
enum class verdict : std::uint8_t { hit, miss, undecided, pole, jump, gap };

/// Proven: the ray meets no root.
[[nodiscard]] constexpr bool is_free(verdict v) {
  return v != verdict::hit && v != verdict::undecided;
}

/// Whether results are flushed to zero even within the scopes: nothing is proven then.
[[nodiscard, gnu::always_inline]] inline bool results_are_flushed() {
  constexpr unsigned flush_bits = 0x8040; // MXCSR: FTZ and DAZ
  return (_mm_getcsr() & flush_bits) != 0;
}

} // namespace graze::octree
