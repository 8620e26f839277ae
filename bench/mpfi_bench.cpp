// MPFI with 53 bits; results go to numbers that exist.
#include <mpfi.h>

#include "measure.hpp"

namespace graze::bench {

namespace {
struct mpfi_number {
  mpfi_t value;
  mpfi_number() { mpfi_init2(value, 53); }
  ~mpfi_number() { mpfi_clear(value); }
  mpfi_number(const mpfi_number&) = delete;
  mpfi_number& operator=(const mpfi_number&) = delete;
};
struct library {
  static constexpr const char* name = "MPFI";
  using number = mpfi_number;
  struct scope {
    scope() {}
  };
  static void assign(number& x, const ends& e) { mpfi_interv_d(x.value, e.lower, e.upper); }
};
using N = mpfi_number;
} // namespace

void measure_mpfi() {
  const auto unary = [](const char* name, operands kind, auto f) {
    measure<library>(name, kind,
                     [f](N& r, const N& x, const N&, const N&) { f(r.value, x.value); });
  };
  const auto binary = [](const char* name, operands kind, auto f) {
    measure<library>(name, kind,
                     [f](N& r, const N& x, const N& y, const N&) { f(r.value, x.value, y.value); });
  };
  binary("add", operands::mixed, mpfi_add);
  binary("sub", operands::mixed, mpfi_sub);
  binary("mul", operands::mixed, mpfi_mul);
  binary("div", operands::mixed, mpfi_div);
  unary("sqrt", operands::positive, mpfi_sqrt);
  unary("sqr", operands::mixed, mpfi_sqr);
  measure<library>("polynomial", operands::mixed, [](N& r, const N& x, const N& y, const N& z) {
    static N t, c;
    mpfi_interv_d(c.value, 0x1.bccccccccccccp+2, 0x1.bcccccccccccdp+2);
    mpfi_set_si(r.value, 0);
    for (const N* v : {&x, &y, &z}) {
      mpfi_sqr(t.value, v->value);
      mpfi_sub_d(t.value, t.value, 2.5);
      mpfi_sqr(t.value, t.value);
      mpfi_add(r.value, r.value, t.value);
    }
    mpfi_sub(r.value, r.value, c.value);
  });
  for (const bool is_narrow : {true, false}) {
    const operands kind = is_narrow ? operands::narrow : operands::mixed;
    const auto named = [is_narrow](const char* f) {
      return f + std::string(is_narrow ? "/narrow" : "/mixed");
    };
    unary(named("exp").c_str(), kind, mpfi_exp);
    unary(named("log").c_str(),
          is_narrow ? operands::positive_narrow : operands::mixed_of_logarithm, mpfi_log);
    unary(named("sin").c_str(), kind, mpfi_sin);
    unary(named("cos").c_str(), kind, mpfi_cos);
    unary(named("tan").c_str(), kind, mpfi_tan);
    unary(named("atan").c_str(), kind, mpfi_atan);
    binary(named("atan2").c_str(), kind, mpfi_atan2);
  }
  unary("log/positive", operands::positive, mpfi_log);
}

} // namespace graze::bench
