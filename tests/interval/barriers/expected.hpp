#pragma once
/// The bounds that MPFR found for the snippets, in their order. Another translation unit, so that
/// nothing knows them at compile time.
#include <cstddef>

namespace graze::barriers {

struct bounds {
  double lower, upper;
};
extern const bounds expected[];
extern const std::size_t expected_count;

} // namespace graze::barriers
