#pragma once
/// The judge of reverse operations that are monotone by pieces: is `result` the tightest enclosure
/// of { t in x : f(t) is defined and meets c }, f set-valued where another operand is an interval?
///
/// It knows no inverse function. It looks at f at the ends of the result, at their neighbours, and
/// at and infinitely near the points where f changes its direction, and reasons by continuity:
/// where f lies wholly below c at one place and wholly above at another, a solution lies between;
/// where it lies below at both, and each of its ends is monotone between them, none does.
#include <algorithm>
#include <cmath>
#include <functional>
#include <graze/bounds.hpp>
#include <limits>
#include <vector>

namespace graze::oracle::reverse {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

inline double below(double t) { return std::nextafter(t, -unbounded); }
inline double above(double t) { return std::nextafter(t, unbounded); }

/// The double t (side 0), or the numbers infinitely close to t, or to an infinity, on one side.
struct place {
  double t;
  int side;
};

/// A value of f, by its roundings down and up. Infinitely close to a double d: d and its neighbour.
struct rounded_value {
  double down, up;
};
inline rounded_value exact_value(double d) { return {d, d}; }
inline rounded_value value_above(double d) { return {d, above(d)}; }
inline rounded_value value_below(double d) { return {below(d), d}; }

/// All values of f at a place.
struct image {
  rounded_value lo, hi;
  bool defined = true;
};
inline const image undefined_image = {{0, 0}, {0, 0}, false};
inline image single(const rounded_value& v) { return {v, v}; }

enum class judgement {
  tightest,
  loose,   ///< encloses the solutions, but is not the tightest that does
  unsound, ///< a solution is not enclosed
};

class reverse_judge {
public:
  using function = std::function<image(place)>;

  /// `turns`: increasing; between them each end of f is continuous and monotone.
  reverse_judge(function f, std::vector<double> turns, const bounds& c)
      : f_(std::move(f)), turns_(std::move(turns)), c_(c) {}

  [[nodiscard]] judgement judge(const bounds& x, const bounds& result) const {
    if (x.is_empty() || c_.is_empty())
      return result.is_empty() ? judgement::tightest : judgement::loose;
    if (result.is_empty())
      return reaches(x) ? judgement::unsound : judgement::tightest;
    if (!(result.lo <= result.hi))
      return judgement::unsound;
    if (!(x.lo <= result.lo && result.hi <= x.hi))
      return judgement::loose;
    return std::max(judge_lower(x, result.lo), mirrored().judge_lower({-x.hi, -x.lo}, -result.hi));
  }
  [[nodiscard]] bool tightest(const bounds& x, const bounds& result) const {
    return judge(x, result) == judgement::tightest;
  }
  [[nodiscard]] bool is_solution(double t) const { return at({t, 0}).position == relation::meets; }

private:
  enum class relation { undefined, below, meets, above };
  struct state {
    relation position;
    bool reaches_lo = false; ///< the greatest value is c.lo
    bool reaches_hi = false; ///< the least value is c.hi
  };

  state at(const place& p) const {
    const image values = f_(p);
    if (!values.defined)
      return {relation::undefined};
    if (values.hi.down < c_.lo)
      return {relation::below};
    if (values.lo.up > c_.hi)
      return {relation::above};
    const auto is = [](const rounded_value& v, double d) { return v.down == d && v.up == d; };
    return {relation::meets, is(values.hi, c_.lo), is(values.lo, c_.hi)};
  }
  static bool crossed(const state& a, const state& b) {
    return (a.position == relation::below && b.position == relation::above) ||
           (a.position == relation::above && b.position == relation::below);
  }
  [[nodiscard]] bool is_turn(double t) const {
    for (const double turn : turns_)
      if (turn == t)
        return true;
    return false;
  }

  /// Are there solutions t with a < t < b? No turn lies between; `a` may be infinitely above a
  /// number, or -inf.
  [[nodiscard]] bool strictly_between(const place& a, double b) const {
    const state first = at(a);
    if (a.side != 0 && first.position == relation::meets)
      return true;
    if (std::isinf(b) || is_turn(b)) {
      const state last = at({b, -1});
      return last.position == relation::meets || crossed(first, last);
    }
    const state last = at({b, 0});
    if (last.position != relation::meets)
      return crossed(first, last);
    // The solutions begin at b itself iff f touches c there with the end that comes nearer.
    return !(first.position == relation::below ? last.reaches_lo : last.reaches_hi);
  }
  /// Are there solutions t with a <= t < b (a < t where a = -inf)?
  [[nodiscard]] bool before(double a, double b) const {
    if (std::isfinite(a) && is_solution(a))
      return true;
    place from = std::isinf(a) || is_turn(a) ? place{a, 1} : place{a, 0};
    for (const double turn : turns_)
      if (a < turn && turn < b) {
        if (strictly_between(from, turn) || is_solution(turn))
          return true;
        from = {turn, 1};
      }
    return strictly_between(from, b);
  }
  [[nodiscard]] bool reaches(const bounds& x) const {
    return (x.lo < x.hi && before(x.lo, x.hi)) || (std::isfinite(x.hi) && is_solution(x.hi));
  }
  [[nodiscard]] judgement judge_lower(const bounds& x, double m) const {
    if (x.lo < m && before(x.lo, m))
      return judgement::unsound;
    const bool close = m == x.hi ? is_solution(m) : before(m, above(m));
    return close ? judgement::tightest : judgement::loose;
  }
  [[nodiscard]] reverse_judge mirrored() const {
    std::vector<double> turns;
    for (auto turn = turns_.rbegin(); turn != turns_.rend(); ++turn)
      turns.push_back(-*turn);
    return {[f = f_](place p) { return f({-p.t, -p.side}); }, turns, c_};
  }

  function f_;
  std::vector<double> turns_;
  bounds c_;
};

} // namespace graze::oracle::reverse
