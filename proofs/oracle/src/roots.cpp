#include <algorithm>
#include <cassert>
#include <cmath>
#include <graze/oracle/roots.hpp>
#include <limits>

namespace graze::oracle {
namespace {

using integers = root_counter::integers;

int degree(const integers& p) { return static_cast<int>(p.size()) - 1; }

/// Divides by the greatest common divisor of the coefficients; signs stay.
void make_primitive(integers& p) {
  mpz_class content = 0;
  for (auto c = p.rbegin(); c != p.rend() && content != 1; ++c)
    mpz_gcd(content.get_mpz_t(), content.get_mpz_t(), c->get_mpz_t());
  if (content <= 1)
    return;
  for (mpz_class& c : p)
    mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
}

integers derivative(const integers& p) {
  integers r;
  for (std::size_t i = 1; i < p.size(); ++i)
    r.push_back(p[i] * static_cast<unsigned long>(i));
  make_primitive(r);
  return r;
}

/// A positive multiple of the remainder of a by b, primitive.
integers remainder(integers a, const integers& b) {
  mpz_class common, factor, multiple;
  while (a.size() >= b.size()) {
    // a * (|lead b| / common) - (+-lead a / common) t^k b, whose leading term is 0
    mpz_gcd(common.get_mpz_t(), a.back().get_mpz_t(), b.back().get_mpz_t());
    factor = abs(b.back()) / common;
    multiple = a.back() / common;
    if (b.back() < 0)
      multiple = -multiple;
    const std::size_t k = a.size() - b.size();
    a.pop_back();
    for (mpz_class& c : a)
      c *= factor;
    for (std::size_t i = 0; i + 1 < b.size(); ++i)
      mpz_submul(a[i + k].get_mpz_t(), multiple.get_mpz_t(), b[i].get_mpz_t());
    while (!a.empty() && a.back() == 0)
      a.pop_back();
  }
  make_primitive(a);
  return a;
}

/// p, p', and then the negated remainders, each up to a positive factor; the last is gcd(p, p').
std::vector<integers> sturm_sequence(integers p) {
  make_primitive(p);
  std::vector<integers> s{std::move(p)};
  if (degree(s[0]) < 1)
    return s;
  s.push_back(derivative(s[0]));
  while (degree(s.back()) > 0) {
    integers r = remainder(s[s.size() - 2], s.back());
    if (r.empty())
      break;
    for (mpz_class& c : r)
      mpz_neg(c.get_mpz_t(), c.get_mpz_t());
    s.push_back(std::move(r));
  }
  return s;
}

/// a / b where b divides a over the rationals; primitive, up to a positive factor.
integers quotient(integers a, const integers& b) {
  integers q(a.size() - b.size() + 1);
  // Both are primitive, hence so is the quotient, and every division is exact (Gauss's lemma).
  for (std::size_t k = q.size(); k-- > 0;) {
    mpz_divexact(q[k].get_mpz_t(), a[k + b.size() - 1].get_mpz_t(), b.back().get_mpz_t());
    for (std::size_t i = 0; i < b.size(); ++i)
      mpz_submul(a[i + k].get_mpz_t(), q[k].get_mpz_t(), b[i].get_mpz_t());
  }
  return q;
}

/// p(n / d) d^degree, d > 0: of the sign of p(n / d).
mpz_class homogeneous(const integers& p, const mpz_class& n, const mpz_class& d) {
  mpz_class value = p.back(), power = 1;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    power *= d;
    value *= n;
    mpz_addmul(value.get_mpz_t(), p[i].get_mpz_t(), power.get_mpz_t());
  }
  return value;
}

int sign_at(const integers& p, const mpq_class& t) {
  if (t == 0)
    return sgn(p.front());
  return sgn(homogeneous(p, t.get_num(), t.get_den()));
}

/// n / 2^k; k may be negative.
struct grid_point {
  mpz_class n;
  long k;

  [[nodiscard]] mpq_class value() const {
    mpq_class r(n);
    if (k >= 0)
      mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(k));
    else
      mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-k));
    return r;
  }
};

/// p(n / 2^k) times 2^(k degree) for k > 0.
mpz_class value_at(const integers& p, const grid_point& t) {
  mpz_class n = t.n, term, value = p.back();
  if (t.k < 0)
    mpz_mul_2exp(n.get_mpz_t(), n.get_mpz_t(), static_cast<mp_bitcnt_t>(-t.k));
  const auto k = static_cast<mp_bitcnt_t>(std::max(t.k, 0L));
  mp_bitcnt_t shift = 0;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    shift += k;
    value *= n;
    mpz_mul_2exp(term.get_mpz_t(), p[i].get_mpz_t(), shift);
    value += term;
  }
  return value;
}

