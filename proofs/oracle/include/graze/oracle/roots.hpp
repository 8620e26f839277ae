#pragma once
/// Exact real roots of polynomials: how many, and where the first one along a ray is.
#include <graze/oracle/polynomial.hpp>
#include <optional>

namespace graze::oracle {

/// The distinct real roots of a polynomial other than 0, counted by Sturm's theorem on its
/// square-free part.
class root_counter {
public:
  explicit root_counter(const polynomial& g);

  /// The number of distinct roots t with from < t <= to.
  [[nodiscard]] int roots_between(const mpq_class& from, const mpq_class& to) const {
    return from < to ? changes_at(from) - changes_at(to) : 0;
  }
  /// The number of distinct real roots, and of distinct roots t > 0.
  [[nodiscard]] int roots() const { return changes_at_infinity(-1) - changes_at_infinity(1); }
  [[nodiscard]] int positive_roots() const;

  /// Sign changes of Sturm's sequence at t, and at t = -infinity or +infinity.
  [[nodiscard]] int changes_at(const mpq_class& t) const;
  [[nodiscard]] int changes_at_infinity(int sign) const;

  using integers = std::vector<mpz_class>; ///< coefficients, lowest first
  /// The square-free part: the same roots, all of them simple.
  [[nodiscard]] const integers& square_free() const { return sequence_.front(); }
  /// gcd(g, g'): its roots are the multiple ones.
  [[nodiscard]] const integers& repeated() const { return repeated_; }

private:
  std::vector<integers> sequence_;
  integers repeated_;
};

/// lo <= the root <= hi; lo = hi where it is a rational that was met exactly.
struct root {
  mpq_class lo, hi;
  int multiplicity; ///< odd: g changes its sign; even: it does not; 0: g is 0 everywhere
};

/// The least root t >= 0 of g, to hi - lo <= 2^-bits; nothing where there is none. No other root of
/// g lies in [0, hi]. For g = 0 it is 0, of multiplicity 0.
std::optional<root> first_root(const polynomial& g, int bits = 200);
/// The same for from <= t <= to; [lo, hi] lies within [from, to].
std::optional<root> first_root(const polynomial& g, const mpq_class& from, const mpq_class& to,
                               int bits = 200);

/// The largest double <= x, -infinity where there is none.
double double_below(const mpq_class& x);
/// The least double >= x, +infinity where there is none.
double double_above(const mpq_class& x);

} // namespace graze::oracle
