#pragma once
/// The asterisks: sin(m theta) sin(n phi) = R in spherical coordinates, theta = atan2(y, x), phi
/// the angle from +z, R the distance from the origin.
///
/// The sines are Chebyshev's polynomials of the cosines of angles, which are ratios of coordinates:
///     sin(m theta) = (-1)^((m-1)/2) T_m(sin theta), m odd, sin theta = y / rho, rho^2 = x^2 + y^2,
///     sin(n phi) = T_n(cos(phi - pi/(2n))),  cos(phi - b) = (z cos b + rho sin b) / R,
/// so that no angle is computed: there is no branch cut, and each sine's enclosure is its range but
/// for rounding, since the angles of a box run between those of two of its corners, and T_m and T_n
/// are compositions of T_2 and T_3, each taken by its monotone pieces.
///
/// On the axis x = y = 0 theta is not defined, but sin(n phi) is 0 there: f = -R, which makes f
/// continuous off the origin. At the origin f is set to 0: it belongs to the surface, whose closure
/// holds it. With that, opposite signs at two points mean a zero on the segment between them, and
/// in every box that has both: a segment without the origin is one on which f is continuous, and
/// one with it has the origin's zero. Derivatives are not bounded where a box holds the origin.
#include <graze/needs_cxx20.hpp>

#include <cmath>
#include <graze/octree/dual.hpp>
#include <graze/octree/surface.hpp>
#include <limits>