int changes(int& last, int sign) {
  const int changed = sign != 0 && last != 0 && sign != last ? 1 : 0;
  if (sign != 0)
    last = sign;
  return changed;
}

/// Every root of p is below 2^bound in magnitude (Cauchy): 1 + max |c_i| / |c_n|.
long bound_of_roots(const integers& p) {
  std::size_t most = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    if (p[i] != 0)
      most = std::max(most, mpz_sizeinbase(p[i].get_mpz_t(), 2));
  // |c_i| < 2^most, |c_n| >= 2^(size - 1), so that the ratio is below 2^(most - size + 1).
  return std::max(static_cast<long>(most) -
                      static_cast<long>(mpz_sizeinbase(p.back().get_mpz_t(), 2)) + 1,
                  0L) +
         1;
}

/// The interval ]n / 2^k, (n + 1) / 2^k] with exactly one root of p, a simple one.
struct cell {
  mpz_class n;
  long k;
  bool exact = false; ///< the root is the upper end

  [[nodiscard]] grid_point lower() const { return {n, k}; }
  [[nodiscard]] grid_point upper() const { return {n + 1, k}; }
};

/// Narrows the cell to a width of 2^-bits, at about twice the bits a step: the secant says in which
/// of 2^m parts the root should be, and exact signs at its two ends confirm it (Abbott's quadratic
/// interval refinement) or send it back to bisection.
void refine(const integers& p, cell& at, long bits) {
  mpz_class upper = value_at(p, at.upper());
  const int sign_above = sgn(upper);
  if (sign_above == 0) {
    at.exact = true;
    return;
  }
  mpz_class lower = value_at(p, at.lower());
  const auto move = [&at](const mpz_class& n, long k, bool exact) {
    at.n = exact ? mpz_class(n - 1) : n;
    at.k = k;
    at.exact = exact;
  };
  long m = 2;
  while (at.k < bits) {
    // lower is 0 where the cell's excluded end is another root: bisect
    m = std::min(m, bits - at.k);
    if (m > 1 && sgn(lower) == -sign_above) {
      const long k = at.k + m;
      mpz_class part = lower, span = lower - upper;
      mpz_mul_2exp(part.get_mpz_t(), part.get_mpz_t(), static_cast<mp_bitcnt_t>(m));
      mpz_fdiv_q(part.get_mpz_t(), part.get_mpz_t(), span.get_mpz_t());
      mpz_class n = at.n;
      mpz_mul_2exp(n.get_mpz_t(), n.get_mpz_t(), static_cast<mp_bitcnt_t>(m));
      n += part; // 0 <= part < 2^m, since lower and upper have opposite signs
      mpz_class low = value_at(p, {n, k}), high = value_at(p, {n + 1, k});
      if (low == 0)
        return move(n, k, true);
      if (high == 0)
        return move(n + 1, k, true);
      if (sgn(low) != sign_above && sgn(high) == sign_above) {
        move(n, k, false);
        lower = std::move(low);
        upper = std::move(high);
        m *= 2;
        continue;
      }
      m /= 2;
    }
    const mpz_class middle = 2 * at.n + 1;
    mpz_class value = value_at(p, {middle, at.k + 1});
    if (value == 0)
      return move(middle, at.k + 1, true);
    const bool left = sgn(value) == sign_above;
    move(left ? mpz_class(2 * at.n) : middle, at.k + 1, false);
    // The values' scale is 2^(k degree): bring the kept end to the new one.
    mpz_class& kept = left ? lower : upper;
    if (at.k > 0)
      mpz_mul_2exp(kept.get_mpz_t(), kept.get_mpz_t(), static_cast<mp_bitcnt_t>(degree(p)));
    (left ? upper : lower) = std::move(value);
    m = std::max(m, 2L);
  }
}

/// How many times the root in [lo, hi], the only one of g there, is one of g.
int multiplicity(const integers& repeated, const mpq_class& lo, const mpq_class& hi) {
  int m = 1;
  integers h = repeated;
  while (degree(h) > 0) {
    std::vector<integers> s = sturm_sequence(h);
    // h has no other root in [lo, hi], so that it has this one if it is 0 at lo or changes after
    // it.
    const integers next = degree(s.back()) > 0 ? s.back() : integers{1};
    const integers simple = degree(next) > 0 ? quotient(s.front(), next) : s.front();
    const bool has = sign_at(simple, lo) == 0 || sign_at(simple, hi) == 0 ||
                     sign_at(simple, lo) != sign_at(simple, hi);
    if (!has)
      break;
    ++m;
    h = next;
  }
  return m;
}

