#pragma once
/// What a line meets between planes, fast and exact: arrivals are fractions of GMP's integers over
/// one power of two, compared as such where doubles with room to spare do not tell. A second judge
/// beside rational.hpp, which judges a part of its answers.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gmpxx.h>
#include <optional>
#include <vector>

namespace graze::grid_tests {

class dyadic_judge {
public:
  static constexpr unsigned most_planes = 5; ///< an axis
  using triple = std::array<std::uint8_t, 3>;

  /// Planes in order, two to five an axis, each a dyadic number.
  void planes_are(const std::array<std::vector<mpq_class>, 3>& planes) {
    scene_scale_ = 0;
    const auto bits_below = [](const mpq_class& x) {
      return static_cast<int>(mpz_sizeinbase(x.get_den_mpz_t(), 2)) - 1;
    };
    for (const auto& axis : planes)
      for (const mpq_class& p : axis)
        scene_scale_ = std::max(scene_scale_, bits_below(p));
    for (unsigned a = 0; a < 3; ++a) {
      count_[a] = static_cast<unsigned>(planes[a].size());
      for (unsigned i = 0; i < count_[a]; ++i)
        mpz_mul_2exp(plane_[a][i].get_mpz_t(), planes[a][i].get_num_mpz_t(),
                     static_cast<unsigned>(scene_scale_ - bits_below(planes[a][i])));
    }
  }

  /// from + t (toward - from) where between, else from + t toward; last may be infinite.
  void line_is(const std::array<double, 3>& from, const std::array<double, 3>& toward, bool between,
               double first, double last) {
    int scale = scene_scale_, speed_scale = 0;
    for (unsigned a = 0; a < 3; ++a) {
      scale = std::max(scale, bits_below(from[a]));
      speed_scale = std::max(speed_scale, bits_below(toward[a]));
    }
    if (between)
      scale = speed_scale = std::max(scale, speed_scale);
    for (unsigned a = 0; a < 3; ++a) {
      set(origin_, from[a], scale);
      set(speed_[a], toward[a], speed_scale);
      if (between)
        speed_[a] -= origin_;
      heading_[a] = mpz_sgn(speed_[a].get_mpz_t());
      mpz_abs(speed_[a].get_mpz_t(), speed_[a].get_mpz_t());
      for (unsigned i = 0; i < count_[a]; ++i) {
        mpz_class& n = event_[id(a, i)].numerator;
        mpz_mul_2exp(n.get_mpz_t(), plane_[a][i].get_mpz_t(),
                     static_cast<unsigned>(scale - scene_scale_));
        n -= origin_;
        if (heading_[a] < 0)
          mpz_neg(n.get_mpz_t(), n.get_mpz_t());
        if (heading_[a] != 0)
          measure(event_[id(a, i)], speed_[a]);
      }
    }
    unit_ = scale - speed_scale; // t = numerator / denominator 2^-unit
    set_limit(event_[first_id], limit_speed_[0], first);
    bounded_ = last < INFINITY;
    if (bounded_)
      set_limit(event_[last_id], limit_speed_[1], last);
    std::memset(order_.data(), unknown, order_.size());
  }

  /// The line has a point between planes lower[a] and upper[a]; bits of the masks: these planes
  /// belong to the cell.
  bool meets(const triple& lower, const triple& upper, unsigned lower_closed,
             unsigned upper_closed) {
    std::array<end, 4> enter, leave;
    unsigned n = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const bool with_lower = (lower_closed >> a & 1) != 0,
                 with_upper = (upper_closed >> a & 1) != 0;
      if (heading_[a] == 0) {
        const int from = mpz_sgn(event_[id(a, lower[a])].numerator.get_mpz_t()),
                  until = mpz_sgn(event_[id(a, upper[a])].numerator.get_mpz_t());
        if (from > 0 || until < 0 || (from == 0 && !with_lower) || (until == 0 && !with_upper))
          return false;
        continue;
      }
      const end low{id(a, lower[a]), with_lower}, high{id(a, upper[a]), with_upper};
      enter[n] = heading_[a] > 0 ? low : high;
      leave[n++] = heading_[a] > 0 ? high : low;
    }
    const unsigned axes = n;
    enter[axes] = {first_id, true};
    if (bounded_)
      leave[n++] = {last_id, true};
    for (unsigned i = 0; i <= axes; ++i)
      for (unsigned j = 0; j < n; ++j) {
        const int sign = order(enter[i].event, leave[j].event);
        if (sign > 0 || (sign == 0 && !(enter[i].closed && leave[j].closed)))
          return false;
      }
    return true;
  }

