#pragma once
/// The judge of the surface tests: formulas over MPFR, and polynomials along a line over GMP's
/// rationals whose roots Sturm's theorem counts exactly.
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cstddef>
#include <gmpxx.h>
#include <graze/octree/ray.hpp>
#include <graze/octree/surfaces.hpp>
#include <random>
#include <utility>
#include <vector>

namespace judge {

/// 600 bits: exact for the surfaces' polynomials at the points of the tests, but for the one
/// constant 139/20, which no double can meet.
using real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<180>,
                                           boost::multiprecision::et_off>;

/// A polynomial in t with rational coefficients, lowest first; no trailing zeros.
class polynomial {
public:
  polynomial() = default;
  explicit polynomial(const mpq_class& constant) : c_{constant} { trim(); }
  polynomial(const mpq_class& constant, const mpq_class& slope) : c_{constant, slope} { trim(); }

  friend polynomial operator+(const polynomial& a, const polynomial& b) { return combine(a, b, 1); }
  friend polynomial operator-(const polynomial& a, const polynomial& b) {
    return combine(a, b, -1);
  }
  friend polynomial operator*(const polynomial& a, const polynomial& b) {
    polynomial r;
    if (a.c_.empty() || b.c_.empty())
      return r;
    r.c_.assign(a.c_.size() + b.c_.size() - 1, 0);
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      for (std::size_t j = 0; j < b.c_.size(); ++j)
        r.c_[i + j] += a.c_[i] * b.c_[j];
    r.trim();
    return r;
  }

  [[nodiscard]] const std::vector<mpq_class>& coefficients() const { return c_; }

private:
  static polynomial combine(const polynomial& a, const polynomial& b, int sign) {
    polynomial r;
    r.c_.resize(std::max(a.c_.size(), b.c_.size()));
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      r.c_[i] = a.c_[i];
    for (std::size_t i = 0; i < b.c_.size(); ++i)
      r.c_[i] += b.c_[i] * sign;
    r.trim();
    return r;
  }
  void trim() {
    while (!c_.empty() && c_.back() == 0)
      c_.pop_back();
  }
  std::vector<mpq_class> c_;
};

/// Decides whether one polynomial has roots in an interval, exactly. Source: Sturm's theorem; the
/// chain is kept in integers, each member a positive multiple of the textbook's.
class root_counter {
public:
  explicit root_counter(const polynomial& p) {
    mpz_class denominator = 1;
    for (const mpq_class& c : p.coefficients())
      denominator = lcm(denominator, c.get_den());
    integers first;
    for (const mpq_class& c : p.coefficients())
      first.push_back(c.get_num() * (denominator / c.get_den()));
    integers second;
    for (std::size_t i = 1; i < first.size(); ++i)
      second.push_back(first[i] * static_cast<unsigned>(i));
    chain_.push_back(std::move(first));
    while (!second.empty()) {
      chain_.push_back(std::move(second));
      second = negated_remainder(chain_[chain_.size() - 2], chain_.back());
    }
  }
  /// p has a root in [a, b].
  [[nodiscard]] bool any_in(const mpq_class& a, const mpq_class& b) const {
    if (b < a)
      return false;
    if (sign_at(chain_[0], a) == 0 || sign_at(chain_[0], b) == 0)
      return true;
    return changes(a) != changes(b);
  }
  /// p has a root in [a, b).
  [[nodiscard]] bool any_before(const mpq_class& a, const mpq_class& b) const {
    if (!(a < b))
      return false;
    if (sign_at(chain_[0], a) == 0)
      return true;
    if (sign_at(chain_[0], b) != 0)
      return changes(a) != changes(b);
    mpq_class step = (b - a) / 2; // b is a root: close enough to it there is no other one
    while (sign_at(chain_[0], b - step) == 0 ||
           (step > (b - a) / 1e30 && changes(b - step) != changes(b - step / 2)))
      step /= 2;
    return changes(a) != changes(b - step);
  }

private:
  using integers = std::vector<mpz_class>; // coefficients, lowest first, no trailing zero

  static integers negated_remainder(integers a, const integers& b) {
    const mpz_class lead = abs(b.back());
    while (a.size() >= b.size()) {
      const mpz_class q = sgn(b.back()) < 0 ? mpz_class(-a.back()) : a.back();
      const std::size_t shift = a.size() - b.size();
      for (mpz_class& c : a)
        c *= lead;
      for (std::size_t i = 0; i < b.size(); ++i)
        a[shift + i] -= q * b[i];
      while (!a.empty() && a.back() == 0)
        a.pop_back();
    }
    mpz_class common = 0;
    for (const mpz_class& c : a)
      common = gcd(common, c);
    for (mpz_class& c : a)
      c = -c / common;
    return a;
  }
  /// The sign of sum c_i p^i q^(n-i), which is that at p / q, q > 0.
  static int sign_at(const integers& c, const mpq_class& t) {
    mpz_class v = 0, scale = 1;
    for (std::size_t i = c.size(); i-- > 0; scale *= t.get_den())
      v = v * t.get_num() + c[i] * scale;
    return sgn(v);
  }
  [[nodiscard]] int changes(const mpq_class& t) const {
    int last = 0, count = 0;
    for (const integers& p : chain_) {
      const int s = sign_at(p, t);
      if (s != 0 && last != 0 && s != last)
        ++count;
      if (s != 0)
        last = s;
    }
    return count;
  }

  std::vector<integers> chain_;
};

/// The surface along a ray as polynomials: its zeros are theirs (for the union of spheres, seen
/// from outside, the first zero is the first of all nine).
template <class F> std::vector<root_counter> along(const F& f, const graze::octree::ray& r) {
  std::array<polynomial, 3> p;
  for (int a = 0; a < 3; ++a)
    p[a] = polynomial(mpq_class(r.origin()[a]), mpq_class(r.direction()[a]));
  std::vector<root_counter> out;
  if constexpr (std::is_same_v<F, graze::octree::spheres>)
    for (const auto& s : f.parts)
      out.emplace_back(f.part(s, p[0], p[1], p[2]));
  else
    out.emplace_back(f(p[0], p[1], p[2]));
  return out;
}

} // namespace judge

template <> struct graze::octree::constants<judge::polynomial> {
  template <std::int64_t P, std::int64_t Q> static judge::polynomial rational() {
    return judge::polynomial(mpq_class(static_cast<long>(P)) / mpq_class(static_cast<long>(Q)));
  }
  static judge::polynomial exact(double x) { return judge::polynomial(mpq_class(x)); }
};

namespace judge {
/// The exact sign of f at a point.
template <class F> int sign_at(const F& f, const graze::octree::vec3& p) {
  const real v = f(real(p[0]), real(p[1]), real(p[2]));
  return v.sign();
}

struct random_source {
  std::mt19937_64 engine;
  explicit random_source(std::uint64_t seed) : engine(seed) {}
  double in(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine); }
  unsigned below(unsigned n) { return static_cast<unsigned>(engine() % n); }
};
} // namespace judge
