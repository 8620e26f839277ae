#pragma once
/// Comparisons, and what is made of them: choices and solids.
#include "expressions.hpp"

#include <memory>

namespace graze::octree::tape {

struct condition;
using truth = std::shared_ptr<const condition>;

/// Comparisons of f with 0, joined by "and" and "or". It never changes.
struct condition {
  enum class kind : std::uint8_t { greater, at_least, same, different, all, any };
  kind what;
  sum_form f;
  std::vector<truth> parts; ///< of all and any: two or more
  std::size_t size;         ///< of all its terms

  static truth compared(kind what, sum_form f);
  static truth joined(kind what, std::vector<truth> parts);
};

/// How much there is to be copied.
std::size_t size_of(const sum_form& f);

truth negated(expressions& built, const condition& c);

/// if_true where c holds, else if_false; comparisons that are not needed are not looked at, from left
/// to right. Nothing if the builder refuses.
expressions::result chosen(expressions& built, const condition& c, const sum_form& if_true,
                           const sum_form& if_false);

/// f of the solid f <= 0 (of its inside, f < 0) in which c holds. Nothing if there is none.
expressions::result solid(expressions& built, const condition& c);

} // namespace graze::octree::tape
