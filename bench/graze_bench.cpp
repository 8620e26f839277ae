// graze::interval over its backends.
#include "measure.hpp"
#include <graze/batch.hpp>
#include <graze/functions/exponential.hpp>
#include <graze/functions/hyperbolic.hpp>
#include <graze/functions/integer_power.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/trigonometric.hpp>
#include <graze/interval.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::bench {

namespace {
template <class I> struct library {
  using number = I;
  static I constant(double lower, double upper) { return I(std::min(lower, upper), upper); }
  static void assign(I& x, const ends& e) { x = I(e.lower, e.upper); }
  static enclosure enclosed(const I& x) { return {x.lower(), x.upper()}; }
};
template <class B> struct scoped : library<interval<B>> {
  struct scope {
    scope() {}
  };
};
template <class B> struct held_by_caller : library<unprotected<B>> {
  using scope = typename B::scope;
};
struct nearest : scoped<rounding::nearest> {
  static constexpr const char* name = "interval<>";
};
struct upward : held_by_caller<rounding::upward> {
  static constexpr const char* name = "unprotected<upward>";
};
struct upward_scoped : scoped<rounding::upward> {
  static constexpr const char* name = "interval<upward>";
};
struct split : held_by_caller<rounding::split> {
  static constexpr const char* name = "unprotected<split>";
};
struct split_scoped : scoped<rounding::split> {
  static constexpr const char* name = "interval<split>";
};
struct switching : scoped<rounding::switching> {
  static constexpr const char* name = "interval<switching>";
};
} // namespace

void measure_graze() {
  measure_arithmetic<upward>();
  measure_arithmetic<nearest>();
  measure_functions<nearest>();
  measure_arithmetic<split>();
  measure_arithmetic<upward_scoped>();
  measure_arithmetic<split_scoped>();
  measure_arithmetic<switching>();
}

} // namespace graze::bench
