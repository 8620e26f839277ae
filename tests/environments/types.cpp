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

enum class operators { all, sums, products };

template <class I> void ask_operators(answers& a, unsigned thinning, operators which) {
  const std::vector<bounds>& all = edge_intervals();
  std::vector<I> x;
  for (const bounds& b : all)
    x.push_back(I(b.lo, b.hi, true));
  const auto keep = [&a](const I& r) { a.bounds_are(r.lower(), r.upper()); };
  for (std::size_t i = 0; i < x.size() * x.size(); i += thinning) {
    const I &s = x[i / x.size()], &t = x[i % x.size()];
    if (which != operators::products)
      keep(s + t), keep(s - t);
    if (which != operators::sums)
      keep(s * t), keep(s / t), keep(s * all[i % x.size()].hi);
  }
  if (which != operators::sums)
    for (const I& s : x)
      keep(square(s)), keep(sqrt(s));
}
template <class I>
row of_type(const std::string& name, promise promised, unsigned thinning,
            operators which = operators::all) {
  return {name + (which == operators::sums       ? ", + -"
                  : which == operators::products ? ", * / sqr sqrt"
                                                 : ""),
          promised, [=](answers& a) { ask_operators<I>(a, thinning, which); }};
}
template <class B> row within_scope(unsigned thinning) {
  return {std::string("unprotected<") + B::name + "> in its scope", promise::immune,
          [=](answers& a) {
            const typename B::scope scope;
            ask_operators<unprotected<B>>(a, thinning, operators::all);
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
#if defined(__AVX512F__)
  // sums and products by instructions that carry their rounding, but not the flushing
  constexpr promise of_products = promise::needs_default;
#else
  constexpr promise of_products = promise::immune_to_flushing;
#endif
  using operators::sums, operators::products;
  return {
      of_type<interval<>>("interval<>", promise::needs_default, thinning, sums),
      of_type<interval<>>("interval<>", of_products, thinning, products),
      of_type<layout_of_boost<nearest>>("policies<nearest>", promise::needs_default, thinning,
                                        sums),
      of_type<layout_of_boost<nearest>>("policies<nearest>", of_products, thinning, products),
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