/// Sign changes among the coefficients: at least the number of positive roots (Descartes).
bool has_no_positive_root(const integers& p) {
  int last = 0, n = 0;
  for (const mpz_class& c : p)
    n += changes(last, sgn(c));
  return n == 0;
}

/// The first root in from <= t <= to (to = nullptr: no end).
std::optional<root> find_first(const polynomial& g, const mpq_class& from, const mpq_class* to,
                               int bits) {
  if (to != nullptr && *to < from)
    return std::nullopt;
  const integers& given = g.integer_coefficients();
  if (given.empty())
    return root{from, from, 0};
  if (degree(given) == 0)
    return std::nullopt;
  const bool at_start = sign_at(given, from) == 0;
  if (!at_start && from >= 0 && has_no_positive_root(given))
    return std::nullopt;

  const root_counter counter(g);
  if (at_start)
    return root{from, from, multiplicity(counter.repeated(), from, from)};
  const integers& p = counter.square_free();
  const int changes_from = from == 0 ? counter.changes_at(0) : counter.changes_at(from);
  const int changes_to = to != nullptr ? counter.changes_at(*to) : counter.changes_at_infinity(1);
  if (changes_from == changes_to)
    return std::nullopt;

  // Cells ]n, n + 1] / 2^k: from one that holds all positive roots (or one at each side of 0) down
  // to one with one root, the first in the range. Counts are of the part of a cell in the range.
  cell at{0, -bound_of_roots(p), false};
  const auto count_up_to = [&](const grid_point& end) { // roots in ]from, end], clipped
    const mpq_class t = end.value();
    if (t <= from)
      return 0;
    if (to != nullptr && t >= *to)
      return changes_from - changes_to;
    return changes_from - counter.changes_at(t);
  };
  if (from < 0 && count_up_to({0, 0}) > 0)
    at.n = -1;
  int inside = count_up_to(at.upper());
  int all = from == 0 && to == nullptr && at.n == 0
                ? inside
                : counter.changes_at(at.lower().value()) - counter.changes_at(at.upper().value());
  while (all > 1) {
    at.n *= 2;
    ++at.k;
    const int left = count_up_to(at.upper());
    if (left > 0)
      inside = left;
    else
      ++at.n;
    all = counter.changes_at(at.lower().value()) - counter.changes_at(at.upper().value());
  }
  assert(all == 1 && inside >= 1);
  refine(p, at, bits);
  root found{at.exact ? at.upper().value() : at.lower().value(), at.upper().value(), 1};
  if (found.lo < from)
    found.lo = from;
  if (to != nullptr && *to < found.hi)
    found.hi = *to;
  found.multiplicity = multiplicity(counter.repeated(), found.lo, found.hi);
  return found;
}

} // namespace

root_counter::root_counter(const polynomial& g)
    : sequence_(sturm_sequence(g.integer_coefficients())) {
  assert(g.degree() >= 0);
  repeated_ = sequence_.back();
  if (degree(repeated_) < 1 || sequence_.size() < 2) {
    repeated_ = {1};
    return;
  }
  sequence_ = sturm_sequence(quotient(sequence_.front(), repeated_));
}

int root_counter::changes_at(const mpq_class& t) const {
  int last = 0, n = 0;
  for (const integers& p : sequence_)
    n += changes(last, sign_at(p, t));
  return n;
}

int root_counter::changes_at_infinity(int sign) const {
  int last = 0, n = 0;
  for (const integers& p : sequence_)
    n += changes(last, sgn(p.back()) * (sign < 0 && degree(p) % 2 != 0 ? -1 : 1));
  return n;
}

int root_counter::positive_roots() const { return changes_at(0) - changes_at_infinity(1); }

std::optional<root> first_root(const polynomial& g, int bits) {
  return find_first(g, 0, nullptr, bits);
}

std::optional<root> first_root(const polynomial& g, const mpq_class& from, const mpq_class& to,
                               int bits) {
  return find_first(g, from, &to, bits);
}

double double_below(const mpq_class& x) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (x < -most)
    return -infinity;
  if (x >= most)
    return most;
  double r = x.get_d(); // truncated; the loops do not rely on it
  while (x < r)
    r = std::nextafter(r, -infinity);
  while (std::nextafter(r, infinity) <= x)
    r = std::nextafter(r, infinity);
  return r;
}

double double_above(const mpq_class& x) {
  const double r = double_below(-x);
  return r == 0 ? 0 : -r;
}

} // namespace graze::oracle
