#include "factored.hpp"

#include <algorithm>
#include <graze/octree_formula/derivatives.hpp>

namespace graze::octree::closer_look {
namespace {

using tape::opcode;
using intervals_of = tape::operations<interval>;

sides* run_of(const factored& x, const factored& y) { return x.of != nullptr ? x.of : y.of; }

factored number_of(sides* run, const interval& x) {
  return run != nullptr ? run->number(x) : factored::constant(x);
}

/// With a name of its own.
factored named(factored x) {
  x.name = x.of != nullptr ? x.of->next_name() : 0;
  return x;
}

/// As near to 0 as this many times its width: a quotient of two such numbers is loose.
constexpr double widths = 1024;
bool is_beside_zero(const interval& x) {
  const double least = std::max({x.lower(), -x.upper(), 0.0});
  return least <= widths * (x.upper() - x.lower());
}
bool straddles_zero(const interval& x) { return x.lower() < 0 && 0 < x.upper(); }

interval power_of(const interval& base, std::int64_t exponent) {
  return intervals_of::pown(base, static_cast<int>(exponent));
}

/// x times base^exponent. Nothing if there is no room.
bool multiply(factored& x, const factored::power& by, bool& cancels) {
  for (unsigned i = 0; i < x.count; ++i)
    if (x.powers[i].base == by.base) {
      std::int64_t& e = x.powers[i].exponent;
      cancels = cancels || ((e < 0) != (by.exponent < 0) && contains_zero(x.of->base(by.base)));
      e += by.exponent;
      if (e > factored::most_exponent || e < -factored::most_exponent)
        return false;
      if (e == 0)
        x.powers[i] = x.powers[--x.count];
      return true;
    }
  if (x.count == factored::most_powers)
    return false;
  x.powers[x.count++] = by;
  return true;
}

} // namespace

bool sides::next_run() {
  if (runs_ != 0) {
    while (made_ != 0 && choices_[made_ - 1].taken + 1 == choices_[made_ - 1].options)
      --made_;
    if (made_ == 0)
      return false;
    ++choices_[made_ - 1].taken;
  }
  ++runs_;
  asked_ = base_count_ = known_count_ = names_ = 0;
  return true;
}

std::optional<unsigned> sides::choose(unsigned options) {
  if (asked_ == most_choices)
    return std::nullopt;
  if (asked_ == made_)
    choices_[made_++] = {0, options};
  return choices_[asked_++].taken;
}

factored sides::number(const interval& x) {
  factored r{x, {}, 0, ++names_, this};
  if (is_beside_zero(x) && base_count_ < most_bases) {
    bases_[base_count_] = x;
    r.coefficient = interval(1.0);
    r.powers[r.count++] = {base_count_++, 1};
  }
  return r;
}

bool sides::take_side(unsigned b) {
  interval& x = bases_[b];
  if (!straddles_zero(x))
    return true;
  const auto side = choose(2);
  if (side)
    x = *side == 0 ? interval(x.lower(), 0) : interval(0, x.upper());
  return side.has_value();
}

const factored* sides::known(opcode op, const factored& x) const {
  for (unsigned i = 0; x.name != 0 && i < known_count_; ++i)
    if (known_[i].op == op && known_[i].name == x.name)
      return &known_[i].result;
  return nullptr;
}

factored sides::remember(opcode op, const factored& x, const factored& result) {
  if (x.name != 0 && known_count_ < most_known)
    known_[known_count_++] = {op, x.name, result};
  return result;
}

interval factored::value() const {
  interval v = coefficient;
  for (unsigned i = 0; i < count; ++i) {
    const auto [b, exponent] = powers[i];
    if (exponent < 0 && exponent % 2 != 0 && straddles_zero(of->base(b)) && of->take_side(b))
      of->jumps = true;
    v = v * power_of(of->base(b), exponent);
  }
  return v;
}

bool factored::has_no_zero() const {
  if (is_empty(coefficient))
    return true;
  return excludes_zero(coefficient) && std::all_of(powers, powers + count, [this](const power& p) {
           return p.exponent < 0 || excludes_zero(of->base(p.base));
         });
}

bool factored::has_pole() const {
  return std::any_of(powers, powers + count, [this](const power& p) {
    return p.exponent < 0 && contains_zero(of->base(p.base));
  });
}

factored operator-(const factored& x) {
  factored r = named(x);
  r.coefficient = -x.coefficient;
  return r;
}

factored operator*(const factored& x, const factored& y) {
  factored r = x;
  r.of = run_of(x, y);
  r = named(r);
  r.coefficient = x.coefficient * y.coefficient;
  bool cancels = false;
  for (unsigned i = 0; i < y.count; ++i)
    if (!multiply(r, y.powers[i], cancels))
      return number_of(r.of, x.value() * y.value());
  if (cancels)
    r.of->undefined = true;
  return r;
}

/// What is common to both is the lesser power of each base.
factored operator+(const factored& x, const factored& y) {
  sides* const run = run_of(x, y);
  interval rest_of_x = x.coefficient, rest_of_y = y.coefficient;
  factored common = factored::constant(interval(1.0));
  common.of = run;
  bool cancels = false;
  const auto part = [&](unsigned base) {
    const std::int64_t p = x.exponent_of(base), q = y.exponent_of(base), least = std::min(p, q);
    if (p != least)
      rest_of_x = rest_of_x * power_of(run->base(base), p - least);
    if (q != least)
      rest_of_y = rest_of_y * power_of(run->base(base), q - least);
    return least == 0 || multiply(common, {base, least}, cancels);
  };
  bool fits = true;
  for (unsigned i = 0; i < x.count; ++i)
    fits = fits && part(x.powers[i].base);
  for (unsigned i = 0; i < y.count; ++i)
    if (x.exponent_of(y.powers[i].base) == 0)
      fits = fits && part(y.powers[i].base);
  if (!fits)
    return number_of(run, x.value() + y.value());
  return number_of(run, rest_of_x + rest_of_y) * common;
}

factored sqr(const factored& x) { return tape::operations<factored>::pown(x, 2); }

} // namespace graze::octree::closer_look

