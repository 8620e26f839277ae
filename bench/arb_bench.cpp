// Arb (in Debian 12 a library of its own on FLINT) with 53 bits: balls, so that its enclosures are
// not tightest.
#include "arb_number.hpp"

#include "measure.hpp"

namespace graze::bench {

namespace {
constexpr slong precision = arb_number::precision;
struct library {
  static constexpr const char* name = "Arb";
  using number = arb_number;
  struct scope {
    scope() {}
  };
  static void assign(number& x, const ends& e) { x.assign(e.lower, e.upper); }
  static enclosure enclosed(const number& x) { return {x.lower(), x.upper()}; }
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
  binary("add/mixed", operands::mixed, arb_add);
  binary("sub/mixed", operands::mixed, arb_sub);
  binary("mul/mixed", operands::mixed, arb_mul);
  binary("div/mixed", operands::mixed, arb_div);
  unary("sqrt/positive", operands::positive, arb_sqrt);
  unary("sqr/mixed", operands::mixed, arb_sqr);
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
    unary(named("sinh").c_str(), kind, arb_sinh);
    unary(named("cosh").c_str(), kind, arb_cosh);
    unary(named("tanh").c_str(), kind, arb_tanh);
    const operands unit = is_narrow ? operands::unit_narrow : operands::unit;
    unary(named("asin").c_str(), unit, arb_asin);
    unary(named("acos").c_str(), unit, arb_acos);
    binary(named("pow").c_str(), is_narrow ? operands::positive_narrow : operands::positive,
           arb_pow);
    measure<library>(named("pown(x,4)").c_str(), kind, [](N& r, const N& x, const N&, const N&) {
      arb_pow_ui(r.value, x.value, 4, precision);
    });
  }
  unary("log/positive", operands::positive, arb_log);
}

} // namespace graze::bench
