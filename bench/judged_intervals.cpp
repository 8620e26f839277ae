#include "judged_intervals.hpp"
#include <cmath>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/ranges.hpp>
#include <map>

namespace graze::bench {

namespace {
namespace ranges = oracle::ranges;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct operation {
  bounds (*range)(const bounds& x, const bounds& y);
  oracle::active_range active; ///< lo == hi: arithmetic, with operands of any size
  oracle::mpfr_function hard;  ///< for arguments whose values are next to a double
};

template <auto f> bounds unary(const bounds& x, const bounds&) { return f(x); }

const std::map<std::string, operation>& operations() {
  static const std::map<std::string, operation> all{
      {"add", {ranges::add, {}, {}}},
      {"sub", {ranges::sub, {}, {}}},
      {"mul", {ranges::mul, {}, {}}},
      {"div", {ranges::div, {}, {}}},
      {"sqr", {unary<ranges::sqr>, {}, {}}},
      {"sqrt", {unary<ranges::sqrt>, {}, {}}},
      {"exp", {unary<ranges::exp>, {-745.2, 709.8}, mpfr_exp}},
      {"log", {unary<ranges::log>, {0, 10}, mpfr_log}},
      {"sin", {unary<ranges::sin>, {-10, 10}, mpfr_sin}},
      {"cos", {unary<ranges::cos>, {-10, 10}, mpfr_cos}},
      {"tan", {unary<ranges::tan>, {-10, 10}, mpfr_tan}},
      {"atan", {unary<ranges::atan>, {-50, 50}, mpfr_atan}},
      {"asin", {unary<ranges::asin>, {-1, 1}, mpfr_asin}},
      {"acos", {unary<ranges::acos>, {-1, 1}, mpfr_acos}},
      {"sinh", {unary<ranges::sinh>, {-710.5, 710.5}, mpfr_sinh}},
      {"cosh", {unary<ranges::cosh>, {-710.5, 710.5}, mpfr_cosh}},
      {"tanh", {unary<ranges::tanh>, {-20, 20}, mpfr_tanh}},
      {"atan2", {ranges::atan2, {-10, 10}, {}}},
      {"pow", {ranges::pow, {0, 10}, {}}},
      {"pown(x,4)",
       {[](const bounds& x, const bounds&) { return ranges::pown(x, 4).value; }, {-10, 10}, {}}},
  };
  return all;
}

/// Two pairs of a kind: the ends of x, and those of y; points in a third of the cases.
class hard_boxes {
public:
  explicit hard_boxes(std::uint64_t seed) : random_(seed) {}
  std::pair<bounds, bounds> next() {
    for (;;) {
      const auto h = static_cast<oracle::hardness>(
          random_.below(static_cast<std::uint64_t>(oracle::hardness::count)));
      const oracle::operands p = random_.next(h), q = random_.below(3) == 0 ? p : random_.next(h);
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(q.x) && std::isfinite(q.y))
        return {{std::min(p.x, q.x), std::max(p.x, q.x)}, {std::min(p.y, q.y), std::max(p.y, q.y)}};
    }
  }

private:
  oracle::hard_operands random_;
};

bounds hard_interval(oracle::hard_arguments& random, const operation& f) {
  if (f.hard && random.below(4) == 0) { // two values that are next to doubles, or one
    const auto hard = [&] {
      return oracle::nearly_a_double(f.hard, random.uniform(f.active.lo, f.active.hi));
    };
    const double a = hard(), b = random.below(2) == 0 ? a : hard();
    if (std::isfinite(a) && std::isfinite(b))
      return {std::min(a, b), std::max(a, b)};
  }
  for (;;) {
    const double a = random.point(f.active);
    const bounds x = random.below(4) == 0 ? bounds{a, a} : random.interval(f.active);
    if (std::isfinite(x.lo) && std::isfinite(x.hi))
      return x;
  }
}

ends ends_of(const bounds& x) { return {x.lo, x.hi, x.lo}; }
} // namespace

operand_set timed_operands(const contender& c, std::size_t count) {
  operand_set set{c.set, make(c.kind, 1), make(c.kind, 2)};
  set.x.resize(std::min(count, size)), set.y.resize(std::min(count, size));
  return set;
}

operand_set points_of(const operand_set& set) {
  operand_set points = set;
  points.name = "points";
  for (auto* operands : {&points.x, &points.y})
    for (ends& e : *operands)
      e.lower = e.upper = e.point;
  return points;
}

operand_set hard_operands_of(const std::string& name, std::size_t count) {
  operand_set set{"hard", {}, {}};
  const operation& f = operations().at(name);
  hard_boxes boxes(1);
  oracle::hard_arguments arguments(1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [x, y] = f.active.lo == f.active.hi
                            ? boxes.next()
                            : std::pair{hard_interval(arguments, f), hard_interval(arguments, f)};
    set.x.push_back(ends_of(x)), set.y.push_back(ends_of(y));
  }
  return set;
}

bool has_judge(const std::string& name) { return operations().contains(name); }

std::vector<bounds> tightest(const std::string& name, const operand_set& set, bool of_points) {
  const operation& f = operations().at(name);
  const auto operand = [&](const ends& e) {
    return of_points ? bounds{e.point, e.point} : bounds{e.lower, e.upper};
  };
  std::vector<bounds> all;
  for (std::size_t i = 0; i < set.x.size(); ++i)
    all.push_back(f.range(operand(set.x[i]), operand(set.y[i])));
  return all;
}

double excess_in_ulps(double bound, double tightest_bound, double other_end) {
  if (bound == tightest_bound)
    return 0;
  const double at = std::fabs(tightest_bound != 0 ? tightest_bound : other_end);
  const long double ulp = at < infinity && at == std::numeric_limits<double>::max()
                              ? 0x1p971
                              : std::nextafter(at, infinity) - at;
  const long double steps =
      std::fabs(static_cast<long double>(bound) - static_cast<long double>(tightest_bound)) / ulp;
  return static_cast<double>(std::min(steps, 0x1p1000L)); // more than any number of doubles
}

verdict judge(const std::vector<enclosure>& answers, const std::vector<bounds>& truth) {
  verdict v;
  std::vector<double> excesses;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bounds& t = truth[i];
    const enclosure& a = answers[i];
    if (t.is_empty())
      continue;
    ++v.judged;
    const bool is_unbounded = !(a.lower <= a.upper) || (a.lower == -infinity && a.lower < t.lo) ||
                              (a.upper == infinity && a.upper > t.hi);
    if (a.lower > t.lo || a.upper < t.hi) {
      if (v.unsound++ == 0)
        v.example = i;
    } else if (is_unbounded) {
      ++v.unbounded;
    } else {
      const double other_below = std::isfinite(t.hi) ? t.hi : t.lo;
      const double other_above = std::isfinite(t.lo) ? t.lo : t.hi;
      const double e =
          excess_in_ulps(a.lower, t.lo, other_below) + excess_in_ulps(a.upper, t.hi, other_above);
      v.tight += e == 0;
      v.worst_excess = std::max(v.worst_excess, e);
      excesses.push_back(e);
    }
  }
  if (excesses.empty())
    return v;
  for (const double e : excesses)
    v.mean_excess += e / static_cast<double>(excesses.size());
  const auto middle = excesses.begin() + static_cast<std::ptrdiff_t>(excesses.size() / 2);
  std::nth_element(excesses.begin(), middle, excesses.end());
  v.median_excess = *middle;
  return v;
}

} // namespace graze::bench
