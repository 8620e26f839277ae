#include <graze/oracle/binary32.hpp>

namespace graze::oracle::binary32 {
namespace {

int reciprocal(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to) { return mpfr_ui_div(r, 1, x, to); }
int sign(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to) { return mpfr_set_si(r, mpfr_sgn(x), to); }

// MPFR's rint functions round to an integer in a fixed direction, and then to the precision: their
// result is exact here, but the ternary value compares with the operand.
template <int (*Function)(mpfr_ptr, mpfr_srcptr)>
int integer(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t) {
  Function(r, x);
  return 0;
}
int ties_to_even(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t) {
  mpfr_rint(r, x, MPFR_RNDN);
  return 0;
}

#define GRAZE_UNARY(name) {#name, mpfr_##name}
const unary list[] = {
    {"recip", reciprocal},
    GRAZE_UNARY(sqr),
    GRAZE_UNARY(sqrt),
    GRAZE_UNARY(abs),
    {"sign", sign},
    {"ceil", integer<mpfr_ceil>},
    {"floor", integer<mpfr_floor>},
    {"trunc", integer<mpfr_trunc>},
    {"round_ties_to_even", ties_to_even},
    {"round_ties_to_away", integer<mpfr_round>},
    GRAZE_UNARY(exp),
    GRAZE_UNARY(exp2),
    GRAZE_UNARY(exp10),
    GRAZE_UNARY(expm1),
    {"log", mpfr_log},
    {"log2", mpfr_log2},
    {"log10", mpfr_log10},
    {"logp1", mpfr_log1p},
    GRAZE_UNARY(sin),
    GRAZE_UNARY(cos),
    GRAZE_UNARY(tan),
    GRAZE_UNARY(asin),
    GRAZE_UNARY(acos),
    GRAZE_UNARY(atan),
    GRAZE_UNARY(sinh),
    GRAZE_UNARY(cosh),
    GRAZE_UNARY(tanh),
    GRAZE_UNARY(asinh),
    GRAZE_UNARY(acosh),
    GRAZE_UNARY(atanh),
    GRAZE_UNARY(cbrt),
    GRAZE_UNARY(cot),
    GRAZE_UNARY(sec),
    GRAZE_UNARY(csc),
    {"acot", ranges::mpfr_acot},
    GRAZE_UNARY(coth),
    GRAZE_UNARY(sech),
    GRAZE_UNARY(csch),
    {"acoth", ranges::mpfr_acoth},
};
#undef GRAZE_UNARY

} // namespace

std::span<const unary> unary_functions() { return list; }

} // namespace graze::oracle::binary32
