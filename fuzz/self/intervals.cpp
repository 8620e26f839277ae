/// The subject `intervals`: arithmetic, sets and reverse operations of IEEE 1788.1, and arithmetic
/// by every backend.
#include <cmath>
#include <graze/decorated_functions.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <self/backend_operations.hpp>
#include <self/operands.hpp>
#include <self/value_of.hpp>
#if defined(__x86_64__)
#include <graze/rounding/split.hpp>
#endif

namespace graze::fuzz::self {

namespace {

namespace ranges = oracle::ranges;
namespace reverse = oracle::reverse;

/// By a tightest enclosure on as many operands as `right` takes.
template <class Right> auto judge_by(Right right) {
  return [right](const interval_operands& o, const bounds& got, observations& out) {
    const auto& [x, y, z] = o.boxes;
    if constexpr (requires { right(x, y, z); })
      compare("", right(x, y, z), got, out);
    else if constexpr (requires { right(x, y); })
      compare("", right(x, y), got, out);
    else
      compare("", right(x), got, out);
  };
}

template <class F, class Right>
interval_operation on_boxes(const char* name, unsigned count, Right right) {
  interval_operation o;
  o.name = name;
  o.generate = [count](std::uint64_t seed, std::uint64_t index) {
    return hard_operands_of(count, seed_of_trial(seed, index));
  };
  o.value = value_of<F>;
  o.judge = judge_by(right);
  return o;
}

/// Operands about integers and half-integers, small and near 2^52.
interval_operands near_integers(std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t s = seed_of_trial(seed, index);
  oracle::hard_operands make(s);
  if (make.below(4) == 0)
    return hard_operands_of(1, s);
  const auto end = [&] {
    const double base = make.coin()
                            ? static_cast<double>(make.below(8)) / 2
                            : std::ldexp(1, 50) + static_cast<double>(make.below(64)) / 2 - 8;
    const double x = make.coin() ? make.nudged(base) : base;
    return make.coin() ? -x : x;
  };
  const double a = end(), b = make.coin() ? a : end();
  return {{bounds{std::min(a, b), std::max(a, b)}}};
}
template <class F>
interval_operation step_function(const char* name, bounds (*right)(const bounds&)) {
  interval_operation o = on_boxes<F>(name, 1, right);
  o.generate = near_integers;
  return o;
}

/// Two boxes nearly as wide as each other.
interval_operands nearly_as_wide(std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t s = seed_of_trial(seed, index);
  interval_operands o = hard_operands_of(2, s);
  oracle::hard_operands make(~s);
  const bounds& x = o.boxes[0];
  if (make.below(4) == 0 || !x.is_common())
    return o;
  const int exponent = std::isnormal(x.hi) ? std::ilogb(x.hi) : 0;
  const double shift =
      make.coin() ? make.with_exponent(exponent - static_cast<int>(make.below(60))) : 0;
  const double a = make.nudged(x.lo + shift), b = make.nudged(x.hi + shift);
  if (a <= b && std::isfinite(a) && std::isfinite(b))
    o.boxes[1] = {a, b};
  return o;
}
template <class F>
interval_operation cancellation(const char* name, bounds (*right)(const bounds&, const bounds&),
                                bool negated) {
  interval_operation o = on_boxes<F>(name, 2, right);
  o.generate = [negated](std::uint64_t seed, std::uint64_t index) {
    interval_operands x = nearly_as_wide(seed, index);
    if (negated)
      x.boxes[1] = {-x.boxes[1].hi, -x.boxes[1].lo};
    return x;
  };
  return o;
}

void report(reverse::judgement j, const bounds& got, observations& out) {
  if (j != reverse::judgement::tightest)
    out.push_back(
        {j == reverse::judgement::unsound ? flaw::unsound : flaw::loose, "= " + text_of(got)});
}

/// A reverse operation whose operands are a reverse_case's: u first, if it has one.
template <class F, class Make, class Judge>
interval_operation algebraic(const char* name, Make make, Judge judge, bool has_u) {
  interval_operation o;
  o.name = name;
  o.generate = [make, has_u, with_n = std::is_same_v<F, functions::pown_rev>](std::uint64_t seed,
                                                                              std::uint64_t index) {
    reverse::algebraic_operands source(seed_of_trial(seed, index));
    reverse::reverse_case c = make(source);
    if (source.below(32) == 0)
      (source.coin() ? c.c : c.x) = bounds::empty();
    if (has_u && source.below(64) == 0)
      c.u = bounds::empty();
    interval_operands x;
    x.boxes = has_u ? std::array{c.u, c.c, c.x} : std::array{c.c, c.x, bounds::empty()};
    x.count = has_u ? 3 : 2;
    x.n = c.n;
    x.has_n = with_n;
    return x;
  };
  o.value = value_of<F>;
  o.judge = [judge, has_u](const interval_operands& x, const bounds& got, observations& out) {
    if (has_u && x.boxes[0].is_empty())
      return compare("", bounds::empty(), got, out);
    report(judge(x).judge(x.boxes[has_u ? 2 : 1], got), got, out);
  };
  return o;
}

template <class F>
interval_operation trigonometric(const char* name, reverse::wave f,
                                 bounds (*right)(const bounds&, const bounds&)) {
  interval_operation o = on_boxes<F>(name, 2, right);
  o.generate = [f](std::uint64_t seed, std::uint64_t index) {
    reverse::trigonometric_operands source(seed_of_trial(seed, index));
    const auto c = source.next(f);
    interval_operands x{{c.c, c.x}};
    x.count = 2;
    if (source.below(32) == 0)
      x.boxes[source.below(2)] = bounds::empty();
    return x;
  };
  return o;
}

std::vector<interval_operation> of_the_standard() {
  namespace f = functions;
  constexpr double largest = std::numeric_limits<double>::max();
  using operands = interval_operands;
  using source = reverse::algebraic_operands;
#define GRAZE_ON_BOXES(name, count) on_boxes<f::name>(#name, count, ranges::name)
#define GRAZE_STEP(name) step_function<f::name>(#name, ranges::name)
  return {
      GRAZE_ON_BOXES(pos, 1),
      GRAZE_ON_BOXES(neg, 1),
      GRAZE_ON_BOXES(add, 2),
      GRAZE_ON_BOXES(sub, 2),
      GRAZE_ON_BOXES(mul, 2),
      GRAZE_ON_BOXES(div, 2),
      GRAZE_ON_BOXES(recip, 1),
      GRAZE_ON_BOXES(sqr, 1),
      GRAZE_ON_BOXES(sqrt, 1),
      GRAZE_ON_BOXES(fma, 3),
      GRAZE_ON_BOXES(abs, 1),
      GRAZE_ON_BOXES(min, 2),
      GRAZE_ON_BOXES(max, 2),
      GRAZE_STEP(sign),
      GRAZE_STEP(ceil),
      GRAZE_STEP(floor),
      GRAZE_STEP(trunc),
      GRAZE_STEP(round_ties_to_even),
      GRAZE_STEP(round_ties_to_away),
      GRAZE_ON_BOXES(intersection, 2),
      GRAZE_ON_BOXES(convex_hull, 2),
      cancellation<f::cancel_minus>("cancel_minus", ranges::cancel_minus, false),
      cancellation<f::cancel_plus>("cancel_plus", ranges::cancel_plus, true),
      algebraic<f::sqr_rev>(
          "sqr_rev", [](source& s) { return s.even(reverse::sqr_at, 0, 0x1p512); },
          [](const operands& o) { return reverse::of_sqr(o.boxes[0]); }, false),
      algebraic<f::abs_rev>(
          "abs_rev", [](source& s) { return s.even(reverse::abs_at, 0, largest); },
          [](const operands& o) { return reverse::of_abs(o.boxes[0]); }, false),
      algebraic<f::cosh_rev>(
          "cosh_rev", [](source& s) { return s.even(reverse::cosh_at, 1, 710); },
          [](const operands& o) { return reverse::of_cosh(o.boxes[0]); }, false),
      algebraic<f::pown_rev>(
          "pown_rev", [](source& s) { return s.pown(); },
          [](const operands& o) { return reverse::of_pown(o.boxes[0], o.n); }, false),
      trigonometric<f::sin_rev>("sin_rev", reverse::wave::sin, reverse::sin_rev),
      trigonometric<f::cos_rev>("cos_rev", reverse::wave::cos, reverse::cos_rev),
      trigonometric<f::tan_rev>("tan_rev", reverse::wave::tan, reverse::tan_rev),
      algebraic<f::mul_rev>(
          "mul_rev", [](source& s) { return s.mul(); },
          [](const operands& o) { return reverse::of_mul(o.boxes[0], o.boxes[1]); }, true),
      algebraic<f::pow_rev1>(
          "pow_rev1",
          [](source& s) {
            reverse::reverse_case c = s.pow();
            std::swap(c.u, c.x); // the base is looked for
            return c;
          },
          [](const operands& o) { return reverse::of_pow1(o.boxes[0], o.boxes[1]); }, true),
      algebraic<f::pow_rev2>(
          "pow_rev2", [](source& s) { return s.pow(); },
          [](const operands& o) { return reverse::of_pow2(o.boxes[0], o.boxes[1]); }, true),
  };
#undef GRAZE_ON_BOXES
#undef GRAZE_STEP
}

/// The two-output division: each piece is the tightest on its side of 0.
interval_operation first_of_pair() {
  interval_operation o;
  o.name = "mul_rev_to_pair";
  o.generate = [](std::uint64_t seed, std::uint64_t index) {
    reverse::algebraic_operands source(seed_of_trial(seed, index));
    const reverse::reverse_case c = source.mul();
    interval_operands x{{c.u, c.c}};
    x.count = 2;
    return x;
  };
  o.value = [](const interval_operands& x) {
    return functions::mul_rev_to_pair::value(x.boxes[0], x.boxes[1]).first;
  };
  o.judge = [](const interval_operands& x, const bounds& first, observations& out) {
    const bounds second = functions::mul_rev_to_pair::value(x.boxes[0], x.boxes[1]).second;
    const reverse::reverse_judge solutions = reverse::of_mul(x.boxes[0], x.boxes[1]);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (second.is_empty())
      return report(solutions.judge(bounds::entire(), first), first, out);
    if (solutions.is_solution(0))
      out.push_back({flaw::unsound, "in two pieces, though 0 is a solution"});
    report(solutions.judge({-infinity, 0}, first), first, out);
    report(solutions.judge({0, infinity}, second), second, out);
  };
  return o;
}

// --- arithmetic by the backends -----------------------------------------------------------------

/// The operators and functions of an interval type, one of them a trial.
template <class I> interval_operation operators(std::string name) {
  using P = typename I::traits_type;
  enum {
    add,
    sub,
    mul,
    div,
    square,
    root,
    magnitude,
    least,
    greatest,
    common,
    joined,
    scaled,
    over
  };
  static constexpr std::array names{"+",   "-",   "*",         "/",    "sqr",      "sqrt",    "abs",
                                    "min", "max", "intersect", "hull", "number *", "/ number"};
  interval_operation o;
  o.name = std::move(name);
  o.generate = [](std::uint64_t seed, std::uint64_t index) {
    const std::uint64_t s = seed_of_trial(seed, index);
    interval_operands x = hard_operands_of(2, s);
    x.n = static_cast<int>(mix(s) % names.size());
    x.has_n = true;
    return x;
  };
  o.value = [](const interval_operands& given) {
    const I x = to_interval<P>(given.boxes[0]), y = to_interval<P>(given.boxes[1]);
    const double number = given.boxes[1].lo;
    const auto result = [&]() -> I {
      switch (given.n) {
      case add:
        return x + y;
      case sub:
        return x - y;
      case mul:
        return x * y;
      case div:
        return x / y;
      case square:
        return sqr(x);
      case root:
        return sqrt(x);
      case magnitude:
        return abs(x);
      case least:
        return min(x, y);
      case greatest:
        return max(x, y);
      case common:
        return intersect(x, y);
      case joined:
        return hull(x, y);
      case scaled:
        return number * x;
      default:
        return x / number;
      }
    };
    return to_bounds(result());
  };
  o.judge = [](const interval_operands& given, const bounds& got, observations& out) {
    const auto& [x, y, unused] = given.boxes;
    const bounds number = std::isfinite(y.lo) ? bounds{y.lo, y.lo} : bounds::empty();
    const auto right = [&]() -> bounds {
      switch (given.n) {
      case add:
        return ranges::add(x, y);
      case sub:
        return ranges::sub(x, y);
      case mul:
        return ranges::mul(x, y);
      case div:
        return ranges::div(x, y);
      case square:
        return ranges::sqr(x);
      case root:
        return ranges::sqrt(x);
      case magnitude:
        return ranges::abs(x);
      case least:
        return ranges::min(x, y);
      case greatest:
        return ranges::max(x, y);
      case common:
        return ranges::intersection(x, y);
      case joined:
        return ranges::convex_hull(x, y);
      case scaled:
        return ranges::mul(number, x);
      default:
        return ranges::div(x, number);
      }
    };
    compare(names[static_cast<unsigned>(given.n)], right(), got, out);
  };
  return o;
}

/// A backend's operations on numbers; which one is in n. As a value: [result, result].
template <class B> interval_operation points(std::string name) {
  interval_operation o;
  o.name = std::move(name);
  o.of_numbers = true;
  o.generate = [](std::uint64_t seed, std::uint64_t index) {
    const std::uint64_t s = seed_of_trial(seed, index);
    oracle::hard_operands make(s);
    const auto [x, y] = make.next(static_cast<oracle::hardness>(
        make.below(static_cast<std::uint64_t>(oracle::hardness::count))));
    interval_operands given{{bounds{x, x}, bounds{y, y}}};
    given.count = 2;
    given.n = static_cast<int>(mix(s) % backend_operations.size());
    given.has_n = true;
    return given;
  };
  o.value = [](const interval_operands& given) {
    [[maybe_unused]] const typename B::scope scope;
    const double r = backend_operation<B>(given.n, given.boxes[0].lo, given.boxes[1].lo);
    return bounds{r, r};
  };
  o.judge = [](const interval_operands& given, const bounds& got, observations& out) {
    compare_operation(given.n, given.boxes[0].lo, given.boxes[1].lo, got.lo, out);
  };
  return o;
}

template <class B> void add_backend(std::vector<interval_operation>& to) {
  const std::string name = B::name;
  to.push_back(operators<interval<B>>("interval<" + name + ">"));
  to.push_back(operators<boost::numeric::interval<double, policies<B>>>("boost<" + name + ">"));
  to.push_back(points<B>(name + " points"));
}

} // namespace

std::vector<interval_operation> interval_operations() {
  std::vector<interval_operation> all = of_the_standard();
  all.push_back(first_of_pair());
  add_backend<rounding::nearest>(all);
  add_backend<rounding::upward>(all);
  add_backend<rounding::switching>(all);
#if defined(__x86_64__)
  add_backend<rounding::split>(all);
#endif
  return all;
}

} // namespace graze::fuzz::self
