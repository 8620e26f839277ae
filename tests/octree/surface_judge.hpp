#pragma once
/// The judge of the surface tests: formulas over MPFR, and polynomials along a line over GMP's rationals
/// whose roots Sturm's theorem counts exactly.
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

/// 600 bits: exact for the surfaces' polynomials at the points of the tests, but for the one constant
/// 139/20, which no double can meet.
using real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<180>,
                                           boost::multiprecision::et_off>;

/// A polynomial in t with rational coefficients, lowest first; no trailing zeros.
class polynomial {
public:
  polynomial() = default;
  explicit polynomial(const mpq_class& constant) : c_{constant} { trim(); }
  polynomial(const mpq_class& constant, const mpq_class& slope) : c_{constant, slope} { trim(); }

  friend polynomial operator+(const polynomial& a, const polynomial& b) { return combine(a, b, 1); }
  friend polynomial operator-(const polynomial& a, const polynomial& b) { return combine(a, b, -1); }
  friend polynomial operator*(const polynomial& a, const polynomial& b) {
    polynomial r;
    if (a.c_.empty() || b.c_.empty()) return r;
    r.c_.assign(a.c_.size() + b.c_.size() - 1, 0);
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      for (std::size_t j = 0; j < b.c_.size(); ++j) r.c_[i + j] += a.c_[i] * b.c_[j];
    r.trim();
    return r;
  }

  [[nodiscard]] bool zero() const { return c_.empty(); }
  [[nodiscard]] int sign_at(const mpq_class& t) const {
    mpq_class v = 0;
    for (std::size_t i = c_.size(); i-- > 0;) v = v * t + c_[i];
    return sgn(v);
  }
  [[nodiscard]] polynomial derivative() const {
    polynomial r;
    for (std::size_t i = 1; i < c_.size(); ++i) r.c_.push_back(c_[i] * static_cast<unsigned>(i));
    r.trim();
    return r;
  }
  /// -(a mod b), each scaled by a positive number as is fit for a Sturm chain.
  static polynomial negated_remainder(polynomial a, const polynomial& b) {
    while (a.c_.size() >= b.c_.size()) {
      const mpq_class q = a.c_.back() / b.c_.back();
      const std::size_t shift = a.c_.size() - b.c_.size();
      for (std::size_t i = 0; i < b.c_.size(); ++i) a.c_[shift + i] -= q * b.c_[i];
      a.c_.back() = 0; // by construction
      a.trim();
    }
    for (mpq_class& c : a.c_) c = -c;
    return a;
  }

private:
  static polynomial combine(const polynomial& a, const polynomial& b, int sign) {
    polynomial r;
    r.c_.resize(std::max(a.c_.size(), b.c_.size()));
    for (std::size_t i = 0; i < a.c_.size(); ++i) r.c_[i] = a.c_[i];
    for (std::size_t i = 0; i < b.c_.size(); ++i) r.c_[i] += b.c_[i] * sign;
    r.trim();
    return r;
  }
  void trim() {
    while (!c_.empty() && c_.back() == 0) c_.pop_back();
  }
  std::vector<mpq_class> c_;
};

/// Counts the distinct real roots of one polynomial in closed intervals. Source: Sturm's theorem; it holds
/// for multiple roots too, as long as the ends are no roots, which are therefore looked at first.
class root_counter {
public:
  explicit root_counter(const polynomial& p) {
    chain_.push_back(p);
    if (p.zero()) return;
    chain_.push_back(p.derivative());
    while (!chain_.back().zero())
      chain_.push_back(polynomial::negated_remainder(chain_[chain_.size() - 2], chain_.back()));
    chain_.pop_back();
  }
  /// p has a root in [a, b].
  [[nodiscard]] bool any_in(const mpq_class& a, const mpq_class& b) const {
    if (b < a) return false;
    if (chain_[0].sign_at(a) == 0 || chain_[0].sign_at(b) == 0) return true;
    return changes(a) != changes(b);
  }
  /// p has a root in [a, b).
  [[nodiscard]] bool any_before(const mpq_class& a, const mpq_class& b) const {
    if (!(a < b)) return false;
    if (chain_[0].sign_at(a) == 0) return true;
    // Sturm counts the roots in (a, b], also where b is one (of a square-free chain, and for multiple
    // roots after division by the common factor, which changes no count of sign changes elsewhere).
    const bool root_at_end = chain_[0].sign_at(b) == 0;
    return changes(a) - changes(b) > (root_at_end ? 1 : 0);
  }

private:
  [[nodiscard]] int changes(const mpq_class& t) const {
    int last = 0, count = 0;
    for (const polynomial& p : chain_) {
      const int s = p.sign_at(t);
      if (s != 0 && last != 0 && s != last) ++count;
      if (s != 0) last = s;
    }
    return count;
  }
  std::vector<polynomial> chain_;
};

/// The surface along a ray as polynomials: its zeros are theirs (for the union of spheres, seen from
/// outside, the first zero is the first of all nine).
template <class F>
std::vector<root_counter> along(const F& f, const graze::octree::ray& r) {
  std::array<polynomial, 3> p;
  for (int a = 0; a < 3; ++a) p[a] = polynomial(mpq_class(r.origin()[a]), mpq_class(r.direction()[a]));
  std::vector<root_counter> out;
  if constexpr (std::is_same_v<F, graze::octree::spheres>)
    for (const auto& s : f.parts) out.emplace_back(f.part(s, p[0], p[1], p[2]));
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
