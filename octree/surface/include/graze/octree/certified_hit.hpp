#pragma once
/// Certified first hits: the first zero of a surface along a ray, proven along the ray itself and
/// enclosed to the precision of doubles. No octree is needed.
///
/// g(t) = f(o + t d) is followed from the domain's entry on, an interval X of t at a time. Where
/// its natural extension or its mean value form excludes 0, X is passed, and the next one is
/// longer; where g is monotone on X, interval Newton contracts X, proves that it holds exactly one
/// zero, or none; else X is halved. Sources: Neumaier, Interval Methods for Systems of
/// Equations, 5.1; docs/definitions.md, contract 7.
///
/// Everything is written over `Lanes`, each of which follows a ray of its own: one (one_lane) for
/// scalar intervals, eight (certified_eight.hpp) in the registers of a path. What a lane finds does
/// not depend on the others. What kernels of a path use is always inlined: see batch/path.hpp.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <graze/batch/path.hpp>
#include <graze/octree/inclusion.hpp>
#include <graze/octree/ray.hpp>
#include <graze/octree/verdict.hpp>
#include <limits>

namespace graze::octree {

/// How a ray ends, in units of its own parameter t.
///   hit        a root is proven, and the first one lies in [t_near, t_far]. `unique`: it is the
///              only one there, and simple. Else roots beside each other could not be told apart,
///              or one root that is not simple lies there (of even order: the ray is tangent), or the ray
///              lies in the surface from there on.
///   miss       proven: no root. t_near and t_far are infinite.
///   undecided  the first root, if there is one, lies in [t_near, t_far].
///   pole, jump, gap  as a miss: no root. [t_near, t_far] encloses the first break (verdict.hpp).
struct certified_hit {
  verdict outcome;
  bool unique;
  double t_near, t_far;
  friend bool operator==(const certified_hit&, const certified_hit&) = default;
};

/// What was found of a ray, or, where that leaves something open (undecided, or a hit that is not unique)
/// and the surface can look closer, what it finds: its member look_closer(ray, domain, found), in any
/// rounding mode. Within no scope.
template <Surface F>
[[nodiscard]] certified_hit looked_closer(const F& f, const ray& r, const box& domain,
                                          const certified_hit& found) {
  if constexpr (requires { f.look_closer(r, domain, found); })
    if ((found.outcome == verdict::undecided || (found.outcome == verdict::hit && !found.unique)) &&
        !results_are_flushed())
      return f.look_closer(r, domain, found);
  return found;
}

/// The lanes of certified_search, one of them, over scalar intervals of B. Bit 0 of a mask.
template <rounding::Backend B> struct one_lane {
  static constexpr std::size_t count = 1;
  using number = double;
  using interval = bound<B>;

  static number load(const double* x) { return *x; }
  static void store(double* to, number x) { *to = x; }
  static number broadcast(double x) { return x; }
  static number lower(const interval& x) { return x.lower(); }
  static number upper(const interval& x) { return x.upper(); }
  static interval between(number lo, number hi) { return interval(lo, hi); }

  static number add_down(number x, number y) { return B::add_down(x, y); }
  static number add_up(number x, number y) { return B::add_up(x, y); }
  static number sub_down(number x, number y) { return B::sub_down(x, y); }
  static number sub_up(number x, number y) { return B::sub_up(x, y); }
  static number mul_down(number x, number y) { return B::mul_down(x, y); }
  static number mul_up(number x, number y) { return B::mul_up(x, y); }
  static number div_down(number x, number y) { return B::div_down(x, y); }
  static number div_up(number x, number y) { return B::div_up(x, y); }
  /// x where it is less (greater), else y.
  static number min(number x, number y) { return x < y ? x : y; }
  static number max(number x, number y) { return x > y ? x : y; }
  static number neg(number x) { return -x; }
  static number centre(number lo, number hi) { return detail::centre<scalar_path<B>>(lo, hi); }
  static unsigned less(number x, number y) { return x < y ? 1 : 0; }
  static unsigned less_equal(number x, number y) { return x <= y ? 1 : 0; }
  /// q in the lanes of the mask, p in the others.
  static number chosen(unsigned mask, number q, number p) { return mask != 0 ? q : p; }
};

/// A ray in each lane, on its way from the domain's entry to its exit. Within a scope of the lanes.
template <class L, Surface F> class certified_search {
public:
  static constexpr std::size_t count = L::count;
  static constexpr unsigned all = (1u << count) - 1;
  /// A ray that takes more steps is looked at more and more coarsely, so that it comes to an end:
  /// one through a root of high order.
  static constexpr int patience = 500;
  /// Steps after which a ray is given up as undecided, whatever the formula does.
  static constexpr int most_steps = 2000;

  explicit GRAZE_BATCH_INLINE certified_search(const F& f) : f_(f) {}

  /// Where rays are within the domain: the exact [entry, exit] of t, each bounded from both sides.
  struct prepared {
    alignas(64) double origin[3][count], direction[3][count];
    alignas(64) double entry_down[count], entry_up[count], exit_down[count], exit_up[count];
    /// The end of the search, the first X's end, and the length below which none is halved.
    alignas(64) double end[count], first[count], least[count];

    /// Returns the lanes in which the ray may have a point in the domain. As along_ray::within.
    GRAZE_BATCH_INLINE unsigned clip(const box& domain) {
      const number zero = L::broadcast(0), infinite = L::broadcast(infinity);
      number in_down = zero, in_up = zero, out_down = infinite, out_up = infinite;
      unsigned beside = 0;
      for (int a = 0; a < 3; ++a) {
        const number o = L::load(origin[a]), d = L::load(direction[a]);
        const number lo = L::broadcast(domain.lo[a]), hi = L::broadcast(domain.hi[a]);
        const unsigned forward = L::less(zero, d), backward = L::less(d, zero);
        const unsigned across = ~(forward | backward) & all;
        const number in = L::chosen(forward, lo, hi), out = L::chosen(forward, hi, lo);
        const auto time_down = [&](const number& plane) {
          return L::div_down(L::chosen(forward, L::sub_down(plane, o), L::sub_up(plane, o)), d);
        };
        const auto time_up = [&](const number& plane) {
          return L::div_up(L::chosen(forward, L::sub_up(plane, o), L::sub_down(plane, o)), d);
        };
        in_down = L::max(L::chosen(across, zero, time_down(in)), in_down);
        in_up = L::max(L::chosen(across, zero, time_up(in)), in_up);
        out_down = L::min(L::chosen(across, infinite, time_down(out)), out_down);
        out_up = L::min(L::chosen(across, infinite, time_up(out)), out_up);
        beside |= across & (L::less(o, lo) | L::less(hi, o));
      }
      L::store(entry_down, in_down);
      L::store(entry_up, in_up);
      L::store(exit_down, out_down);
      L::store(exit_up, out_up);
      // a t beyond the greatest double cannot be looked at: see result()
      const number last = L::min(out_up, L::broadcast(std::numeric_limits<double>::max()));
      const number part = L::mul_up(L::sub_up(last, in_down), L::broadcast(first_part));
      L::store(end, last);
      L::store(first, L::min(L::add_up(in_down, part), last));
      L::store(least, L::mul_up(last, L::broadcast(least_part)));
      return ~(beside | L::less(out_up, in_down)) & all;
    }
  };

  /// A ray begins in a lane.
  GRAZE_BATCH_INLINE void begin(std::size_t lane, const prepared& from, std::size_t k) {
    for (int a = 0; a < 3; ++a) {
      origin_[a][lane] = from.origin[a][k];
      direction_[a][lane] = from.direction[a][k];
    }
    entry_up_[lane] = from.entry_up[k];
    exit_down_[lane] = from.exit_down[k];
    exit_up_[lane] = from.exit_up[k];
    end_[lane] = from.end[k];
    t_[lane] = from.entry_down[k];
    u_[lane] = from.first[k];
    least_[lane] = from.least[k];
    near_[lane] = infinity;
    far_[lane] = 0;
    steps_[lane] = 0;
    const unsigned bit = 1u << lane;
    active_ |= bit;
    for (unsigned* mask :
         {&positive_, &negative_, &proven_, &was_positive_, &was_negative_, &hit_, &given_up_})
      *mask &= ~bit;
  }

  /// One step of every active lane; the lanes that have come to their end with it.
  GRAZE_BATCH_INLINE unsigned step() {
    const number zero = L::broadcast(0), t = L::load(t_), u = L::load(u_), end = L::load(end_);
    const number width = L::sub_up(u, t);

    // g on X = [t, u], and at a point of X: its middle, or t as long as no sign is known there
    const unsigned unknown = ~(positive_ | negative_) & all;
    const number half = L::broadcast(0.5);
    const number c = L::chosen(unknown, t, L::centre(t, u));
    const slope g = along(t, u);
    const interval at_c = at(c);
    const interval offset = L::between(L::sub_down(t, c), L::sub_up(u, c));
    const interval mean_value = at_c + g.partial[0] * offset;
    const number at_c_lo = L::lower(at_c), at_c_hi = L::upper(at_c);
    const number slope_lo = L::lower(g.partial[0]), slope_hi = L::upper(g.partial[0]);

    const unsigned c_positive = L::less(zero, at_c_lo), c_negative = L::less(at_c_hi, zero);
    unsigned positive = positive_ | (unknown & c_positive);
    unsigned negative = negative_ | (unknown & c_negative);
    const unsigned rises = L::less(zero, slope_lo), falls = L::less(slope_hi, zero);
    const unsigned monotone = rises | falls;

    // Newton: zeros in X are in N = c - g(c) / g'(X)
    const interval quotient = at_c / g.partial[0];
    const number n_lo = L::sub_down(c, L::upper(quotient)), n_hi = L::sub_up(c, L::lower(quotient));
    const number a = L::max(n_lo, t), b = L::min(n_hi, u);
    const unsigned none_in_n = monotone & L::less(b, a);

    // X is passed where g has no zero in it; its sign at u is then known
    const unsigned above = L::less(zero, L::lower(g.value)) | L::less(zero, L::lower(mean_value));
    const unsigned below = L::less(L::upper(g.value), zero) | L::less(L::upper(mean_value), zero);
    const unsigned away = (positive & rises) | (negative & falls);
    const unsigned passed = (above | below | away | none_in_n) & ~proven_;
    const unsigned positive_at_u = above | (away & positive) | (none_in_n & c_positive);
    const unsigned negative_at_u = below | (away & negative) | (none_in_n & c_negative);

    // Exactly one zero is in X where N is within X, or reaches out of it only at t, where g has the
    // sign from which it moves to the other one.
    const unsigned towards = (positive & falls) | (negative & rises);
    const unsigned proven = proven_ | (monotone & ~passed & L::less_equal(n_hi, u) &
                                       (L::less_equal(t, n_lo) | towards));
    // At least a half goes where g(c) is known not to be 0, since N is on one side of the middle
    // then.
    const number new_width = L::sub_up(b, a);
    const unsigned shorter = L::less(new_width, L::mul_up(width, L::broadcast(0.75)));
    // it stays as wide because of the error of g(c), not of the length of X
    const number c_magnitude = L::max(L::neg(at_c_lo), at_c_hi),
                 steepness_at_least = L::chosen(rises, slope_lo, L::neg(slope_hi));
    const unsigned precise =
        L::less_equal(L::mul_up(c_magnitude, L::sub_up(slope_hi, slope_lo)),
                      L::mul_up(L::sub_up(at_c_hi, at_c_lo), steepness_at_least));
    // at an end of X, where N may be about as wide as X whatever the errors, that says nothing
    const unsigned at_end = unknown & (c_positive | c_negative);
    const unsigned converged = proven & (precise | ~(shorter | at_end));
    const unsigned inside =
        L::less_equal(L::load(entry_up_), a) & L::less_equal(b, L::load(exit_down_));

    // Neither: X is cut to N, moved on where N reaches beyond u, or halved where that gains little
    const unsigned open = ~(passed | proven) & all;
    // twice, so that X after a blurred one, which is as long as least_ but for rounding, is short
    const unsigned too_short =
        open & L::less_equal(width, L::mul_up(L::load(least_), L::broadcast(2)));
    const unsigned blurred = too_short | (converged & ~inside);
    const unsigned contracted = open & ~too_short & monotone & shorter;
    const unsigned beyond = contracted & L::less(u, n_hi);
    const unsigned learnt =
        contracted & L::less(t, n_lo); // g(t) is on the side from which it comes
    positive |= learnt & falls;
    negative |= learnt & rises;

    // where X ends up
    const number blurred_lo = L::chosen(proven, a, t), blurred_hi = L::chosen(proven, b, u);
    number near = L::load(near_), far = L::load(far_), least = L::load(least_);
    near = L::chosen(blurred, L::min(near, blurred_lo), near);
    far = L::chosen(blurred, L::max(far, blurred_hi), far);
    least = L::chosen(blurred, L::max(least, L::sub_up(far, near)), least);
    const number steps = L::add_up(L::load(steps_), L::broadcast(1));
    least =
        L::chosen(L::less(L::broadcast(patience), steps), L::mul_up(least, L::broadcast(2)), least);
    const number new_t =
        L::chosen(passed, u, L::chosen(blurred, blurred_hi, L::chosen(contracted | proven, a, t)));
    // a little more than N, so that the next N is within
    const number reach =
        L::max(L::mul_up(L::sub_up(L::min(n_hi, L::add_up(u, width)), a), L::broadcast(1.25)),
               L::mul_up(least, L::broadcast(8)));
    const number length =
        L::chosen(passed, L::mul_up(width, L::broadcast(growth)),
                  L::chosen(blurred, least, L::chosen(beyond, reach, L::mul_up(width, half))));
    number new_u = L::min(L::add_up(new_t, length), end);
    new_u = L::chosen((proven | (contracted & ~beyond)) & ~blurred, b, new_u);
    L::store(t_, new_t);
    L::store(u_, new_u);
    L::store(near_, near);
    L::store(far_, far);
    L::store(least_, least);
    L::store(steps_, steps);

    was_positive_ |= blurred & positive;
    was_negative_ |= blurred & negative;
    positive_ = ((positive & ~passed) | (positive_at_u & passed)) & ~blurred;
    negative_ = ((negative & ~passed) | (negative_at_u & passed)) & ~blurred;
    proven_ = proven & ~blurred;
    // the sign is another one behind what is blurred than before
    const unsigned changed = (without_jumps(f_) ? all : 0) &
                             ((was_positive_ & negative_) | (was_negative_ & positive_)) &
                             L::less_equal(L::load(entry_up_), near) &
                             L::less_equal(far, L::load(exit_down_));
    hit_ = (converged & inside) | changed;
    const unsigned ended = (passed | blurred) & L::less_equal(end, new_t);
    given_up_ = L::less(L::broadcast(most_steps), steps);
    const unsigned finished = (hit_ | ended | given_up_) & active_;
    active_ &= ~finished;
    return finished;
  }

  /// What was found by a lane that step() has named, before another ray begins there.
  GRAZE_BATCH_INLINE certified_hit result(std::size_t lane) const {
    const bool blurred = near_[lane] < infinity;
    if ((hit_ >> lane & 1) != 0) {
      if ((proven_ >> lane & 1) == 0)
        return {verdict::hit, false, near_[lane], far_[lane]};
      return {verdict::hit, !blurred, blurred ? near_[lane] : t_[lane], u_[lane]};
    }
    if ((given_up_ >> lane & 1) != 0 || end_[lane] < exit_up_[lane])
      return {verdict::undecided, false, blurred ? near_[lane] : t_[lane], exit_up_[lane]};
    if (blurred)
      return {verdict::undecided, false, near_[lane], far_[lane]};
    return {verdict::miss, false, infinity, infinity};
  }
  [[nodiscard]] GRAZE_BATCH_INLINE unsigned active() const { return active_; }
  /// There is an X in which a zero could neither be proven nor excluded.
  [[nodiscard]] GRAZE_BATCH_INLINE bool left_open(std::size_t lane) const {
    return near_[lane] < infinity;
  }
  [[nodiscard]] GRAZE_BATCH_INLINE double steps(std::size_t lane) const { return steps_[lane]; }

private:
  /// f is continuous everywhere, so that opposite signs mean a root between. Newton's steps do not
  /// need it: of a surface that is not, derivatives must be unbounded on boxes where it may jump.
  static GRAZE_BATCH_INLINE bool without_jumps(const F& f) {
    if constexpr (requires { static_cast<bool>(f.continuous()); })
      return f.continuous();
    return true;
  }

  using number = typename L::number;
  using interval = typename L::interval;
  using slope = dual<interval, 1>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double first_part = 0.5; ///< of the way through the domain
  static constexpr double growth = 2;       ///< of an interval of t after one that is passed
  /// Intervals that are shorter, as a part of the exit's t, are not halved: a few ulps.
  static constexpr double least_part = 0x1p-50;

  /// Encloses g and its derivative on [first, last].
  GRAZE_BATCH_INLINE slope along(const number& first, const number& last) const {
    slope x[3];
    for (int a = 0; a < 3; ++a) {
      const number o = L::load(origin_[a]), d = L::load(direction_[a]);
      const unsigned backward = L::less(d, L::broadcast(0));
      const number from = L::chosen(backward, last, first), to = L::chosen(backward, first, last);
      x[a] = {L::between(L::add_down(o, L::mul_down(from, d)), L::add_up(o, L::mul_up(to, d))),
              {L::between(d, d)}};
    }
    return f_(x[0], x[1], x[2]);
  }
  /// Encloses g(t).
  GRAZE_BATCH_INLINE interval at(const number& t) const {
    interval x[3];
    for (int a = 0; a < 3; ++a) {
      const number o = L::load(origin_[a]), d = L::load(direction_[a]);
      x[a] = L::between(L::add_down(o, L::mul_down(t, d)), L::add_up(o, L::mul_up(t, d)));
    }
    return f_(x[0], x[1], x[2]);
  }

  const F& f_;
  alignas(64) double origin_[3][count]{}, direction_[3][count]{};
  alignas(64) double entry_up_[count]{}, exit_down_[count]{}, exit_up_[count]{}, end_[count]{};
  /// X; what is shorter than least_ is not halved.
  alignas(64) double t_[count]{}, u_[count]{}, least_[count]{};
  /// From the first to the last X in which a zero could neither be proven nor excluded.
  alignas(64) double near_[count]{}, far_[count]{};
  alignas(64) double steps_[count]{};
  unsigned active_ = 0;
  unsigned positive_ = 0, negative_ = 0;         ///< the sign of g at t_, proven
  unsigned was_positive_ = 0, was_negative_ = 0; ///< and before near_
  unsigned proven_ = 0;                          ///< X holds exactly one zero
  unsigned hit_ = 0, given_up_ = 0;
};

/// Certified first hits by scalar intervals over B, for any surface.
template <Surface F, rounding::Backend B = rounding::upward> class certified_traversal {
public:
  /// Refuses a domain that is empty or not finite.
  [[nodiscard]] static expected<certified_traversal> make(const F& surface, const box& domain) {
    if (const expected<root_cube> root = enclosing_root(domain, 1); !root)
      return unexpected{root.reason()};
    return certified_traversal(surface, domain);
  }

  /// Any rounding mode; any thread. `steps`, if any, is increased by the intervals of t looked at.
  [[nodiscard]] certified_hit first_hit(const ray& r, std::uint64_t* steps = nullptr) const {
    return looked_closer(surface_, r, domain_, search_along(r, steps));
  }

private:
  [[nodiscard]] certified_hit search_along(const ray& r, std::uint64_t* steps) const {
    using search = certified_search<one_lane<B>, F>;
    [[maybe_unused]] const typename B::scope scope;
    if (results_are_flushed())
      return {verdict::undecided, false, 0, std::numeric_limits<double>::infinity()};
    typename search::prepared p;
    for (int a = 0; a < 3; ++a) {
      p.origin[a][0] = r.origin()[a];
      p.direction[a][0] = r.direction()[a];
    }
    if (p.clip(domain_) == 0)
      return {verdict::miss, false, std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity()};
    search s(surface_);
    s.begin(0, p, 0);
    while (s.step() == 0) {
    }
    if (steps != nullptr)
      *steps += static_cast<std::uint64_t>(s.steps(0));
    return s.result(0);
  }

  certified_traversal(const F& surface, const box& domain) : surface_(surface), domain_(domain) {}
  F surface_;
  box domain_;
};

} // namespace graze::octree
