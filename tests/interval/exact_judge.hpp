#pragma once
/// What the tests of sums, text and widths judge with: GMP's rationals.
#include <cmath>
#include <cstdlib>
#include <gmpxx.h>
#include <graze/bounds.hpp>
#include <graze/oracle/elementary.hpp>
#include <limits>

namespace graze::test {

/// How many inputs an operation gets: GRAZE_TEST_INPUTS, else 100000.
inline int inputs() {
  const char* text = std::getenv("GRAZE_TEST_INPUTS");
  return text == nullptr ? 100000 : std::atoi(text);
}

/// Of a finite double: exact.
inline mpq_class rational(double x) { return mpq_class(x); }

inline double rounded(const mpq_class& q, mpfr_rnd_t to) {
  return oracle::rounded(
      [&](mpfr_ptr result, mpfr_rnd_t mode) { return mpfr_set_q(result, q.get_mpq_t(), mode); },
      to);
}
/// The tightest bounds of [lower, upper].
inline bounds enclosure(const mpq_class& lower, const mpq_class& upper) {
  return {rounded(lower, MPFR_RNDD), rounded(upper, MPFR_RNDU)};
}

/// Both empty, or the same bounds (the sign of a zero apart).
inline bool same(const bounds& x, const bounds& y) {
  return x.is_empty() ? y.is_empty() : x.lo == y.lo && x.hi == y.hi;
}

} // namespace graze::test
