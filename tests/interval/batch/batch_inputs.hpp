#pragma once
/// Inputs and comparisons for the tests of batches.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <graze/batch.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <limits>
#include <string>
#include <vector>

namespace graze::test {

using oracle::hard_intervals;
using oracle::hard_operands;
using oracle::hardness;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Inputs an operation: 10^5, or what the environment variable GRAZE_TEST_INPUTS says.
inline std::size_t input_count() {
  const char* text = std::getenv("GRAZE_TEST_INPUTS");
  return text == nullptr ? 100'000 : std::strtoull(text, nullptr, 10);
}

/// The path is in use while it lives. What cannot run here is said, and counts as skipped (see
/// graze_test in cmake/graze_target.cmake).
class forced {
public:
  explicit forced(batch::path p) : reason_(batch::force_path(p)) {
    if (reason_)
      std::printf("graze: skipped, path %s: %s\n", batch::name(p), reason_->c_str());
  }
  ~forced() { batch::unforce_path(); }
  forced(const forced&) = delete;
  forced& operator=(const forced&) = delete;
  [[nodiscard]] bool runs() const { return !reason_; }

private:
  std::optional<std::string> reason_;
};

struct arrays {
  std::vector<double> lo, hi;
  explicit arrays(std::size_t n) : lo(n), hi(n) {}
  [[nodiscard]] std::size_t size() const { return lo.size(); }
  [[nodiscard]] bounds operator[](std::size_t i) const { return {lo[i], hi[i]}; }
  void set(std::size_t i, bounds b) { lo[i] = b.lo, hi[i] = b.hi; }
  operator batch::const_intervals() const { return {lo, hi}; }
  operator batch::intervals() { return {lo, hi}; }
};

/// The same bits, any NaN being like any other.
inline bool same_bits(double x, double y) {
  return x != x ? y != y : std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}
inline bool same_bits(const bounds& x, const bounds& y) {
  return same_bits(x.lo, y.lo) && same_bits(x.hi, y.hi);
}
/// The same set: zeros of either sign are one.
inline bool same_set(const bounds& x, const bounds& y) {
  return x.is_empty() ? y.lo != y.lo && y.hi != y.hi : x.lo == y.lo && x.hi == y.hi;
}

inline std::string text(const bounds& x) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "[%a, %a]", x.lo, x.hi);
  return buffer;
}

/// What differs, the first few times.
class differences {
public:
  void add(const char* operation, const bounds& x, const bounds& y, const bounds& z,
           const bounds& got, const bounds& expected) {
    if (++count_ <= 5) // at once: Catch forgets messages at the next assertion
      std::printf("%s of %s, %s, %s gives %s, expected %s\n", operation, text(x).c_str(),
                  text(y).c_str(), text(z).c_str(), text(got).c_str(), text(expected).c_str());
  }
  [[nodiscard]] long count() const { return count_; }

private:
  long count_ = 0;
};

} // namespace graze::test
