// Arithmetic of integer polynomials; von zur Gathen and Gerhard, Modern Computer Algebra, 6.7.
#include "integer_polynomial.hpp"

#include <algorithm>
#include <cstdint>

namespace graze::octree::tape {
namespace {

using residues = std::vector<std::uint64_t>; // as integer_polynomial

std::uint64_t power_modulo(std::uint64_t x, std::uint64_t n, std::uint64_t p) {
  std::uint64_t r = 1;
  for (; n != 0; n >>= 1, x = x * x % p)
    if ((n & 1) != 0)
      r = r * x % p;
  return r;
}
/// Odd, and below 3,215,031,751, up to which the strong tests to these bases decide (Jaeschke, 1993).
bool is_prime(std::uint64_t n) {
  for (const std::uint64_t base : {2, 3, 5, 7}) {
    std::uint64_t odd = n - 1;
    while (odd % 2 == 0)
      odd /= 2;
    std::uint64_t x = power_modulo(base, odd, n);
    bool passed = x == 1;
    for (; !passed && odd < n - 1; odd *= 2, x = x * x % n)
      passed = x == n - 1;
    if (!passed)
      return false;
  }
  return true;
}
std::uint64_t inverse_modulo(std::uint64_t x, std::uint64_t p) { return power_modulo(x, p - 2, p); }

std::uint64_t residue(const integer& x, std::uint64_t p) {
  const integer rest = x % p; // of the sign of x
  return rest.sign() < 0 ? p - integer(-rest).convert_to<std::uint64_t>()
                         : rest.convert_to<std::uint64_t>();
}
residues residues_of(const integer_polynomial& f, std::uint64_t p) {
  residues r;
  for (const integer& c : f)
    r.push_back(residue(c, p));
  return r;
}

/// Monic.
residues divisor_modulo(residues f, residues g, std::uint64_t p) {
  const auto trim = [](residues& x) {
    while (!x.empty() && x.back() == 0)
      x.pop_back();
  };
  trim(f);
  trim(g);
  while (!g.empty()) {
    const std::uint64_t inverse = inverse_modulo(g.back(), p);
    while (f.size() >= g.size()) {
      const std::uint64_t factor = p - f.back() * inverse % p;
      const std::size_t shift = f.size() - g.size();
      for (std::size_t i = 0; i < g.size(); ++i)
        f[i + shift] = (f[i + shift] + factor * g[i]) % p;
      trim(f);
      if (f.empty())
        break;
    }
    f.swap(g);
  }
  const std::uint64_t inverse = inverse_modulo(f.back(), p);
  for (std::uint64_t& c : f)
    c = c * inverse % p;
  return f;
}

} // namespace

void divide_content(integer_polynomial& p, bool normal) {
  integer content(0);
  for (const integer& c : p) {
    if (content == 1)
      break;
    content = gcd(content, c);
  }
  if (p.empty())
    return;
  if (normal && p.back().sign() < 0)
    content = -content;
  if (content != 1)
    for (integer& c : p)
      c /= content;
}

integer_polynomial derivative_of(const integer_polynomial& p) {
  integer_polynomial r;
  for (std::size_t i = 1; i < p.size(); ++i)
    r.push_back(p[i] * static_cast<std::uint64_t>(i));
  return r;
}

std::optional<integer_polynomial> quotient_of(const integer_polynomial& p,
                                              const integer_polynomial& q) {
  if (p.size() < q.size())
    return p.empty() ? std::optional(p) : std::nullopt;
  integer_polynomial rest = p, r(p.size() - q.size() + 1);
  for (std::size_t k = r.size(); k-- > 0;) {
    integer remainder;
    divide_qr(rest[k + q.size() - 1], q.back(), r[k], remainder);
    if (!remainder.is_zero())
      return std::nullopt;
    if (!r[k].is_zero())
      for (std::size_t i = 0; i < q.size(); ++i)
        rest[k + i] -= r[k] * q[i];
  }
  if (std::all_of(rest.begin(), rest.end(), [](const integer& c) { return c.is_zero(); }))
    return r;
  return std::nullopt;
}

std::optional<integer_polynomial>
greatest_common_divisor(const integer_polynomial& p, const integer_polynomial& q, int most_primes) {
  integer_polynomial f = p, g = q;
  divide_content(f);
  divide_content(g);
  const integer leading = gcd(f.back(), g.back());
  integer_polynomial lifted; // leading * gcd, modulo `modulus`, in (-modulus/2, modulus/2]
  integer modulus(1);
  std::uint64_t prime = (std::uint64_t{1} << 31) - 1;
  for (int primes = 0; primes < most_primes; prime -= 2) {
    if (!is_prime(prime))
      continue;
    ++primes;
    const std::uint64_t scale = residue(leading, prime);
    if (scale == 0)
      continue;
    const residues image = divisor_modulo(residues_of(f, prime), residues_of(g, prime), prime);
    if (image.size() == 1)
      return integer_polynomial{integer(1)};
    if (!lifted.empty() && image.size() > lifted.size())
      continue; // the prime is an unlucky one
    bool same = image.size() == lifted.size();
    if (!same) {
      lifted.assign(image.size(), integer(0));
      modulus = 1;
    }
    const std::uint64_t inverse = inverse_modulo(residue(modulus, prime), prime);
    const integer next = modulus * prime, half = next / 2;
    for (std::size_t i = 0; i < image.size(); ++i) {
      const std::uint64_t target = image[i] * scale % prime;
      const std::uint64_t more = (target + prime - residue(lifted[i], prime)) % prime;
      if (more == 0)
        continue;
      same = false;
      lifted[i] += modulus * (more * inverse % prime);
      if (lifted[i] > half)
        lifted[i] -= next;
    }
    modulus = next;
    if (!same)
      continue;
    integer_polynomial divisor = lifted;
    divide_content(divisor, true);
    if (quotient_of(f, divisor) && quotient_of(g, divisor))
      return divisor;
  }
  return std::nullopt;
}

std::optional<square_free_part> square_free(integer_polynomial p) {
  divide_content(p);
  if (p.size() <= 2)
    return square_free_part{p, {integer(1)}};
  auto repeated = greatest_common_divisor(p, derivative_of(p));
  if (!repeated)
    return std::nullopt;
  if (repeated->size() > 1)
    p = *quotient_of(p, *repeated);
  return square_free_part{std::move(p), *std::move(repeated)};
}

int sign_at(const integer_polynomial& p, const rational& x) {
  const integer above = numerator_of(x), below = denominator_of(x);
  integer value(0), scale(1);
  for (std::size_t i = p.size(); i-- > 0;) {
    value = value * above + p[i] * scale;
    scale *= below;
  }
  return value.sign();
}

integer_polynomial on_interval(const integer_polynomial& p, const rational& from,
                               const rational& to) {
  // (a + b s) / c
  const integer c = lcm(denominator_of(from), denominator_of(to));
  const integer a = numerator_of(from) * (c / denominator_of(from)),
                b = numerator_of(to) * (c / denominator_of(to)) - a;
  integer_polynomial r = p;
  integer scale(1);
  for (std::size_t i = r.size(); i-- > 0; scale *= c)
    r[i] *= scale;
  for (std::size_t j = 1; j < r.size(); ++j)
    for (std::size_t i = r.size() - 1; i-- >= j;) // by Horner's rule, in place
      r[i] += r[i + 1] * a;
  scale = 1;
  for (integer& x : r) {
    x *= scale;
    scale *= b;
  }
  return r;
}

} // namespace graze::octree::tape
