#pragma once
/// Inputs and comparisons for the tests of batches.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <graze/batch.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <limits>
#include <string>
#include <vector>

namespace graze::test {

using oracle::hard_operands;
using oracle::hardness;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Inputs an operation: 10^5, or what the environment variable GRAZE_TEST_INPUTS says.
inline std::size_t input_count() {
  const char* asked = std::getenv("GRAZE_TEST_INPUTS");
  return asked == nullptr ? 100'000 : std::strtoull(asked, nullptr, 10);
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

/// Intervals that are hard in the ways of hard_operands: half of them from correlated ends, the
/// rest points, one ulp wide, touching zero of either sign, holding it inside, unbounded, entire,
/// empty.
class hard_intervals {
public:
  explicit hard_intervals(std::uint64_t seed) : make_(seed) {}

  /// Operands made for each other: ends of both come from the same pairs.
  void next(bounds& x, bounds& y, bounds& z) {
    const auto [p, q] = make_.next(kind());
    const auto [r, s] = make_.next(kind());
    const auto [t, u] = make_.next(kind());
    x = of(p, make_.coin() ? r : t);
    y = of(q, s);
    z = of(t, make_.coin() ? -p * q : u); // x y + z cancels now and then
  }

  /// For polynomials: near the ends of [-3, 3], wide or thin.
  bounds moderate() {
    const double p = static_cast<double>(make_.below(1 << 20)) * 0x1p-19 * 3 - 3;
    const double w = std::ldexp(static_cast<double>(make_.below(1 << 20)),
                                -20 - static_cast<int>(make_.below(54)));
    return make_.below(100) == 0   ? bounds::empty()
           : make_.below(100) == 0 ? bounds::entire()
                                   : bounds{p, p + w};
  }

private:
  hardness kind() {
    return static_cast<hardness>(make_.below(static_cast<std::uint64_t>(hardness::count)));
  }
  bounds of(double p, double q) {
    switch (make_.below(10)) {
    case 0:
      q = p;
      break;
    case 1:
      q = hard_operands::step(p, 1);
      break;
    case 2:
      q = make_.coin() ? 0.0 : -0.0;
      break;
    case 3:
      q = make_.coin() ? infinity : -infinity;
      break;
    case 4:
      p = make_.coin() ? 0.0 : -0.0;
      q = make_.coin() ? p : -p;
      break;
    case 5:
      q = -q;
      break;
    default:
      break;
    }
    const std::uint64_t rare = make_.below(64);
    if (rare == 0)
      return bounds::entire();
    const double lo = std::min(p, q), hi = std::max(p, q);
    if (rare == 1 || p != p || q != q || lo == infinity || hi == -infinity)
      return bounds::empty();
    // min and max take either of two zeros
    return {lo == 0 && hi == 0 ? p : lo, lo == 0 && hi == 0 ? q : hi};
  }

  hard_operands make_;
};

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
