#pragma once
/// Whether a certified hit tells the truth: exact roots along the ray, counted by Sturm.
#include "../../support/exact_roots.hpp"
#include <cmath>
#include <cstdio>
#include <graze/octree/certified_hit.hpp>
#include <string>

namespace judge {

/// The distinct roots of a surface along a ray in its domain. For the union of spheres: those of
/// all nine, which are the surface's own up to the first one, seen from outside.
class roots_along {
public:
  template <class F>
  roots_along(const F& f, const graze::octree::ray& r, const graze::octree::box& domain)
      : range_(graze::oracle::rational::range_in(r.origin(), r.direction(), domain.lo, domain.hi)) {
    if (!range_)
      return;
    for (const auto& g : support::along(f, r)) {
      if (g.degree() < 0)
        everywhere_ = true;
      else
        counters_.emplace_back(g);
    }
  }

  /// The ray lies in the surface.
  [[nodiscard]] bool everywhere() const { return everywhere_ && range_; }
  /// Where the ray enters the domain, if it does.
  [[nodiscard]] const mpq_class& entry() const { return range_->first; }
  /// There is a multiple root in [lo, hi].
  [[nodiscard]] bool multiple(double lo, double hi) const {
    using graze::oracle::polynomial;
    for (const auto& g : counters_) {
      polynomial repeated;
      for (std::size_t i = g.repeated().size(); i-- > 0;)
        repeated = repeated * polynomial::along(0, 1) + polynomial(mpq_class(g.repeated()[i]));
      if (repeated.degree() < 1)
        continue;
      roots_along of_it = *this;
      of_it.counters_ = {graze::oracle::root_counter(repeated)};
      if (of_it.within(lo, hi) != 0)
        return true;
    }
    return false;
  }
  [[nodiscard]] int all() const { return range_ ? between(range_->first, range_->second) : 0; }
  /// With t < x, with x <= t, and with lo <= t <= hi; x may be infinite.
  [[nodiscard]] int before(double x) const { return all() - from(x); }
  [[nodiscard]] int from(double x) const {
    if (!range_ || std::isinf(x))
      return 0;
    return between(std::max<mpq_class>(range_->first, mpq_class(x)), range_->second);
  }
  [[nodiscard]] int within(double lo, double hi) const {
    if (!range_ || std::isinf(lo))
      return 0;
    mpq_class last = range_->second;
    if (!std::isinf(hi))
      last = std::min<mpq_class>(last, mpq_class(hi));
    return between(std::max<mpq_class>(range_->first, mpq_class(lo)), last);
  }

private:
  [[nodiscard]] int between(const mpq_class& lo, const mpq_class& hi) const {
    if (hi < lo)
      return 0;
    int count = 0;
    for (const auto& g : counters_) {
      mpq_class value = 0;
      for (std::size_t i = g.square_free().size(); i-- > 0;)
        value = value * lo + g.square_free()[i];
      count += g.roots_between(lo, hi) + (value == 0 ? 1 : 0);
    }
    return count;
  }

  std::optional<std::pair<mpq_class, mpq_class>> range_;
  std::vector<graze::oracle::root_counter> counters_;
  bool everywhere_ = false;
};

/// "" or what is wrong with `h`.
template <class F>
std::string untruth(const F& f, const graze::octree::ray& r, const graze::octree::box& domain,
                    const graze::octree::certified_hit& h) {
  using graze::octree::verdict;
  const roots_along roots(f, r, domain);
  if (roots.everywhere()) {
    if (h.outcome == verdict::hit && !h.unique && h.t_near <= roots.entry() &&
        roots.entry() <= h.t_far)
      return "";
    return h.outcome == verdict::undecided ? "" : "the ray lies in the surface";
  }
  if (h.outcome == verdict::miss)
    return roots.all() == 0 ? "" : "a root, reported as a miss";
  if (!(h.t_near <= h.t_far))
    return "an empty enclosure";
  if (roots.before(h.t_near) != 0)
    return "a root before the enclosure";
  const int inside = roots.within(h.t_near, h.t_far);
  if (h.outcome == verdict::undecided)
    return inside != 0 || roots.all() == 0 ? "" : "the first root is after the enclosure";
  if (inside == 0)
    return "no root in the enclosure of a hit";
  if (h.unique && inside != 1 && !std::is_same_v<F, graze::octree::spheres>)
    return "several roots in an enclosure said to have one";
  if (h.unique && roots.multiple(h.t_near, h.t_far))
    return "a multiple root that is said to be simple";
  return "";
}

inline std::string text(const graze::octree::ray& r, const graze::octree::certified_hit& h) {
  char line[400];
  std::snprintf(line, sizeof line, "o=(%a,%a,%a) d=(%a,%a,%a) outcome %d t=[%a,%a]", r.origin()[0],
                r.origin()[1], r.origin()[2], r.direction()[0], r.direction()[1], r.direction()[2],
                static_cast<int>(h.outcome), h.t_near, h.t_far);
  return line;
}

/// What became of many rays.
struct tally {
  int rays = 0, hits = 0, misses = 0, undecided = 0, shared = 0, wrong = 0;
  std::uint64_t most_steps = 0; ///< of one ray
  std::string first_wrong;

  template <class F>
  void judge(const F& f, const graze::octree::ray& r, const graze::octree::box& domain,
             const graze::octree::certified_hit& h) {
    using graze::octree::verdict;
    ++rays;
    hits += h.outcome == verdict::hit;
    misses += h.outcome == verdict::miss;
    undecided += h.outcome == verdict::undecided;
    shared += h.outcome == verdict::hit && !h.unique;
    if (const std::string why = untruth(f, r, domain, h); !why.empty() && wrong++ == 0)
      first_wrong = why + ": " + text(r, h);
  }
};

} // namespace judge
