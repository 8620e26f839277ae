#pragma once
/// How good answers are: held against the tightest enclosures, which MPFR gives.
#include "measure.hpp"
#include <graze/bounds.hpp>
#include <string>
#include <vector>

namespace graze::bench {

/// The operands of an operation; those of one place in x and y belong together.
struct operand_set {
  std::string name; ///< "narrow", "mixed", "positive"; "points", "hard"
  std::vector<ends> x, y;
};

/// The first `count` of the operands that are timed.
operand_set timed_operands(const contender& c, std::size_t count);

/// The points of a set of operands, as intervals of no width.
operand_set points_of(const operand_set& set);

/// Made for an operation: ties, subnormal and overflowing results, one-ulp neighbours, exact cases
/// and their neighbours, cancellation; for functions the ends of their ranges, huge arguments,
/// multiples of pi/2, values next to a double. Bounded intervals, a third of them points; operands
/// outside of the domain occur.
operand_set hard_operands_of(const std::string& operation, std::size_t count);

/// A composition of operations has no judge.
bool has_judge(const std::string& operation);

/// The tightest enclosures of the operation's ranges, empty where it is nowhere defined. Over the
/// points of the ends where `of_points`.
std::vector<bounds> tightest(const std::string& operation, const operand_set& set, bool of_points);

/// How far a bound is outside of the tightest one, in ulps: steps between doubles at the tightest
/// bound, where that is 0 at the enclosure's other end.
double excess_in_ulps(double bound, double tightest_bound, double other_end);

struct verdict {
  std::size_t judged = 0;    ///< the true range is not empty
  std::size_t unsound = 0;   ///< a part of the true range is outside
  std::size_t unbounded = 0; ///< a bound is infinite and need not be, or there is no answer
  std::size_t tight = 0;     ///< no excess
  /// Of the lower and the upper bound together, over the answers that are neither.
  double mean_excess = 0, median_excess = 0, worst_excess = 0;
  std::size_t example = 0; ///< of an unsound answer, where there is one
};
verdict judge(const std::vector<enclosure>& answers, const std::vector<bounds>& truth);

} // namespace graze::bench
