// Arb (in Debian 12 a library of its own on FLINT) with 53 bits: balls, so that its enclosures are
// not tightest.
#if __has_include(<arb.h>)
#include <arb.h>
#else
#include <flint/arb.h>
#endif

#include "measure.hpp"

namespace graze::bench {

namespace {
constexpr slong precision = 53;
struct arb_number {
  arb_t value;
  arb_number() { arb_init(value); }
  ~arb_number() { arb_clear(value); }
  arb_number(const arb_number&) = delete;
  arb_number& operator=(const arb_number&) = delete;
};
struct library {
  static constexpr const char* name = "Arb";
  using number = arb_number;
  struct scope {
    scope() {}
  };
  static void assign(number& x, const ends& e) {
    arf_t a, b;
    arf_init(a), arf_init(b);
    arf_set_d(a, e.lower), arf_set_d(b, e.upper);
    arb_set_interval_arf(x.value, a, b, precision);
    arf_clear(a), arf_clear(b);
  }
};
using N = arb_number;
} // namespace

void measure_arb() {
  const auto unary = [](const char* name, operands kind, auto f) {
    measure<library>(name, kind,
                     [f](N& r, const N& x, const N&, const N&) { f(r.value, x.value, precision); });
  };
  const auto binary = [](const char* name, operands kind, auto f) {
    measure<library>(name, kind, [f](N& r, const N& x, const N& y, const N&) {
      f(r.value, x.value, y.value, precision);
    });
  };
  binary("add", operands::mixed, arb_add);
  binary("sub", operands::mixed, arb_sub);
  binary("mul", operands::mixed, arb_mul);
  binary("div", operands::mixed, arb_div);
  unary("sqrt", operands::positive, arb_sqrt);
  unary("sqr", operands::mixed, arb_sqr);
  unary("exp", operands::narrow, arb_exp);
  unary("log", operands::positive_narrow, arb_log);
  unary("sin", operands::narrow, arb_sin);
  unary("cos", operands::narrow, arb_cos);
  unary("tan", operands::narrow, arb_tan);
  unary("atan", operands::narrow, arb_atan);
  binary("atan2", operands::narrow, arb_atan2);
  measure<library>("pown(x,4)", operands::narrow, [](N& r, const N& x, const N&, const N&) {
    arb_pow_ui(r.value, x.value, 4, precision);
  });
}

} // namespace graze::bench
