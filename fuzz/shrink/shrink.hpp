#pragma once
/// Makes a failing trial small: few octants, few levels, few significant bits, and integers.
#include <atomic>
#include <chrono>
#include <functional>
#include <judge/judge.hpp>
#include <vector>

namespace graze::fuzz {

/// How much there is to read in a trial; shrinking only ever lowers it.
struct complexity {
  int octants; ///< octants of the block
  int level;   ///< levels to descend
  int bits;    ///< significant bits, signs and far exponents of the ray, the root and the place
  int places;  ///< binary digits before the point and, three times as dear, behind it; and how
               ///< far the octant's size is from 1
  friend auto operator<=>(const complexity&, const complexity&) = default;
};
complexity complexity_of(const trial& t);

/// Trials that are simpler than t, the boldest first; each passes judgeable() and has a smaller
/// complexity. Whether one still fails is the caller's to judge.
std::vector<trial> simpler(const trial& t);

/// Greedy: takes the first simpler trial that still fails, until none does or `evaluations` are
/// used.
trial shrink(const trial& failing, const std::function<bool(const trial&)>& still_fails,
             unsigned evaluations = 30'000);

/// When to be content with what there is. A traversal in another process may take seconds for a
/// ray; others are done long before, so that what they give does not depend on the clock.
using shrink_deadline = std::chrono::steady_clock::time_point;
inline shrink_deadline usual_deadline() {
  return std::chrono::steady_clock::now() + std::chrono::seconds(10);
}

/// The same for a traversal: keeps `kind` among the findings, judged exactly each time, and a tame ray
/// (generate/tame.hpp) tame; with `keeps_grid` the grid stays as it is. Once `stop`
/// is set, what there is then is given.
trial shrink(const trial& failing, traversal& under_test, finding kind,
             unsigned evaluations = 30'000, shrink_deadline end = usual_deadline(),
             const std::atomic<bool>* stop = nullptr, bool keeps_grid = false);

} // namespace graze::fuzz
