#pragma once
/// Polynomials in one variable with integer coefficients, lowest first, the last not 0; none for 0.
#include "exact_number.hpp"

#include <optional>
#include <vector>

namespace graze::octree::tape {

using integer_polynomial = std::vector<integer>;

/// Divides by what all coefficients share; the leading one becomes positive if `normal`.
void divide_content(integer_polynomial& p, bool normal = false);
integer_polynomial derivative_of(const integer_polynomial& p);
/// p / q where q, primitive and not 0, divides p.
std::optional<integer_polynomial> quotient_of(const integer_polynomial& p,
                                              const integer_polynomial& q);
/// The greatest common divisor, primitive, its leading coefficient positive; p and q not 0. By its images
/// modulo primes, and then by division, which decides. Nothing where that takes more than `most_primes`.
std::optional<integer_polynomial> greatest_common_divisor(const integer_polynomial& p,
                                                          const integer_polynomial& q,
                                                          int most_primes = 4000);

/// p's roots, all of them simple, and gcd(p, p'), whose roots are the multiple ones.
struct square_free_part {
  integer_polynomial part, repeated;
};
std::optional<square_free_part> square_free(integer_polynomial p);

/// The sign of p(x).
int sign_at(const integer_polynomial& p, const rational& x);
/// A positive multiple of p(from + s (to - from)), a polynomial in s.
integer_polynomial on_interval(const integer_polynomial& p, const rational& from,
                               const rational& to);

} // namespace graze::octree::tape
