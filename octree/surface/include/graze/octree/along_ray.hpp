#pragma once
/// A surface along a ray: g(t) = f(o + t d), a function of one variable.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <graze/octree/inclusion.hpp>
#include <graze/octree/ray.hpp>
#include <limits>

namespace graze::octree {

/// Where a ray is within a box: the exact [entry, exit] of the ray's parameter, each bounded from
/// both sides. Units: the ray's own parameter.
struct ray_span {
  double entry_down, entry_up, exit_down, exit_up;
  /// Proven: no t is within the box.
  [[nodiscard]] bool empty() const { return entry_down > exit_up; }
};

/// f along one ray, enclosed by intervals of backend B; all of it is called within a scope of B.
template <Surface F, rounding::Backend B> class along_ray {
public:
  using interval = bound<B>;

  along_ray(const F& f, const ray& r) : f_(f), ray_(r) {}

  /// The span of t >= 0 in the closed box b.
  [[nodiscard]] ray_span within(const box& b) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ray_span s{0, 0, infinity, infinity};
    for (int a = 0; a < 3; ++a) {
      const double o = ray_.origin()[a], d = ray_.direction()[a];
      if (d == 0) {
        if (b.lo[a] <= o && o <= b.hi[a])
          continue;
        return {infinity, infinity, -infinity, -infinity};
      }
      const double in = d > 0 ? b.lo[a] : b.hi[a], out = d > 0 ? b.hi[a] : b.lo[a];
      s.entry_down = std::max(s.entry_down, time_down(in, o, d));
      s.entry_up = std::max(s.entry_up, time_up(in, o, d));
      s.exit_down = std::min(s.exit_down, time_down(out, o, d));
      s.exit_up = std::min(s.exit_up, time_up(out, o, d));
    }
    return s;
  }

  /// Encloses { o + t d : first <= t <= last }; finite where both are.
  [[nodiscard]] bound3<B> points(double first, double last) const {
    bound3<B> p;
    for (int a = 0; a < 3; ++a) {
      const double o = ray_.origin()[a], d = ray_.direction()[a];
      if (d == 0)
        p[a] = interval(o);
      else
        p[a] = interval(B::add_down(o, B::mul_down(d > 0 ? first : last, d)),
                        B::add_up(o, B::mul_up(d > 0 ? last : first, d)));
    }
    return p;
  }

  /// The proven sign of g(t); 0 where unknown.
  [[nodiscard]] int sign_at(double t) const {
    return std::isfinite(t) ? certified_sign(natural_extension<B>(f_, points(t, t))) : 0;
  }

  /// Proven: g is continuous on [first, last].
  [[nodiscard]] bool is_continuous_on(double first, double last) const {
    return is_continuous(f_) || octree::is_continuous_on<B>(f_, points(first, last));
  }

  /// The proven sign that g has on all of [first, last]; 0 where it may have a zero there. Decided
  /// by f on the box that the ray runs through, or by the mean value form of g, whose excess falls
  /// with the square of the length.
  [[nodiscard]] int sign_throughout(double first, double last) const {
    if (!std::isfinite(last))
      return 0;
    const dual<interval, 1> g = with_slope(first, last);
    if (const int sign = certified_sign(g.value); sign != 0)
      return sign;
    const double middle = detail::centre<scalar_path<B>>(first, last);
    const interval at_middle = natural_extension<B>(f_, points(middle, middle));
    const interval offset(B::sub_down(first, middle), B::sub_up(last, middle));
    return certified_sign(at_middle + g.partial[0] * offset);
  }

  /// Proven: g is strictly monotone on [first, last].
  [[nodiscard]] bool is_monotone(double first, double last) const {
    return std::isfinite(last) && excludes_zero(with_slope(first, last).partial[0]);
  }

private:
  /// Encloses g and its derivative on [first, last].
  [[nodiscard]] dual<interval, 1> with_slope(double first, double last) const {
    using d = dual<interval, 1>;
    const bound3<B> x = points(first, last);
    std::array<d, 3> moving;
    for (int a = 0; a < 3; ++a)
      moving[a] = {x[a], {interval(ray_.direction()[a])}};
    return f_(moving[0], moving[1], moving[2]);
  }
  // Bounds of (plane - o) / d. The difference may overflow, to an infinite, still valid, bound.
  static double time_down(double plane, double o, double d) {
    return B::div_down(d > 0 ? B::sub_down(plane, o) : B::sub_up(plane, o), d);
  }
  static double time_up(double plane, double o, double d) {
    return B::div_up(d > 0 ? B::sub_up(plane, o) : B::sub_down(plane, o), d);
  }

  const F& f_;
  const ray& ray_;
};

} // namespace graze::octree
