// graze-exhaustive: every ray and every box over a tiny float, judged exactly; counts what the
// sound test, `plain` and `published` miss.
//
// The pairs are counted, not run one by one. The test asks an axis only for the interval of scaled
// t between two planes, so for a direction the (origin, lower, upper) of an axis fall into classes
// of equal computed and equal exact intervals; `passes` is called for every triple of classes, and
// the product of their sizes is the number of pairs that it stands for. Exact: scaled by the
// product of the components' mag, t at a plane is a product of three numbers of a few bits, which a
// double holds.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <graze/exhaustive/tiny_float.hpp>
#include <graze/octree/ray_bounds.hpp>
#include <graze/support/program.hpp>
#include <map>
#include <numeric>
#include <tuple>

using namespace graze;
using namespace graze::octree;

namespace {

/// To nearest, ties to even, overflow to infinity.
template <class T, int Precision, int Emin> T nearest(double exact) {
  if (std::isnan(exact) || std::isinf(exact) || exact == 0)
    return T(exact);
  const double ulp = std::ldexp(1.0, std::max(std::ilogb(exact), Emin) - Precision + 1);
  const double rounded = std::nearbyint(exact / ulp) * ulp;
  if (std::fabs(rounded) > T::largest())
    return T(std::copysign(INFINITY, exact));
  return T(std::copysign(rounded, exact));
}

template <int Precision, int Emin, int Emax> struct run_of {
  using tiny = exhaustive::tiny_float<Precision, Emin, Emax>;
  using directed = exhaustive::tiny_backend<tiny>;
  static tiny near(double exact) { return nearest<tiny, Precision, Emin>(exact); }

  /// Rounded to nearest behind a backend's names.
  struct undirected : directed {
    static tiny sub_down(tiny x, tiny y) { return near(x.value - y.value); }
    static tiny sub_up(tiny x, tiny y) { return near(x.value - y.value); }
    static tiny mul_down(tiny x, tiny y) { return near(x.value * y.value); }
    static tiny mul_up(tiny x, tiny y) { return near(x.value * y.value); }
  };

  /// The template that ships.
  template <class B> struct bounds_by {
    using bounds = ray_bounds<B>;
    using interval = typename bounds::interval;
    static interval within(tiny o, tiny d, tiny other1, tiny other2, tiny lo, tiny hi) {
      return bounds::template within<convention::closed>(bounds::prepare(o, d, other1, other2), lo,
                                                         hi);
    }
    static bool passes(const interval& x, const interval& y, const interval& z) {
      return bounds::passes(x, y, z);
    }
  };

  /// fuzz/peers/paper2005/published.hpp over the tiny float.
  struct published {
    struct interval {
      tiny enter, leave;
    };
    static interval within(tiny o, tiny d, tiny other1, tiny other2, tiny lo, tiny hi) {
      const double sign = d.value < 0 ? -1 : (d.value > 0 ? 1 : 0);
      const tiny c(sign * near(std::fabs(other1.value) * std::fabs(other2.value)).value);
      const auto from = [&](tiny p) { return directed::mul_down(c, near(p.value - o.value)); };
      const auto to = [&](tiny p) { return directed::mul_up(c, near(p.value - o.value)); };
      return c.value < 0 ? interval{from(hi), to(lo)} : interval{from(lo), to(hi)};
    }
    static bool passes(const interval& x, const interval& y, const interval& z) {
      const double upper = std::min({x.leave.value, y.leave.value, z.leave.value});
      return std::max({x.enter.value, y.enter.value, z.enter.value}) < upper && 0 < upper;
    }
  };

  struct tally {
    std::uint64_t pairs = 0, touched = 0, missed = 0, crossed = 0, missed_crossed = 0, spurious = 0,
                  not_a_number = 0, triples = 0;
  };

  template <class Interval> struct axis_class {
    Interval computed;
    double enter, leave; // exact
    std::uint64_t size;
  };

  template <class Method>
  static auto classes(const std::vector<tiny>& values, tiny d, tiny other1, tiny other2) {
    std::map<std::tuple<double, double, double, double>, axis_class<typename Method::interval>>
        found;
    const auto mag = [](tiny x) { return x.value == 0 ? 1 : std::fabs(x.value); };
    const double scale = mag(other1) * mag(other2);
    for (const tiny o : values)
      for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t j = i; j < values.size(); ++j) {
          const tiny lo = values[i], hi = values[j];
          double enter = -INFINITY, leave = INFINITY;
          if (d.value > 0)
            enter = scale * (lo.value - o.value), leave = scale * (hi.value - o.value);
          else if (d.value < 0)
            enter = scale * (o.value - hi.value), leave = scale * (o.value - lo.value);
          else if (o.value < lo.value || hi.value < o.value)
            enter = INFINITY, leave = -INFINITY;
          const auto computed = Method::within(o, d, other1, other2, lo, hi);
          // A key for NaN, which is not equal to itself.
          const auto key = [](double x) { return std::isnan(x) ? 1e300 : x; };
          auto [at, fresh] = found.try_emplace(
              {key(computed.enter.value), key(computed.leave.value), enter, leave},
              axis_class<typename Method::interval>{computed, enter, leave, 0});
          ++at->second.size;
        }
    std::vector<axis_class<typename Method::interval>> result;
    for (const auto& [key, value] : found)
      result.push_back(value);
    return result;
  }

