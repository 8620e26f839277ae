#pragma once
/// The judge of the rare functions at points.
#include "rare_inputs.hpp"
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/point_rare.hpp>
#include <iomanip>
#include <sstream>

namespace graze::test {

template <class Function> point::directed judged(Function f, double x) {
  return {oracle::rounded_down(f, x), oracle::rounded_up(f, x)};
}
inline point::directed judged_power(double x, int n) {
  const auto f = [n](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) { return mpfr_pow_si(r, a, n, to); };
  return judged(f, x);
}
inline point::directed judged_root(double x, int n) {
  const auto f = [n](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) {
    return mpfr_rootn_si(r, a, n, to);
  };
  return judged(f, x);
}

inline bool same(double a, double b) { return a == b || (a != a && b != b); }
inline bool same(const bounds& a, const bounds& b) { return same(a.lo, b.lo) && same(a.hi, b.hi); }
inline bool same(const point::directed& a, const point::directed& b) {
  return same(a.down, b.down) && same(a.up, b.up);
}

/// Counts and prints the first differences.
class verdicts {
public:
  explicit verdicts(std::string name) : name_(std::move(name)) {}

  void see(double x, const point::directed& got, const point::directed& want, int n = 0) {
    if (!same(got, want))
      report({x, x}, n, {got.down, got.up}, {want.down, want.up});
  }
  void see(const bounds& x, const bounds& got, const bounds& want, int n = 0) {
    if (!same(got, want))
      report(x, n, got, want);
  }
  /// Empty if all was right.
  [[nodiscard]] std::string text() const { return text_.str(); }

private:
  void report(const bounds& x, int n, const bounds& got, const bounds& want) {
    if (++wrong_ <= 10) {
      text_ << std::hexfloat << name_ << "[" << x.lo << ", " << x.hi << "] n = " << n << ": got ["
            << got.lo << ", " << got.hi << "], MPFR [" << want.lo << ", " << want.hi << "]"
            << (want.within(got) ? " loose" : " UNSOUND") << "\n";
    }
  }
  std::string name_;
  std::ostringstream text_;
  std::size_t wrong_ = 0;
};

} // namespace graze::test
