#pragma once
/// Polynomials in one variable with exact rational coefficients: a number type on which a surface's
/// formula f(x,y,z) can be evaluated along a ray, x = ox + t dx and so on, to give g(t) = f
/// exactly.
#include <gmpxx.h>
#include <graze/oracle/geometry.hpp>
#include <type_traits>
#include <vector>

namespace graze::oracle {

/// (c[0] + c[1] t + ...) 2^exponent / denominator. Constants convert implicitly; a double stands
/// for its exact value (11.8 is the double next to 11.8), so a decimal wants mpq_class("118/10").
class polynomial {
public:
  polynomial() = default; ///< 0
  polynomial(double value);
  polynomial(const mpq_class& value);
  template <class Integer>
    requires std::is_integral_v<Integer>
  polynomial(Integer value) : polynomial(mpq_class(value)) {}

  /// origin + t direction
  static polynomial along(double origin, double direction);

  /// -1 for the polynomial 0.
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  [[nodiscard]] mpq_class coefficient(int i) const;
  /// A positive multiple of this with integer coefficients.
  [[nodiscard]] const std::vector<mpz_class>& integer_coefficients() const { return coefficients_; }
  [[nodiscard]] mpq_class operator()(const mpq_class& t) const;
  [[nodiscard]] polynomial derivative() const;

  polynomial operator-() const;
  friend polynomial operator+(const polynomial& p, const polynomial& q);
  friend polynomial operator-(const polynomial& p, const polynomial& q) { return p + -q; }
  friend polynomial operator*(const polynomial& p, const polynomial& q);
  /// divisor: a constant other than 0.
  friend polynomial operator/(const polynomial& p, const polynomial& divisor);
  polynomial& operator+=(const polynomial& q) { return *this = *this + q; }
  polynomial& operator-=(const polynomial& q) { return *this = *this - q; }
  polynomial& operator*=(const polynomial& q) { return *this = *this * q; }

  friend bool operator==(const polynomial& p, const polynomial& q) { return (p - q).degree() < 0; }

private:
  void trim();

  std::vector<mpz_class> coefficients_; // the last is not 0
  mpz_class denominator_ = 1;           // positive
  long exponent_ = 0;
};

inline polynomial sqr(const polynomial& p) { return p * p; }

/// x(t), y(t), z(t) of the ray {origin + t direction}.
inline std::array<polynomial, 3> along(const point& origin, const point& direction) {
  return {polynomial::along(origin[0], direction[0]), polynomial::along(origin[1], direction[1]),
          polynomial::along(origin[2], direction[2])};
}

} // namespace graze::oracle