  /// All pairs of one direction.
  template <class Method>
  static void try_direction(const std::vector<tiny>& values, tiny dx, tiny dy, tiny dz,
                            tally& sum) {
    const auto xs = classes<Method>(values, dx, dy, dz), ys = classes<Method>(values, dy, dz, dx),
               zs = classes<Method>(values, dz, dx, dy);
    for (const auto* axis : {&xs, &ys, &zs})
      for (const auto& c : *axis)
        if (std::isnan(c.computed.enter.value) || std::isnan(c.computed.leave.value))
          sum.not_a_number += c.size;
    for (const auto& x : xs)
      for (const auto& y : ys) {
        const double enter = std::max({x.enter, y.enter, 0.0}), leave = std::min(x.leave, y.leave);
        std::uint64_t pairs = 0, touched = 0, missed = 0, crossed = 0, missed_crossed = 0,
                      spurious = 0;
        for (const auto& z : zs) {
          const double from = std::max(enter, z.enter), until = std::min(leave, z.leave);
          const std::uint64_t is_touched = from <= until ? z.size : 0;
          const std::uint64_t is_crossed = from < until ? z.size : 0;
          const bool passed = Method::passes(x.computed, y.computed, z.computed);
          pairs += z.size;
          touched += is_touched;
          crossed += is_crossed;
          missed += passed ? 0 : is_touched;
          missed_crossed += passed ? 0 : is_crossed;
          spurious += passed ? z.size - is_touched : 0;
        }
        const std::uint64_t times = x.size * y.size;
        sum.pairs += times * pairs;
        sum.touched += times * touched;
        sum.missed += times * missed;
        sum.crossed += times * crossed;
        sum.missed_crossed += times * missed_crossed;
        sum.spurious += times * spurious;
      }
    sum.triples += xs.size() * ys.size() * zs.size();
  }

  template <class Method> static tally try_all(const char* name, std::uint64_t wanted) {
    const auto values = tiny::finite();
    const std::uint64_t n = values.size(), all = n * n * n;
    const std::uint64_t count = wanted == 0 || wanted > all ? all : wanted;
    // Spread over all directions, each once: a step of about the golden section, coprime to them.
    auto step = static_cast<std::uint64_t>(0.618 * static_cast<double>(all));
    while (std::gcd(step, all) != 1)
      ++step;
    tally sum;
    const auto started = std::chrono::steady_clock::now();
    for (std::uint64_t i = 0; i < count && !support::stop_wanted; ++i) {
      const std::uint64_t index = i * step % all;
      const tiny d[] = {values[index % n], values[index / n % n], values[index / n / n]};
      if (d[0].value != 0 || d[1].value != 0 || d[2].value != 0)
        try_direction<Method>(values, d[0], d[1], d[2], sum);
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    if (support::stop_wanted)
      return sum;
    support::print("{:<9} {} of {} directions: {} pairs ({} calls of passes), {} touched, "
                   "{} missed; {} crossed, {} missed; {} passed untouched; {} NaN bounds; "
                   "{:.1f} s, {:.3g} pairs/s\n",
                   name, count, all, sum.pairs, sum.triples, sum.touched, sum.missed, sum.crossed,
                   sum.missed_crossed, sum.spurious, sum.not_a_number, seconds,
                   static_cast<double>(sum.pairs) / seconds);
    support::flush_output();
    return sum;
  }

  /// Whether what must hold holds: sound misses nothing, the baselines something.
  static bool holds(std::uint64_t directions) {
    support::print("significand {} bits, exponents {}..{}: {} values\n", Precision, Emin, Emax,
                   tiny::finite().size());
    const tally sound = try_all<bounds_by<directed>>("sound", directions);
    const tally plain = try_all<bounds_by<undirected>>("plain", directions);
    const tally paper = try_all<published>("published", directions);
    return sound.touched > 0 && sound.missed == 0 && sound.not_a_number == 0 && plain.missed > 0 &&
           paper.missed_crossed > 0;
  }
};

int start(int argc, char** argv) {
  CLI::App app{"Every ray and every box over a tiny float, against exact arithmetic"};
  std::uint64_t directions = 0;
  int bits = 2;
  app.add_option("--directions", directions, "that many, evenly spread; all without it")
      ->check(support::whole_number());
  app.add_option("--bits", bits, "significand: 2 (15 values), 3 (31 values) or 4 (63 values)")
      ->check(CLI::IsMember({2, 3, 4}));
  app.footer(
      "Exit codes: 0 sound misses nothing and the baselines do, 1 that is not so, 2 bad input "
      "or a failure, 130 interrupted.");
  if (const auto code = support::parse_arguments(app, argc, argv))
    return *code;
  support::listen_for_interrupts();
  const bool good = bits == 2   ? run_of<2, -1, 1>::holds(directions)
                    : bits == 3 ? run_of<3, -1, 1>::holds(directions)
                                : run_of<4, -1, 1>::holds(directions);
  if (support::interrupted())
    return support::ended_by_signal;
  return good ? support::done : support::found;
}

} // namespace

int main(int argc, char** argv) {
  return support::run_program("graze-exhaustive", argc, argv, start);
}
