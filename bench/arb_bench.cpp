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
  for (const bool is_narrow : {true, false}) {
    const operands kind = is_narrow ? operands::narrow : operands::mixed;
    const auto named = [is_narrow](const char* f) {
      return f + std::string(is_narrow ? "/narrow" : "/mixed");
    };
    unary(named("exp").c_str(), kind, arb_exp);
    unary(named("log").c_str(),
          is_narrow ? operands::positive_narrow : operands::mixed_of_logarithm, arb_log);
    unary(named("sin").c_str(), kind, arb_sin);
    unary(named("cos").c_str(), kind, arb_cos);
    unary(named("tan").c_str(), kind, arb_tan);
    unary(named("atan").c_str(), kind, arb_atan);
    binary(named("atan2").c_str(), kind, arb_atan2);
    measure<library>(named("pown(x,4)").c_str(), kind, [](N& r, const N& x, const N&, const N&) {
      arb_pow_ui(r.value, x.value, 4, precision);
    });
  }
  unary("log/positive", operands::positive, arb_log);
}

} // namespace graze::bench