namespace graze::octree::tape {
namespace {

using closer_look::contains_zero;
using closer_look::factored;
using closer_look::interval;
using closer_look::is_bounded;
using closer_look::is_empty;
using closer_look::named;
using closer_look::number_of;
using closer_look::run_of;
using closer_look::sides;
using on_intervals = operations<interval>;
using on_factored = operations<factored>;
using slope = dual<interval, 1>;

bool is_continuous(opcode op, const interval& x, const interval& y, int n) {
  return continuous_everywhere(op, n) || continuous_on(op, to_bounds(x), to_bounds(y), n);
}
bool is_continuous(opcode op, const interval& x) { return is_continuous(op, x, x, 0); }

/// The function's values over x's.
template <class Function> factored through(opcode op, const factored& x, Function f, int n = 0) {
  const interval at = x.value();
  if (x.of != nullptr && !is_continuous(op, at, at, n))
    x.of->undefined = true;
  return number_of(x.of, f(at));
}

/// A function that is 0 at 0. About 0 it is x times a slope between 0 and x: the mean value theorem.
template <class Function, class Slope>
factored through_zero(opcode op, const factored& x, Function f, Slope along) {
  if (x.count != 0 && !x.has_pole()) {
    const interval v = x.value(), from_zero(std::min(v.lower(), 0.0), std::max(v.upper(), 0.0));
    if (is_bounded(v) && is_continuous(op, from_zero)) {
      const interval s = along(slope{from_zero, {interval(1.0)}}).partial[0];
      if (is_bounded(s))
        return x * factored::constant(s);
    }
  }
  return through(op, x, f);
}

/// The same number each time, so that tan x + sec x has one denominator.
template <class Make> factored once(opcode op, const factored& x, Make make) {
  if (x.of == nullptr)
    return make();
  if (const factored* before = x.of->known(op, x))
    return *before;
  return x.of->remember(op, x, make());
}

/// over / under, which the function is; its own values, which are tighter, where under is not
/// beside 0.
template <class Function, class Over>
factored quotient(const factored& x, Function f, Over over, const factored& under) {
  return under.count == 0 ? number_of(x.of, f(x.value())) : over() * on_factored::recip(under);
}

/// A function with steps, whose values are integers.
template <class Function> factored step(const factored& x, Function f) {
  // Integers that a step of a short box may have: more are not told apart, nor are those that are
  // not all doubles.
  constexpr double most_steps = 7, greatest = 0x1p52;
  const interval values = f(x.value());
  const double first = values.lower(), last = values.upper();
  if (x.of == nullptr || !(last - first <= most_steps) || first < -greatest || greatest < last ||
      first == last)
    return number_of(x.of, values);
  const auto chosen = x.of->choose(static_cast<unsigned>(last - first) + 1);
  if (!chosen)
    return number_of(x.of, values);
  x.of->jumps = true;
  return number_of(x.of, interval(first + *chosen));
}

} // namespace

factored on_factored::abs(const factored& x) {
  factored r = named(x);
  r.coefficient = on_intervals::abs(x.coefficient);
  for (unsigned i = 0; i < x.count; ++i) {
    if (x.powers[i].exponent % 2 == 0)
      continue;
    const unsigned b = x.powers[i].base;
    if (!x.of->take_side(b))
      return number_of(x.of, on_intervals::abs(x.value()));
    x.of->sided = x.of->sided || contains_zero(x.of->base(b));
    if (x.of->base(b).upper() <= 0)
      r.coefficient = -r.coefficient;
  }
  return r;
}

factored on_factored::sqrt(const factored& x) {
  const bool square = x.coefficient.lower() > 0 &&
                      std::all_of(x.powers, x.powers + x.count,
                                  [](const factored::power& p) { return p.exponent % 2 == 0; });
  if (!square || x.count == 0)
    return through(opcode::sqrt, x, &on_intervals::sqrt);
  factored r = x;
  r.coefficient = on_intervals::sqrt(x.coefficient);
  for (unsigned i = 0; i < x.count; ++i)
    r.powers[i].exponent /= 2;
  return abs(r);
}

factored on_factored::pown(const factored& x, int n) {
  factored r = named(x);
  r.coefficient = on_intervals::pown(x.coefficient, n);
  if (n == 0)
    r.count = 0;
  for (unsigned i = 0; i < r.count; ++i) {
    std::int64_t& e = r.powers[i].exponent;
    e *= n;
    if (e > factored::most_exponent || e < -factored::most_exponent)
      return number_of(x.of, on_intervals::pown(x.value(), n));
  }
  return r;
}

factored on_factored::rootn(const factored& x, int n) {
  return through(opcode::rootn, x, [n](const interval& v) { return on_intervals::rootn(v, n); }, n);
}

factored on_factored::min(const factored& x, const factored& y) {
  const interval p = x.value(), q = y.value();
  if (p.upper() <= q.lower())
    return x;
  if (q.upper() <= p.lower())
    return y;
  return number_of(run_of(x, y), on_intervals::min(p, q));
}

factored on_factored::polynomial(const polynomial_view& p, const factored& x) {
  const constant& last = p.coefficients[p.degree];
  if (x.count != 0 && (x.has_pole() || (last.lo == 0 && last.hi == 0)))
    return horner(p, x);
  return number_of(x.of, on_intervals::polynomial(p, x.value()));
}

factored on_factored::pow(const factored& x, const factored& y) {
  const interval p = x.value(), q = y.value();
  sides* const run = run_of(x, y);
  if (run != nullptr && !is_continuous(opcode::pow, p, q, 0))
    run->undefined = true;
  return number_of(run, on_intervals::pow(p, q));
}

factored on_factored::hypot(const factored& x, const factored& y) {
  return number_of(run_of(x, y), on_intervals::hypot(x.value(), y.value()));
}

/// Beside the cut, y = 0 > x, it is that of |y|, with y's sign; on it, that of y >= 0.
factored on_factored::atan2(const factored& y, const factored& x) {
  const interval p = y.value(), q = x.value();
  sides* const run = run_of(x, y);
  if (run != nullptr && !is_continuous(opcode::atan2, p, q, 0)) {
    run->undefined = true;
    if (p.lower() < 0 && 0 <= p.upper() && q.lower() < 0)
      if (const auto side = run->choose(2)) {
        run->jumps = true;
        return number_of(run, *side == 0
                                  ? on_intervals::atan2(interval(0, p.upper()), q)
                                  : interval(-on_intervals::atan2(interval(0, -p.lower()), q)));
      }
  }
  return number_of(run, on_intervals::atan2(p, q));
}

factored on_factored::select(const factored& a, const factored& if_positive,
                             const factored& if_not) {
  const interval condition = a.value();
  if (condition.lower() > 0)
    return if_positive;
  if (condition.upper() <= 0)
    return if_not;
  sides* const run = a.of;
  if (run != nullptr && !is_empty(condition))
    if (const auto side = run->choose(2)) {
      run->jumps = true;
      return *side == 0 ? if_positive : if_not;
    }
  return number_of(run, on_intervals::select(condition, if_positive.value(), if_not.value()));
}

#define GRAZE_FACTORED_THROUGH(name)                                                               \
  factored on_factored::name(const factored& x) {                                                  \
    return through(opcode::name, x, &on_intervals::name);                                          \
  }
GRAZE_FACTORED_THROUGH(cbrt)
GRAZE_FACTORED_THROUGH(exp)
GRAZE_FACTORED_THROUGH(exp2)
GRAZE_FACTORED_THROUGH(exp10)
GRAZE_FACTORED_THROUGH(log)
GRAZE_FACTORED_THROUGH(log2)
GRAZE_FACTORED_THROUGH(log10)
GRAZE_FACTORED_THROUGH(acos)
GRAZE_FACTORED_THROUGH(acot)
GRAZE_FACTORED_THROUGH(cosh)
GRAZE_FACTORED_THROUGH(sech)
GRAZE_FACTORED_THROUGH(acosh)
GRAZE_FACTORED_THROUGH(acoth)
#undef GRAZE_FACTORED_THROUGH

#define GRAZE_FACTORED_THROUGH_ZERO(name)                                                          \
  factored on_factored::name(const factored& x) {                                                  \
    return once(opcode::name, x, [&x] {                                                            \
      return through_zero(opcode::name, x, &on_intervals::name, &operations<slope>::name);         \
    });                                                                                            \
  }
GRAZE_FACTORED_THROUGH_ZERO(sin)
GRAZE_FACTORED_THROUGH_ZERO(asin)
GRAZE_FACTORED_THROUGH_ZERO(atan)
GRAZE_FACTORED_THROUGH_ZERO(sinh)
GRAZE_FACTORED_THROUGH_ZERO(tanh)
GRAZE_FACTORED_THROUGH_ZERO(asinh)
GRAZE_FACTORED_THROUGH_ZERO(atanh)
GRAZE_FACTORED_THROUGH_ZERO(expm1)
GRAZE_FACTORED_THROUGH_ZERO(logp1)
#undef GRAZE_FACTORED_THROUGH_ZERO

factored on_factored::cos(const factored& x) {
  return once(opcode::cos, x, [&x] { return through(opcode::cos, x, &on_intervals::cos); });
}

factored on_factored::tan(const factored& x) {
  const factored under = cos(x);
  if (under.count == 0)
    return through_zero(opcode::tan, x, &on_intervals::tan, &operations<slope>::tan);
  return div(sin(x), under);
}

#define GRAZE_FACTORED_QUOTIENT(name, over, under)                                                 \
  factored on_factored::name(const factored& x) {                                                  \
    return quotient(x, &on_intervals::name, [&x] { return over; }, under);                         \
  }
GRAZE_FACTORED_QUOTIENT(cot, cos(x), sin(x))
GRAZE_FACTORED_QUOTIENT(sec, factored::constant(interval(1.0)), cos(x))
GRAZE_FACTORED_QUOTIENT(csc, factored::constant(interval(1.0)), sin(x))
GRAZE_FACTORED_QUOTIENT(coth, cosh(x), sinh(x))
GRAZE_FACTORED_QUOTIENT(csch, factored::constant(interval(1.0)), sinh(x))
#undef GRAZE_FACTORED_QUOTIENT

#define GRAZE_FACTORED_STEP(name)                                                                  \
  factored on_factored::name(const factored& x) { return step(x, &on_intervals::name); }
GRAZE_FACTORED_STEP(sign)
GRAZE_FACTORED_STEP(floor)
GRAZE_FACTORED_STEP(ceil)
GRAZE_FACTORED_STEP(trunc)
#undef GRAZE_FACTORED_STEP

} // namespace graze::octree::tape
