#pragma once
/// How many inputs an operation a property test takes: GRAZE_TEST_INPUTS, or 100000.
#include <cstdlib>

namespace graze::test {

inline long input_count() {
  const char* text = std::getenv("GRAZE_TEST_INPUTS");
  const long count = text ? std::strtol(text, nullptr, 10) : 0;
  return count > 0 ? count : 100'000;
}

} // namespace graze::test
