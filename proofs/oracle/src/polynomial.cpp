#include <algorithm>
#include <cassert>
#include <cmath>
#include <graze/oracle/polynomial.hpp>

namespace graze::oracle {
namespace {

/// x = integer * 2^exponent with an odd integer.
std::pair<mpz_class, long> integer_and_exponent(double x) {
  assert(std::isfinite(x));
  if (x == 0)
    return {0, 0};
  int exponent = 0;
  const auto significand = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
  const int zeros = __builtin_ctzl(static_cast<unsigned long>(significand));
  return {mpz_class(significand / (1L << zeros)), exponent - 53 + zeros};
}

mpz_class shifted(const mpz_class& x, long bits) {
  mpz_class r;
  mpz_mul_2exp(r.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  return r;
}

} // namespace

polynomial::polynomial(double value) {
  auto [integer, exponent] = integer_and_exponent(value);
  exponent_ = exponent;
  coefficients_.push_back(std::move(integer));
  trim();
}

polynomial::polynomial(const mpq_class& value) : denominator_(value.get_den()) {
  coefficients_.push_back(value.get_num());
  trim();
}

polynomial polynomial::along(double origin, double direction) {
  const polynomial o(origin);
  polynomial t(direction);
  t.coefficients_.insert(t.coefficients_.begin(), 0);
  t.trim();
  return o + t;
}

void polynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back() == 0)
    coefficients_.pop_back();
  if (coefficients_.empty()) {
    denominator_ = 1;
    exponent_ = 0;
  }
}

mpq_class polynomial::coefficient(int i) const {
  if (i < 0 || i > degree())
    return 0;
  mpz_class above = coefficients_[static_cast<unsigned>(i)], below = denominator_;
  if (exponent_ >= 0)
    above = shifted(above, exponent_);
  else
    below = shifted(below, -exponent_);
  mpq_class r(above, below);
  r.canonicalize();
  return r;
}

mpq_class polynomial::operator()(const mpq_class& t) const {
  mpq_class r = 0;
  for (int i = degree(); i >= 0; --i)
    r = r * t + coefficient(i);
  return r;
}

polynomial polynomial::derivative() const {
  polynomial r = *this;
  if (r.degree() >= 0)
    r.coefficients_.erase(r.coefficients_.begin());
  for (std::size_t i = 0; i < r.coefficients_.size(); ++i)
    r.coefficients_[i] *= static_cast<unsigned long>(i + 1);
  r.trim();
  return r;
}

polynomial polynomial::operator-() const {
  polynomial r = *this;
  for (mpz_class& c : r.coefficients_)
    mpz_neg(c.get_mpz_t(), c.get_mpz_t());
  return r;
}

polynomial operator+(const polynomial& p, const polynomial& q) {
  if (p.degree() < 0)
    return q;
  if (q.degree() < 0)
    return p;
  polynomial r;
  r.exponent_ = std::min(p.exponent_, q.exponent_);
  const bool same = p.denominator_ == q.denominator_;
  r.denominator_ = same ? p.denominator_ : mpz_class(p.denominator_ * q.denominator_);
  r.coefficients_.resize(std::max(p.coefficients_.size(), q.coefficients_.size()));
  const auto add = [&r, same](const polynomial& from, const mpz_class& other_denominator) {
    for (std::size_t i = 0; i < from.coefficients_.size(); ++i) {
      mpz_class term = shifted(from.coefficients_[i], from.exponent_ - r.exponent_);
      if (!same)
        term *= other_denominator;
      r.coefficients_[i] += term;
    }
  };
  add(p, q.denominator_);
  add(q, p.denominator_);
  r.trim();
  return r;
}

polynomial operator*(const polynomial& p, const polynomial& q) {
  polynomial r;
  if (p.degree() < 0 || q.degree() < 0)
    return r;
  r.exponent_ = p.exponent_ + q.exponent_;
  r.denominator_ = p.denominator_ * q.denominator_;
  r.coefficients_.resize(p.coefficients_.size() + q.coefficients_.size() - 1);
  for (std::size_t i = 0; i < p.coefficients_.size(); ++i)
    for (std::size_t j = 0; j < q.coefficients_.size(); ++j)
      mpz_addmul(r.coefficients_[i + j].get_mpz_t(), p.coefficients_[i].get_mpz_t(),
                 q.coefficients_[j].get_mpz_t());
  return r;
}

polynomial operator/(const polynomial& p, const polynomial& divisor) {
  assert(divisor.degree() == 0);
  return p * polynomial(mpq_class(1 / divisor.coefficient(0)));
}

} // namespace graze::oracle
