/// The subject `functions`: elementary functions of intervals and, as intervals of one number, of
/// numbers.
#include <graze/decorated_functions.hpp>
#include <graze/oracle/ranges.hpp>
#include <self/operands.hpp>
#include <self/value_of.hpp>

namespace graze::fuzz::self {

namespace {

namespace ranges = oracle::ranges;
using oracle::active_range;
using oracle::mpfr_function;

constexpr double infinity = std::numeric_limits<double>::infinity();

double special(oracle::hard_arguments& make) {
  static constexpr std::array<double, 11> list{-infinity, -2, -1, -0.5,      -0.0,    0,
                                               0.5,       1,  2,  0x1p-1074, infinity};
  return list[make.below(list.size())];
}
bounds of_specials(oracle::hard_arguments& make) {
  const double a = special(make), b = special(make);
  const bounds x{std::min(a, b), std::max(a, b)};
  return x.lo == infinity || x.hi == -infinity ? bounds::entire() : x;
}

/// Half by the function's own range; the rest near a double's value (where the function is given),
/// about special points, and boxes hard for anything.
bounds argument(std::uint64_t s, active_range active, mpfr_function function) {
  oracle::hard_arguments make(s);
  switch (make.below(16)) {
  case 0:
    return oracle::hard_boxes(s).next();
  case 1:
    return of_specials(make);
  case 2:
    if (function != nullptr) {
      const double x = oracle::nearly_a_double(function, make.uniform(active.lo, active.hi));
      return {x, x};
    }
    [[fallthrough]];
  default:
    return make.interval(active);
  }
}

template <class F> interval_operation named(const char* name) {
  interval_operation o;
  o.name = name;
  o.value = value_of<F>;
  return o;
}

template <class F>
interval_operation unary(const char* name, bounds (*right)(const bounds&), active_range active,
                         mpfr_function function) {
  interval_operation o = named<F>(name);
  o.generate = [=](std::uint64_t seed, std::uint64_t index) {
    return interval_operands{{argument(seed_of_trial(seed, index), active, function)}};
  };
  o.judge = [right](const interval_operands& x, const bounds& got, observations& out) {
    compare("", right(x.boxes[0]), got, out);
  };
  return o;
}
/// With a judge of decorations.
template <class F>
interval_operation unary(const char* name, ranges::decorated (*right)(const bounds&),
                         active_range active, mpfr_function function) {
  interval_operation o =
      unary<F>(name, static_cast<bounds (*)(const bounds&)>(nullptr), active, function);
  o.judge = [right](const interval_operands& x, const bounds& got, observations& out) {
    compare("", right(x.boxes[0]).value, got, out);
  };
  o.right_local = [right](const interval_operands& x) { return right(x.boxes[0]).local; };
  o.local = local_of<F>;
  return o;
}

template <class F>
interval_operation binary(const char* name, bounds (*right)(const bounds&, const bounds&),
                          active_range first, active_range second) {
  interval_operation o = named<F>(name);
  o.generate = [=](std::uint64_t seed, std::uint64_t index) {
    const std::uint64_t s = seed_of_trial(seed, index);
    interval_operands x = hard_operands_of(2, s);
    if (oracle::hard_arguments make(s); make.below(8) != 0)
      x.boxes = {argument(s, first, nullptr), argument(~s, second, nullptr)};
    return x;
  };
  o.judge = [right](const interval_operands& x, const bounds& got, observations& out) {
    compare("", right(x.boxes[0], x.boxes[1]), got, out);
  };
  return o;
}

/// pown and rootn. Powers of what the operands of a reverse operation hold, or roots of them.
template <class F>
interval_operation integer_power(const char* name, ranges::decorated (*right)(const bounds&, int),
                                 bounds oracle::reverse::reverse_case::* operand) {
  interval_operation o = named<F>(name);
  o.generate = [=](std::uint64_t seed, std::uint64_t index) {
    oracle::reverse::algebraic_operands make(seed_of_trial(seed, index));
    const auto c = make.pown();
    interval_operands x{{c.*operand}};
    x.n = c.n;
    x.has_n = true;
    if (make.below(8) == 0)
      x.boxes[0] = oracle::hard_boxes(seed_of_trial(seed, index)).next();
    return x;
  };
  o.judge = [right](const interval_operands& x, const bounds& got, observations& out) {
    compare("", right(x.boxes[0], x.n).value, got, out);
  };
  o.right_local = [right](const interval_operands& x) { return right(x.boxes[0], x.n).local; };
  o.local = local_of<F>;
  return o;
}

} // namespace

std::vector<interval_operation> elementary_operations() {
  namespace f = functions;
#define GRAZE_UNARY(name, mpfr, lo, hi)                                                            \
  unary<f::name>(#name, ranges::name, active_range{lo, hi}, mpfr)
  return {
      GRAZE_UNARY(exp, mpfr_exp, -746, 710),
      GRAZE_UNARY(exp2, mpfr_exp2, -1076, 1025),
      GRAZE_UNARY(exp10, mpfr_exp10, -324, 309),
      GRAZE_UNARY(expm1, mpfr_expm1, -40, 710),
      GRAZE_UNARY(log, mpfr_log, 0, 10),
      GRAZE_UNARY(log2, mpfr_log2, 0, 10),
      GRAZE_UNARY(log10, mpfr_log10, 0, 10),
      GRAZE_UNARY(logp1, mpfr_log1p, -1, 10),
      GRAZE_UNARY(sin, mpfr_sin, -20, 20),
      GRAZE_UNARY(cos, mpfr_cos, -20, 20),
      GRAZE_UNARY(tan, mpfr_tan, -20, 20),
      GRAZE_UNARY(asin, mpfr_asin, -1, 1),
      GRAZE_UNARY(acos, mpfr_acos, -1, 1),
      GRAZE_UNARY(atan, mpfr_atan, -20, 20),
      binary<f::atan2>("atan2", ranges::atan2, {-10, 10}, {-10, 10}),
      GRAZE_UNARY(sinh, mpfr_sinh, -711, 711),
      GRAZE_UNARY(cosh, mpfr_cosh, -711, 711),
      GRAZE_UNARY(tanh, mpfr_tanh, -20, 20),
      GRAZE_UNARY(asinh, mpfr_asinh, -20, 20),
      GRAZE_UNARY(acosh, mpfr_acosh, 1, 20),
      GRAZE_UNARY(atanh, mpfr_atanh, -1, 1),
      GRAZE_UNARY(cbrt, mpfr_cbrt, -20, 20),
      binary<f::hypot>("hypot", ranges::hypot, {-10, 10}, {-10, 10}),
      binary<f::pow>("pow", ranges::pow, {0, 4}, {-20, 20}),
      integer_power<f::pown>("pown", ranges::pown, &oracle::reverse::reverse_case::x),
      integer_power<f::rootn>("rootn", ranges::rootn, &oracle::reverse::reverse_case::c),
      GRAZE_UNARY(cot, mpfr_cot, -20, 20),
      GRAZE_UNARY(sec, mpfr_sec, -20, 20),
      GRAZE_UNARY(csc, mpfr_csc, -20, 20),
      GRAZE_UNARY(acot, ranges::mpfr_acot, -20, 20),
      GRAZE_UNARY(coth, mpfr_coth, -20, 20),
      GRAZE_UNARY(sech, mpfr_sech, -720, 720),
      GRAZE_UNARY(csch, mpfr_csch, -720, 720),
      GRAZE_UNARY(acoth, ranges::mpfr_acoth, -20, 20),
  };
#undef GRAZE_UNARY
}

} // namespace graze::fuzz::self
