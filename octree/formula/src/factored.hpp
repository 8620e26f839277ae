#pragma once
/// A number type for tapes on a short part of a ray, on which f may jump or have a pole: products of
/// powers, in which what may be 0 stays apart, and runs that take one side of each break.
#include <array>
#include <cstdint>
#include <graze/octree/inclusion.hpp>
#include <graze/octree_formula/evaluate.hpp>
#include <optional>

namespace graze::octree::closer_look {

using up = rounding::upward;
using interval = bound<up>;

inline bool contains_zero(const interval& x) { return x.lower() <= 0 && 0 <= x.upper(); }
inline bool is_empty(const interval& x) { return to_bounds(x).is_empty(); }
inline bool is_bounded(const interval& x) { return to_bounds(x).is_common(); }

class sides;

/// coefficient * the product of base^exponent. Encloses a number at all points of a box, on a run's
/// sides, at which it is defined. What may be 0 is a base: a product cancels bases, which leaves the
/// same number where it is defined, and a sum takes out what both have, so that 1/x + y is
/// x^-1 (1 + x y), of which no zero is one of 1 + x y. Within a scope of `up`.
struct factored {
  struct power {
    unsigned base;
    std::int64_t exponent; ///< never 0
  };
  static constexpr unsigned most_powers = 6;
  static constexpr std::int64_t most_exponent = 1 << 20;

  interval coefficient;
  power powers[most_powers];
  unsigned count;
  std::uint32_t name; ///< what has the same one is the same number; 0: it has none
  sides* of;          ///< none: a constant

  static factored constant(const interval& x) { return {x, {}, 0, 0, nullptr}; }
  [[nodiscard]] std::int64_t exponent_of(unsigned base) const {
    for (unsigned i = 0; i < count; ++i)
      if (powers[i].base == base)
        return powers[i].exponent;
    return 0;
  }
  /// An enclosure of the number. Where it has a pole in it, on one side of the pole.
  [[nodiscard]] interval value() const;
  /// Proven: the number is not 0 where it is defined.
  [[nodiscard]] bool has_no_zero() const;
  /// It diverges, as far as enclosures tell.
  [[nodiscard]] bool has_pole() const;

  friend factored operator-(const factored& x);
  friend factored operator+(const factored& x, const factored& y);
  friend factored operator-(const factored& x, const factored& y) { return x + -y; }
  friend factored operator*(const factored& x, const factored& y);
  friend factored sqr(const factored& x);
};

/// Runs of a tape over one box. Each takes one side of every break that it meets; together they
/// see all of the box's points. What is learnt of the breaks is summed over the runs.
class sides {
public:
  /// The first run begins, or the one after the last; false when every side has been taken.
  bool next_run();
  /// As often as is worth while.
  [[nodiscard]] bool exhausted() const { return runs_ > most_runs; }
  [[nodiscard]] unsigned runs() const { return runs_; }

  /// One of `options` sides; none where there are so many breaks that the run must do without.
  std::optional<unsigned> choose(unsigned options);

  /// The number x of this run: a base where it may be 0.
  factored number(const interval& x);
  [[nodiscard]] const interval& base(unsigned b) const { return bases_[b]; }
  /// This run looks only where the base is at most 0, or only where it is at least 0. False if it
  /// must do without.
  bool take_side(unsigned b);

  std::uint32_t next_name() { return ++names_; }
  /// What was remembered under this name and operation, so that equal numbers are one base.
  [[nodiscard]] const factored* known(tape::opcode op, const factored& x) const;
  factored remember(tape::opcode op, const factored& x, const factored& result);

  bool jumps = false;     ///< a step was chosen, or the side of a pole within a function
  bool sided = false;     ///< the side of a zero was chosen
  bool undefined = false; ///< there may be a point at which f is not defined

private:
  static constexpr unsigned most_choices = 8, most_runs = 64, most_bases = 32, most_known = 16;
  struct choice {
    unsigned taken, options;
  };
  struct memory {
    tape::opcode op;
    std::uint32_t name;
    factored result;
  };
  choice choices_[most_choices]{};
  unsigned made_ = 0, asked_ = 0, runs_ = 0;
  interval bases_[most_bases];
  unsigned base_count_ = 0;
  memory known_[most_known]{};
  unsigned known_count_ = 0;
  std::uint32_t names_ = 0;
};

} // namespace graze::octree::closer_look

namespace graze::octree::tape {

template <> struct operations<closer_look::factored> {
  using factored = closer_look::factored;
  using interval = closer_look::interval;

  static factored number(const constant& c) {
    return factored::constant(operations<interval>::number(c));
  }
  static factored div(const factored& x, const factored& y) { return x * recip(y); }
  static factored recip(const factored& x) { return pown(x, -1); }
  static factored sqrt(const factored& x);
  static factored abs(const factored& x);
  static factored min(const factored& x, const factored& y);
  static factored max(const factored& x, const factored& y) { return -min(-x, -y); }
  static factored pown(const factored& x, int n);
  static factored rootn(const factored& x, int n);
  static factored polynomial(const polynomial_view& p, const factored& x);
  static factored pow(const factored& x, const factored& y);
  static factored hypot(const factored& x, const factored& y);
  static factored atan2(const factored& y, const factored& x);
  static factored select(const factored& a, const factored& if_positive, const factored& if_not);
#define GRAZE_TAPE_FUNCTION(name) static factored name(const factored& x);
  GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_FUNCTION)
#undef GRAZE_TAPE_FUNCTION
};

} // namespace graze::octree::tape
