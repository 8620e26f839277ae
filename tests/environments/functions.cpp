// The compiled functions: on bounds, at points, in C, on arrays, as text.
#include "rows.hpp"
#include <graze/batch.hpp>
#include <graze/boolean.hpp>
#include <graze/construct.hpp>
#include <graze/decorated_functions.hpp>
#include <graze/functions/remainder.hpp>
#include <graze/graze.h>
#include <graze/interchange.hpp>
#include <graze/numeric.hpp>
#include <graze/overlap.hpp>
#include <graze/point.hpp>
#include <graze/point_rare.hpp>
#include <graze/reductions.hpp>
#include <graze/rounding/fused.hpp>
#include <graze/text.hpp>

namespace graze::environments {

namespace {

constexpr int exponents[] = {-3, -2, -1, 2, 3, 4, 7, 9, 12};

/// f(x) for each operand, or each pair, or each triple, thinned.
template <class F> void for_each_one(F f) {
  for (const bounds& x : edge_intervals())
    f(x);
}
template <class F> void for_each_pair(unsigned thinning, F f) {
  const std::vector<bounds>& all = edge_intervals();
  for (std::size_t i = 0; i < all.size() * all.size(); i += thinning)
    f(all[i / all.size()], all[i % all.size()]);
}
template <class F> void for_each_triple(unsigned thinning, F f) {
  const std::vector<bounds>& all = edge_intervals();
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n * n; i += thinning)
    f(all[i % n], all[i / n], all[(i * 7 + i / 13) % n]);
}

template <class F> void ask_value(answers& a, unsigned thinning) {
  // the decoration goes with the value: what is promised of the operation beside its bounds
  const auto decorated = [&a](const auto&... x) {
    a.bounds_are(F::value(x...));
    a.says(static_cast<std::uint64_t>(local_decoration<F>(F::value(x...), x...)));
  };
  if constexpr (requires(bounds x) { F::value(x, x, x); })
    for_each_triple(thinning, decorated);
  else if constexpr (requires(bounds x) { F::value(x, x); })
    for_each_pair(thinning, decorated);
  else if constexpr (requires(bounds x) { F::value(x, 2); })
    for_each_one([&](const bounds& x) {
      for (const int n : exponents)
        decorated(x, n);
    });
  else
    for_each_one(decorated);
}

/// Each function as the C interface has it.
#define GRAZE_C_ROW(name)                                                                          \
  {"C " #name, promise::immune, [](answers& a) {                                                   \
     for_each_one([&a](const bounds& x) { a.value_is(graze_##name({x.lo, x.hi})); });              \
   }}

void ask_points(answers& a) {
  for (const double x : edge_numbers()) {
#define GRAZE_POINT(name) a.bounds_are(point::name##_down(x), point::name##_up(x));
    GRAZE_FOR_EACH_ELEMENTARY(GRAZE_POINT)
#undef GRAZE_POINT
    for (const int n : exponents) {
      a.bounds_are(point::pown_down(x, n), point::pown_up(x, n));
      a.bounds_are(point::rootn_down(x, n), point::rootn_up(x, n));
    }
    for (const double y : edge_numbers()) {
      a.bounds_are(point::atan2_down(x, y), point::atan2_up(x, y));
      a.bounds_are(point::hypot_down(x, y), point::hypot_up(x, y));
      a.bounds_are(point::pow_down(x, y), point::pow_up(x, y));
      for (const double z : edge_numbers())
        a.bounds_are(rounding::fma_down(x, y, z), rounding::fma_up(x, y, z));
    }
  }
}

void ask_tests(answers& a, unsigned thinning) {
  for_each_pair(thinning, [&a](const bounds& x, const bounds& y) {
    unsigned found = 0;
    for (const bool b :
         {equal(x, y), subset(x, y), interior(x, y), less(x, y), strict_less(x, y), precedes(x, y),
          strict_precedes(x, y), disjoint(x, y), is_member(x.lo, y), is_singleton(x)})
      found = found << 1 | (b ? 1u : 0u);
    a.says(found);
    a.says(static_cast<std::uint64_t>(overlap(x, y)));
    a.says(graze_overlap({x.lo, x.hi}, {y.lo, y.hi}));
    a.bounds_are(nums_to_interval(x.lo, y.lo).value);
  });
}

void ask_numbers(answers& a) {
  for_each_one([&a](const bounds& x) {
    for (const double n : {inf(x), sup(x), mid(x), rad(x), wid(x), mag(x), mig(x)})
      a.value_is(n);
    for (const std::byte b : to_bytes(x))
      a.says(std::to_integer<std::uint64_t>(b));
  });
}

void ask_text(answers& a) {
  for_each_one([&a](const bounds& x) {
    for (const text_style style : {text_style::decimal, text_style::hexadecimal}) {
      const std::string text = interval_to_text(x, style);
      a.says(text);
      a.bounds_are(text_to_interval(text).value);
    }
  });
  for (const char* const text :
       {"[4.9e-324]", "[1e-320, 1e-310]", "[2.2250738585072014e-308]", "[0.1]", "[1/3, 2/3]",
        "1.5?1e-320", "[1e400]", "[0x1p-1080, 0x1.8p-1070]", "3.56?1u", "[-1e-400, 1]"})
    a.bounds_are(text_to_interval(text).value);
}

void ask_reductions(answers& a) {
  const std::vector<double>& x = edge_numbers();
  for (std::size_t first = 0; first < x.size(); ++first)
    for (std::size_t n = 1; n <= 5 && first + n <= x.size(); ++n) {
      const std::span<const double> s(x.data() + first, n);
      const std::span<const double> t(x.data() + x.size() - first - n, n);
      for (const rounded to : {rounded::down, rounded::up, rounded::nearest})
        for (const double v : {sum(s, to), sum_abs(s, to), sum_sqr(s, to), dot(s, t, to)})
          a.value_is(v);
    }
}

void ask_batch(answers& a, batch::path p, unsigned thinning) {
  batch::force_path(p);
  std::vector<bounds> x, y, z;
  for_each_triple(thinning, [&](const bounds& s, const bounds& t, const bounds& u) {
    x.push_back(s), y.push_back(t), z.push_back(u);
  });
  std::vector<bounds> r(x.size());
  const auto keep = [&] {
    for (const bounds& b : r)
      a.bounds_are(b);
  };
  using spans = std::span<const bounds>;
  const auto check_unary = [&](void (*f)(spans, std::span<bounds>)) { f(x, r), keep(); };
  const auto check_binary = [&](void (*f)(spans, spans, std::span<bounds>)) { f(x, y, r), keep(); };
  check_unary(batch::neg), check_unary(batch::sqr), check_unary(batch::sqrt),
      check_unary(batch::abs);
  check_binary(batch::add), check_binary(batch::sub), check_binary(batch::mul),
      check_binary(batch::div);
  check_binary(batch::min), check_binary(batch::max), check_binary(batch::intersection),
      check_binary(batch::hull);
  batch::fma(x, y, z, r), keep();
  batch::unforce_path();
}

} // namespace

std::vector<row> rows_of_functions(unsigned thinning) {
  std::vector<row> r{
#define GRAZE_ROW(name)                                                                            \
  {#name, promise::immune, [=](answers& a) { ask_value<functions::name>(a, thinning); }},
      GRAZE_FOR_EACH_FUNCTION(GRAZE_ROW)
#undef GRAZE_ROW
          {"mul_rev_to_pair", promise::immune,
           [=](answers& a) {
             for_each_pair(thinning, [&a](const bounds& x, const bounds& y) {
               const auto pair = functions::mul_rev_to_pair::value(x, y);
               a.bounds_are(pair.first), a.bounds_are(pair.second);
             });
           }},
      {"fmod", promise::immune,
       [=](answers& a) {
         for_each_pair(thinning, [&a](const bounds& x, const bounds& y) {
           a.bounds_are(functions::fmod::value(x, y));
         });
       }},
      {"at points, down and up", promise::immune, ask_points},
      {"comparisons", promise::immune, [=](answers& a) { ask_tests(a, thinning); }},
      {"inf sup mid rad wid mag mig, bytes", promise::immune, ask_numbers},
      GRAZE_C_ROW(mid),
      GRAZE_C_ROW(rad),
      GRAZE_C_ROW(wid),
      GRAZE_C_ROW(mag),
      GRAZE_C_ROW(mig),
      GRAZE_C_ROW(inf),
      GRAZE_C_ROW(sup),
      {"text in and out", promise::immune, ask_text},
      {"exact sums and products", promise::immune, ask_reductions}};
  for (const batch::path p : batch::paths)
    if (!batch::refusal(p))
      r.push_back({std::string("batches, ") + batch::name(p), promise::immune,
                   [=](answers& a) { ask_batch(a, p, thinning); }});
  return r;
}

} // namespace graze::environments
