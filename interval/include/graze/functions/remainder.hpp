#pragma once
/// The remainder of a division, as C's fmod has it. Not an operation of IEEE 1788.1, hence without
/// a decoration. Error: 0 ulp per endpoint. Defined in interval/src/functions/remainder.cpp.
#include <graze/needs_cxx20.hpp>

#include <graze/bounds.hpp>

namespace graze::functions {

/// x - trunc(x / y) y, where y != 0: of x's sign, less than |y|.
struct fmod {
  static bounds value(bounds x, bounds y);
};

} // namespace graze::functions
