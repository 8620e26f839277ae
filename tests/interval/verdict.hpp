#pragma once
/// Counts how many results are the tightest enclosures that MPFR gives, and keeps the first that
/// are not.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <graze/bounds.hpp>
#include <string>

namespace graze::test {

/// How many inputs an operation gets: GRAZE_TEST_INPUTS, 100,000 if unset.
inline int inputs_per_operation() {
  const char* given = std::getenv("GRAZE_TEST_INPUTS");
  return given ? std::max(std::atoi(given), 1) : 100000;
}

/// Says that a test had nothing to run on: ctest counts it as skipped (cmake/graze_target.cmake).
inline void skipped(const char* why) { std::printf("graze: skipped, %s\n", why); }

/// "0x1.8p+0".
inline std::string hexadecimal(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

/// "exp(0x1.8p+0)", for a message.
template <class... Doubles> std::string call(const char* name, Doubles... x) {
  std::string text = std::string(name) + "(";
  const char* comma = "";
  ((text += comma, text += hexadecimal(x), comma = ", "), ...);
  return text + ")";
}

inline bool same(double a, double b) { return a == b || (a != a && b != b); }
inline bool same(const bounds& a, const bounds& b) { return same(a.lo, b.lo) && same(a.hi, b.hi); }

class verdict {
public:
  /// name(x...), where x are doubles, should be `expected`.
  template <class... Doubles>
  void judge(const char* name, const bounds& expected, const bounds& got, Doubles... x) {
    ++inputs_;
    if (same(expected, got))
      return;
    const bool sound = expected.within(got);
    ++(sound ? loose_ : unsound_);
    if (loose_ + unsound_ <= 5)
      first_ += call(name, x...) + (sound ? ": loose, [" : ": unsound, [") + hexadecimal(got.lo) +
                ", " + hexadecimal(got.hi) + "] instead of [" + hexadecimal(expected.lo) + ", " +
                hexadecimal(expected.hi) + "]\n";
  }
  void check() const {
    INFO(first_);
    CHECK(unsound_ == 0);
    CHECK(loose_ == 0);
    CHECK(inputs_ > 0);
  }

private:
  long inputs_ = 0, unsound_ = 0, loose_ = 0;
  std::string first_;
};

} // namespace graze::test
