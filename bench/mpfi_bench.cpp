// MPFI with 53 bits; results go to numbers that exist.
#include "mpfi_number.hpp"

#include "measure.hpp"

namespace graze::bench {

namespace {
struct library {
  static constexpr const char* name = "MPFI";
  using number = mpfi_number;
  struct scope {
    scope() {}
  };
  static void assign(number& x, const ends& e) { mpfi_interv_d(x.value, e.lower, e.upper); }
  static enclosure enclosed(const number& x) { return {x.lower(), x.upper()}; }
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
  binary("add/mixed", operands::mixed, mpfi_add);
  binary("sub/mixed", operands::mixed, mpfi_sub);
  binary("mul/mixed", operands::mixed, mpfi_mul);
  binary("div/mixed", operands::mixed, mpfi_div);
  unary("sqrt/positive", operands::positive, mpfi_sqrt);
  unary("sqr/mixed", operands::mixed, mpfi_sqr);
  measure<library>("polynomial/mixed", operands::mixed,
                   [](N& r, const N& x, const N& y, const N& z) {
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
    unary(named("sinh").c_str(), kind, mpfi_sinh);
    unary(named("cosh").c_str(), kind, mpfi_cosh);
    unary(named("tanh").c_str(), kind, mpfi_tanh);
    const operands unit = is_narrow ? operands::unit_narrow : operands::unit;
    unary(named("asin").c_str(), unit, mpfi_asin);
    unary(named("acos").c_str(), unit, mpfi_acos);
  }
  unary("log/positive", operands::positive, mpfi_log);
}

} // namespace graze::bench