  /// Of a cell that is touched: the first and the last of the t, and the faces reached there.
  struct part {
    unsigned first, last, entered, left; ///< events, and bits 2 axis + (upper)
  };
  part part_in(const triple& lower, const triple& upper) {
    part p{first_id, last_id, 0, 0};
    bool bounded = bounded_;
    for (unsigned a = 0; a < 3; ++a) {
      if (heading_[a] == 0)
        continue;
      const bool forward = heading_[a] > 0;
      const unsigned near = id(a, forward ? lower[a] : upper[a]),
                     far = id(a, forward ? upper[a] : lower[a]);
      const unsigned near_face = (forward ? 1u : 2u) << (2 * a), far_face = (forward ? 2u : 1u)
                                                                            << (2 * a);
      const int late = order(near, p.first);
      if (late >= 0)
        p.entered = (late == 0 ? p.entered : 0) | near_face;
      if (late > 0)
        p.first = near;
      const int early = bounded ? order(far, p.last) : -1;
      if (early <= 0)
        p.left = (early == 0 ? p.left : 0) | far_face;
      if (early < 0)
        p.last = far;
      bounded = true;
    }
    return p;
  }
  /// The sign of x - y, of events.
  int order(unsigned x, unsigned y) {
    std::int8_t& known = order_[x * events + y];
    if (known == unknown)
      known = static_cast<std::int8_t>(compare(event_[x], speed_of(x), event_[y], speed_of(y)));
    return known;
  }
  /// The sign of an event's t less `t`.
  int order_with(unsigned x, double t) {
    if (std::isinf(t))
      return t > 0 ? -1 : 1;
    set_limit(bound_, bound_speed_, t);
    return compare(event_[x], speed_of(x), bound_, bound_speed_);
  }
  std::uint64_t exactly = 0; ///< comparisons of integers

private:
  struct event {
    mpz_class numerator;
    long double about; ///< to 2^-50 of it
  };
  struct end {
    unsigned event;
    bool closed;
  };
  static constexpr unsigned first_id = 3 * most_planes, last_id = first_id + 1,
                            events = first_id + 2;
  static constexpr std::int8_t unknown = 2;
  static unsigned id(unsigned axis, unsigned plane) { return axis * most_planes + plane; }
  const mpz_class& speed_of(unsigned x) const {
    return x < first_id ? speed_[x / most_planes] : limit_speed_[x - first_id];
  }

  static int bits_below(double x) {
    if (x == 0)
      return 0;
    int e = 0;
    const auto n = static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(x), &e), 53));
    return std::max(0, 53 - e - __builtin_ctzll(static_cast<unsigned long long>(n)));
  }
  /// x 2^scale, an integer.
  static void set(mpz_class& z, double x, int scale) {
    int e = 0;
    const double f = std::frexp(x, &e);
    mpz_set_si(z.get_mpz_t(), static_cast<long>(std::ldexp(f, 53)));
    const int shift = e - 53 + scale;
    if (shift >= 0)
      mpz_mul_2exp(z.get_mpz_t(), z.get_mpz_t(), static_cast<unsigned>(shift));
    else
      mpz_tdiv_q_2exp(z.get_mpz_t(), z.get_mpz_t(), static_cast<unsigned>(-shift));
  }
  void set_limit(event& e, mpz_class& speed, double t) const {
    const int below = bits_below(t);
    set(e.numerator, t, below);
    speed = 1; // t = numerator 2^-below
    const int shift = unit_ - below;
    mpz_class& larger = shift >= 0 ? e.numerator : speed;
    mpz_mul_2exp(larger.get_mpz_t(), larger.get_mpz_t(), static_cast<unsigned>(std::abs(shift)));
    measure(e, speed);
  }
  static void measure(event& e, const mpz_class& speed) {
    long of_n = 0, of_d = 0;
    const double n = mpz_get_d_2exp(&of_n, e.numerator.get_mpz_t()),
                 d = mpz_get_d_2exp(&of_d, speed.get_mpz_t());
    e.about = std::ldexp(static_cast<long double>(n) / static_cast<long double>(d),
                         static_cast<int>(of_n - of_d));
  }
  int compare(const event& x, const mpz_class& x_speed, const event& y, const mpz_class& y_speed) {
    const long double difference = x.about - y.about,
                      room = (std::fabs(x.about) + std::fabs(y.about)) * 0x1p-48L;
    if (std::fabs(difference) > room)
      return difference < 0 ? -1 : 1;
    ++exactly;
    mpz_mul(p_.get_mpz_t(), x.numerator.get_mpz_t(), y_speed.get_mpz_t());
    mpz_mul(q_.get_mpz_t(), y.numerator.get_mpz_t(), x_speed.get_mpz_t());
    const int sign = mpz_cmp(p_.get_mpz_t(), q_.get_mpz_t());
    return (sign > 0) - (sign < 0);
  }

  int scene_scale_ = 0, unit_ = 0;
  std::array<unsigned, 3> count_{};
  std::array<std::array<mpz_class, most_planes>, 3> plane_;
  std::array<event, events> event_;
  std::array<mpz_class, 3> speed_;
  std::array<mpz_class, 2> limit_speed_;
  std::array<int, 3> heading_{};
  bool bounded_ = false;
  std::array<std::int8_t, events * events> order_{};
  mpz_class origin_, p_, q_, bound_speed_;
  event bound_;
};

} // namespace graze::grid_tests
