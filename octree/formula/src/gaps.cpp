// Rays that meet a pole, a jump or a gap: short parts of the ray are looked at in factored numbers,
// the rest by the search.
#include "closer_look.hpp"
#include "factored.hpp"

#include <algorithm>
#include <graze/octree/along_ray.hpp>
#include <graze/octree_formula.hpp>

namespace graze::octree::closer_look {
namespace {

class broken_ray {
public:
  broken_ray(const tape::program& f, const ray& r, const box& domain)
      : f_(f), surface_(f), along_(surface_, r) {
    for (int a = 0; a < 3; ++a) {
      whole_.origin[a][0] = r.origin()[a];
      whole_.direction[a][0] = r.direction()[a];
    }
    whole_.clip(domain);
  }

  std::optional<certified_hit> decide(const certified_hit& found) {
    const double exit = whole_.end[0];
    // the first root, if there is one, is not after it
    const double end = found.outcome == verdict::undecided ? std::min(found.t_far, exit) : exit;
    std::optional<certified_hit> named; // the first pole, jump or gap
    bool passed = false;
    double t = found.t_near, length = 4 * whole_.least[0];
    const auto pass = [&](double u) {
      const std::optional<verdict> kind = free_of_zeros(t, u);
      if (!kind)
        return false;
      if (!named && *kind != verdict::miss)
        named = {*kind, false, t, u};
      passed = true;
      length = 2 * (u - t);
      t = u;
      return true;
    };
    while (t < end) {
      if (pass(std::min(t + length, end)))
        continue;
      const certified_hit next = search(t, length, end);
      if (next.outcome == verdict::hit)
        return next;
      if (next.outcome == verdict::miss)
        break;
      passed = passed || t < next.t_near;
      t = next.t_near;
      if (pass(next.t_far))
        continue;
      if (!passed)
        return std::nullopt;
      return certified_hit{found.outcome, false, t, std::max(next.t_far, found.t_far)};
    }
    if (found.outcome == verdict::hit)
      return std::nullopt;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return named.value_or(certified_hit{verdict::miss, false, infinity, infinity});
  }

private:
  using lanes_search = certified_search<one_lane<up>, formula_surface>;
  /// A ray's, beyond which it stays undecided.
  static constexpr unsigned most_runs = 4096;
  static constexpr double most_steps = 4.0 * lanes_search::most_steps;

  /// Proven: f has no zero on [t, u]; and what it has there instead.
  std::optional<verdict> free_of_zeros(double t, double u) {
    const bound3<up> x = along_.points(t, u);
    sides taken;
    bool pole = false;
    while (taken.next_run()) {
      if (taken.exhausted() || ++runs_ > most_runs)
        return std::nullopt;
      const factored value =
          tape::run<false>(f_, taken.number(x[0]), taken.number(x[1]), taken.number(x[2])).value;
      if (!value.has_no_zero())
        return std::nullopt;
      pole = pole || value.has_pole();
    }
    if (pole)
      return verdict::pole;
    if (taken.jumps || (taken.sided && taken.undefined))
      return verdict::jump;
    return taken.undefined ? verdict::gap : verdict::miss;
  }

  /// What the search finds from t on, the first X of this length, up to the first X that it leaves
  /// open.
  certified_hit search(double t, double length, double end) {
    lanes_search::prepared p = whole_;
    p.entry_down[0] = t;
    p.first[0] = std::min(t + length, end);
    p.end[0] = p.exit_up[0] = end;
    lanes_search s(surface_);
    s.begin(0, p, 0);
    while (s.step() == 0 && !s.left_open(0)) {
    }
    steps_ += s.steps(0);
    if (steps_ > most_steps)
      return {verdict::undecided, false, t, end};
    return s.result(0);
  }

  const tape::program& f_;
  formula_surface surface_;
  along_ray<formula_surface, up> along_;
  lanes_search::prepared whole_;
  unsigned runs_ = 0;
  double steps_ = 0;
};

} // namespace

std::optional<certified_hit> at_gaps(const tape::program& f, const ray& r, const box& domain,
                                     const certified_hit& found) {
  if (f.continuous)
    return std::nullopt;
  [[maybe_unused]] const up::scope scope;
  return broken_ray(f, r, domain).decide(found);
}

} // namespace graze::octree::closer_look
