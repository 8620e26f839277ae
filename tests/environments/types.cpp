// The types whose operations are inlined, each over its backend.
#include "rows.hpp"
#include <graze/interval.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/upward.hpp>
#if defined(__x86_64__)
#include <graze/rounding/split.hpp>
#endif
#include <graze/rounding/switching.hpp>

namespace graze::environments {

namespace {

/// The intervals at which environments differ, outward as floats if I has those.
template <class I> std::vector<I> operands() {
  std::vector<I> x;
  for (const bounds& b : edge_intervals())
    if constexpr (std::same_as<typename I::base_type, double>)
      x.push_back(I(b.lo, b.hi, true));
    else
      x.push_back(I(rounding::narrow_down(b.lo), rounding::narrow_up(b.hi), true));
  return x;
}
double exact(double bound) { return bound; }
double exact(float bound) { return rounding::widened(bound); } // a conversion might flush
template <class I> void ask_operators(answers& a, unsigned thinning) {
  const std::vector<bounds>& all = edge_intervals();
  static const std::vector<I> x = operands<I>(); // made at a program's start
  const auto keep = [&a](const I& r) { a.bounds_are(exact(r.lower()), exact(r.upper())); };
  for (std::size_t i = 0; i < x.size() * x.size(); i += thinning) {
    const I &s = x[i / x.size()], &t = x[i % x.size()];
    keep(s + t), keep(s - t), keep(s * t), keep(s / t), keep(s * all[i % x.size()].hi);
  }
  for (const I& s : x)
    keep(square(s)), keep(sqrt(s));
  for (const I& s : x) {
    for (const double n : {0x1p-1074, 3.0, 2.5, -2.0})
      keep(pow(s, n));
    const auto middle = mid_rad(s);
    for (const auto number :
         {inf(s), sup(s), mid(s), rad(s), wid(s), mag(s), mig(s), middle.mid, middle.rad})
      a.value_is(exact(number));
  }
}
template <class I> row of_type(const std::string& name, promise promised, unsigned thinning) {
  return {name, promised, [=](answers& a) { ask_operators<I>(a, thinning); }};
}
template <class B> row within_scope(unsigned thinning) {
  return {std::string("unprotected<") + B::name + "> in its scope", promise::immune,
          [=](answers& a) {
            const typename B::scope scope;
            ask_operators<unprotected<B>>(a, thinning);
          }};
}
template <class B> using layout_of_boost = boost::numeric::interval<double, policies<B>>;

/// The rounded operations themselves, within a scope.
template <class B> row operations(promise promised) {
  return {std::string("operations of ") + B::name, promised, [](answers& a) {
            [[maybe_unused]] const typename B::scope scope;
            for (const double x : edge_numbers()) {
              a.bounds_are(B::sqrt_down(x), B::sqrt_up(x));
              for (const double y : edge_numbers()) {
                a.bounds_are(B::add_down(x, y), B::add_up(x, y));
                a.bounds_are(B::sub_down(x, y), B::sub_up(x, y));
                a.bounds_are(B::mul_down(x, y), B::mul_up(x, y));
                a.bounds_are(B::div_down(x, y), B::div_up(x, y));
              }
            }
          }};
}

} // namespace

std::vector<row> rows_of_types(unsigned thinning) {
  using namespace rounding;
  return {
      of_type<interval<>>("interval<>", promise::immune_to_flushing, thinning),
      of_type<layout_of_boost<nearest>>("policies<nearest>", promise::immune_to_flushing, thinning),
      of_type<float_interval<>>("float_interval<>", promise::immune_to_flushing, thinning),
      of_type<float_interval<upward>>("float_interval<upward>", promise::immune, thinning),
      operations<nearest>(promise::immune_to_flushing),
      of_type<interval<upward>>("interval<upward>", promise::immune, thinning),
      of_type<layout_of_boost<upward>>("policies<upward>", promise::immune, thinning),
      within_scope<upward>(thinning),
      operations<upward>(promise::immune),
#if defined(__x86_64__)
      of_type<interval<split>>("interval<split>", promise::immune, thinning),
      within_scope<split>(thinning),
      operations<split>(promise::immune),
#endif
      of_type<interval<switching>>("interval<switching>", promise::immune, thinning),
      operations<switching>(promise::immune),
  };
}

} // namespace graze::environments