namespace graze::octree {

/// A direction b in the half-plane (rho, z), by an enclosure of its cosine and sine. pi/(2n) for n
/// = 4, 18; their digits are compared with MPFR's in the tests.
template <int N> struct direction_of_sine;
template <> struct direction_of_sine<4> { // pi/8
  static constexpr rational_bounds cosine{0x1.d906bcf328d46p-1, 0x1.d906bcf328d47p-1,
                                          0x1.d906bcf328d46p-1};
  static constexpr rational_bounds sine{0x1.87de2a6aea962p-2, 0x1.87de2a6aea963p-2,
                                        0x1.87de2a6aea963p-2};
};
template <> struct direction_of_sine<18> { // pi/36
  static constexpr rational_bounds cosine{0x1.fe0d3b41815a1p-1, 0x1.fe0d3b41815a2p-1,
                                          0x1.fe0d3b41815a2p-1};
  static constexpr rational_bounds sine{0x1.64fd6b8c28102p-4, 0x1.64fd6b8c28103p-4,
                                        0x1.64fd6b8c28103p-4};
};

/// What an asterisk asks of a number type: double, and intervals below; eight of them with
/// asterisk_eight.hpp. Over a type without it the surface is evaluated by its sines.
template <class N> struct angular;

template <> struct angular<double> {
  static double magnitude(double x) { return std::fabs(x); }
  static double root(double x) { return std::sqrt(x); }
  static double reciprocal(double x) { return 1 / x; }
  static double cosine(double z, double rho) {
    const double length = std::hypot(z, rho);
    return length == 0 ? 0 : z / length;
  }
  /// The cosine of the angle between (z, rho) and a direction; of the angle at the origin, 0.
  static double cosine_to(double z, double rho, const rational_bounds& cosine,
                          const rational_bounds& sine) {
    const double length = std::hypot(z, rho);
    return length == 0 ? 0 : (z * cosine.nearest + rho * sine.nearest) / length;
  }
  /// T_3(t) = 4 t^3 - 3 t, -1 <= t <= 1.
  static double third(double t) { return t * (4 * t * t - 3); }
  /// x, which is known to be in [-limit, limit].
  static double limited(double x, double) { return x; }
};

namespace detail {
/// Over the lanes of a register.
template <class P> struct angular_lanes {
  using vector = typename P::vector;
  using mask = typename P::mask;
  using part = batch::part<P>;

  static GRAZE_BATCH_INLINE part lower_end(const part& x) { return {x.lo, x.lo}; }
  static GRAZE_BATCH_INLINE part upper_end(const part& x) { return {x.hi, x.hi}; }
  /// rho at the corner of the box at which the angle from +z is least, and greatest.
  static GRAZE_BATCH_INLINE part near_rho(const part& z, const part& rho) {
    return end(P::select(P::less_equal(P::zero(), z.hi), rho.lo, rho.hi));
  }
  static GRAZE_BATCH_INLINE part far_rho(const part& z, const part& rho) {
    return end(P::select(P::less_equal(P::zero(), z.lo), rho.hi, rho.lo));
  }
  /// The hull of a and b, cut to [-1, 1]; up to 1 where a and above may be >= 0 and below may be
  /// <= 0.
  static GRAZE_BATCH_INLINE part between(const part& a, const part& b, const part& above,
                                         const part& below) {
    const vector one = P::broadcast(1), minus = P::broadcast(-1);
    const vector lo = P::min_or_second(a.lo, b.lo), hi = P::max_or_second(a.hi, b.hi);
    const mask turns =
        P::both(P::less_equal(P::zero(), a.hi),
                P::both(P::less_equal(P::zero(), above.hi), P::less_equal(below.lo, P::zero())));
    // a NaN, of a corner in the origin, fails the comparisons
    const mask known = P::both(P::less_equal(a.lo, a.hi), P::less_equal(b.lo, b.hi));
    const mask low = P::both(known, P::less(minus, lo)), high = P::both(known, P::less(hi, one));
    return {P::select(low, lo, minus), P::select(high, P::select(turns, one, hi), one)};
  }
  /// The hull of a and b, cut to [-1, 1]; to 1 where t has -1/2, and to -1 where it has 1/2.
  static GRAZE_BATCH_INLINE part turned(const part& t, const part& a, const part& b) {
    const vector one = P::broadcast(1), minus = P::broadcast(-1), half = P::broadcast(0.5),
                 minus_half = P::broadcast(-0.5);
    const vector lo = P::min_or_second(a.lo, b.lo), hi = P::max_or_second(a.hi, b.hi);
    const mask falls = P::both(P::less_equal(t.lo, half), P::less_equal(half, t.hi)),
               rises = P::both(P::less_equal(t.lo, minus_half), P::less_equal(minus_half, t.hi));
    return {P::select(P::less(minus, lo), P::select(falls, minus, lo), minus),
            P::select(P::less(hi, one), P::select(rises, one, hi), one)};
  }
  static GRAZE_BATCH_INLINE part limited(const part& x, const part& limit) {
    const vector most = limit.hi, least = P::neg(most);
    return {P::select(P::less(least, x.lo), x.lo, least),
            P::select(P::less(x.hi, most), x.hi, most)};
  }

private:
  /// v as an interval; infinity is no number, and stands for all beyond the doubles.
  static GRAZE_BATCH_INLINE part end(const vector& v) {
    return {P::min_or_second(P::broadcast(std::numeric_limits<double>::max()), v), v};
  }
};

/// Intervals and eight intervals.
template <class I> struct angular_intervals {
  using per_lane = angular_lanes<typename lanewise<I>::path>;
  using formulas = batch::formulas<typename lanewise<I>::path>;
  template <auto Operation, class... Operands>
  static GRAZE_BATCH_INLINE I each(const Operands&... x) {
    return lanewise<I>::template apply<Operation>(x...);
  }

  static GRAZE_BATCH_INLINE I bounds_of(const rational_bounds& c) { return I(c.lo, c.hi); }
  static GRAZE_BATCH_INLINE I magnitude(const I& x) { return each<&formulas::abs>(x); }
  static GRAZE_BATCH_INLINE I root(const I& x) { return sqrt(x); }
  static GRAZE_BATCH_INLINE I reciprocal(const I& x) { return I(1.0) / x; }
  static GRAZE_BATCH_INLINE I limited(const I& x, const I& limit) {
    return each<&per_lane::limited>(x, limit);
  }

  /// z / sqrt(z^2 + rho^2), rho >= 0: the cosine of the angle from +z, which falls with it.
  static I cosine(const I& z, const I& rho) {
    const auto at = [](const I& u, const I& v) { return u / root(sqr(u) + sqr(v)); };
    I u, v, p, q;
    corner(z, rho, false, u, v);
    corner(z, rho, true, p, q);
    const I nowhere = constants<I>::exact(-1);
    return each<&per_lane::between>(at(u, v), at(p, q), nowhere, nowhere);
  }
  /// rho >= 0; the direction is between +z and +rho. It is within the box's angles, and 1 is
  /// reached, if it is not nearer to +z than the first corner, nor further than the last; the first
  /// is then less than a right angle from it.
  static I cosine_to(const I& z, const I& rho, const rational_bounds& cosine,
                     const rational_bounds& sine) {
    const I c = bounds_of(cosine), s = bounds_of(sine);
    I u, v, p, q;
    corner(z, rho, false, u, v);
    corner(z, rho, true, p, q);
    return each<&per_lane::between>((u * c + v * s) / root(sqr(u) + sqr(v)),
                                    (p * c + q * s) / root(sqr(p) + sqr(q)), u * s - v * c,
                                    p * s - q * c);
  }
  /// T_3 rises to 1 at -1/2, falls to -1 at 1/2, and rises.
  static I third(const I& t) {
    const I a = each<&per_lane::lower_end>(t), b = each<&per_lane::upper_end>(t);
    const I three = constants<I>::exact(3);
    const auto at = [&](const I& x) {
      const I y = x + x;
      return x * (sqr(y) - three);
    };
    return each<&per_lane::turned>(t, at(a), at(b));
  }

private:
  /// The corner (u, v) of the box at which the angle from +z is least or, `far`, greatest.
  static GRAZE_BATCH_INLINE void corner(const I& z, const I& rho, bool far, I& u, I& v) {
    u = far ? each<&per_lane::lower_end>(z) : each<&per_lane::upper_end>(z);
    v = far ? each<&per_lane::far_rho>(z, rho) : each<&per_lane::near_rho>(z, rho);
  }
};
} // namespace detail

template <class Policies>
struct angular<boost::numeric::interval<double, Policies>>
    : detail::angular_intervals<boost::numeric::interval<double, Policies>> {};

/// sin(M theta) sin(N phi) - R. M: 3 or 9. N: 4 or 18.
template <int M, int N> struct asterisk {
  static_assert(M == 3 || M == 9, "an odd power of 3");
  static_assert(N == 4 || N == 18, "composed of 2 and 3");
  /// The factors' enclosures are tight. The mean value form leaves out 9 to 14 % of the octants and
  /// costs twice the time (graze-inclusion-bench).
  static constexpr bool natural_extension_suffices = true;
  static constexpr bool is_algebraic = false;

  template <class T> T operator()(const T& x, const T& y, const T& z) const {
    if constexpr (!requires { sizeof(angular<T>); })
      return by_sines(x, y, z);
    else
      return by_polynomials(x, y, z);
  }

  /// By the derivatives in spherical coordinates, where cosines of multiples are polynomials too:
  ///   f_x = -y/rho A' B/rho + A B' (x/rho) (z/R) / R - x/R
  ///   f_y =  x/rho A' B/rho + A B' (y/rho) (z/R) / R - y/R
  ///   f_z = -A B' (rho/R) / R - z/R
  /// with A = sin(m theta), A' = m cos(m theta), B = sin(n phi), B' = n cos(n phi). Near the axis
  /// |B/rho| = |sin(n phi) / sin(phi)| / R is at most n/R.
  template <class T, std::size_t P>
  dual<T, P> operator()(const dual<T, P>& x, const dual<T, P>& y, const dual<T, P>& z) const {
    using a = angular<T>;
    const T square = sqr(x.value) + sqr(y.value);
    const T rho = a::root(square), distance = a::root(square + sqr(z.value)),
            inverse = a::reciprocal(distance);
    const T sine_m = sine_of_m(x.value, y.value), sine_n = sine_of_n(rho, z.value);
    const T cosine = a::cosine(x.value, a::magnitude(y.value)),
            sine = a::cosine(y.value, a::magnitude(x.value)), height = a::cosine(z.value, rho),
            breadth = a::limited(rho * inverse, constants<T>::exact(1));
    const T around = constants<T>::exact(M) * multiple<M>(cosine),
            over = constants<T>::exact(N) * multiple<N>(height);
    const T slope =
        around * a::limited(sine_n * a::reciprocal(rho), constants<T>::exact(N) * inverse);
    const T fall = sine_m * over * inverse;
    const T slopes[] = {fall * cosine * height - sine * slope - cosine_in_ball(x.value, inverse),
                        fall * sine * height + cosine * slope - cosine_in_ball(y.value, inverse),
                        -(fall * breadth) - height};
    dual<T, P> r{sine_m * sine_n - distance, {}};
    for (std::size_t i = 0; i < P; ++i)
      r.partial[i] = slopes[0] * x.partial[i] + slopes[1] * y.partial[i] + slopes[2] * z.partial[i];
    return r;
  }

private:
  template <class T> static T by_polynomials(const T& x, const T& y, const T& z) {
    using a = angular<T>;
    const T square = sqr(x) + sqr(y);
    return sine_of_m(x, y) * sine_of_n(a::root(square), z) - a::root(square + sqr(z));
  }

  template <class T> static T by_sines(const T& x, const T& y, const T& z) {
    using std::atan2, std::sin, std::sqrt;
    const T zero_of_type(0), square = x * x + y * y;
    const T rho = sqrt(square), distance = sqrt(T(square + z * z));
    if (rho == zero_of_type)
      return T(-distance);
    return T(sin(T(M * atan2(y, x))) * sin(T(N * atan2(rho, z))) - distance);
  }

  /// T_K(cos t) = cos(K t).
  template <int K, class T> static T multiple(const T& t) {
    if constexpr (K == 1)
      return t;
    else if constexpr (K % 3 == 0)
      return angular<T>::third(multiple<K / 3>(t));
    else {
      const T half = sqr(multiple<K / 2>(t));
      return half + half - constants<T>::exact(1);
    }
  }
  template <class T> static T sine_of_m(const T& x, const T& y) {
    const T sine = multiple<M>(angular<T>::cosine(y, angular<T>::magnitude(x)));
    if constexpr (M % 4 == 3)
      return -sine;
    else
      return sine;
  }
  template <class T> static T sine_of_n(const T& rho, const T& z) {
    return multiple<N>(
        angular<T>::cosine_to(z, rho, direction_of_sine<N>::cosine, direction_of_sine<N>::sine));
  }
  /// x/R, which is in [-1, 1].
  template <class T> static T cosine_in_ball(const T& x, const T& inverse) {
    return angular<T>::limited(x * inverse, constants<T>::exact(1));
  }
};

} // namespace graze::octree
