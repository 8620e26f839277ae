#pragma once
/// MPFI's intervals of 53 bits as C++ objects.
#include <algorithm>
#include <mpfi.h>
#include <utility>

namespace graze::bench {

struct mpfi_number {
  mpfi_t value;

  mpfi_number() { mpfi_init2(value, 53); }
  mpfi_number(double x) : mpfi_number(x, x) {}
  mpfi_number(double lower, double upper) : mpfi_number() { mpfi_interv_d(value, lower, upper); }
  mpfi_number(const mpfi_number& x) : mpfi_number() { mpfi_set(value, x.value); }
  mpfi_number& operator=(mpfi_number x) {
    mpfi_swap(value, x.value);
    return *this;
  }
  ~mpfi_number() { mpfi_clear(value); }

  /// The greatest double that is no greater, and the least that is no less: MPFI has no subnormal
  /// numbers and no overflow, so that its bounds need not be doubles.
  [[nodiscard]] double lower() const { return mpfr_get_d(&value->left, MPFR_RNDD); }
  [[nodiscard]] double upper() const { return mpfr_get_d(&value->right, MPFR_RNDU); }
};

#define GRAZE_MPFI_BINARY(name, function)                                                          \
  inline mpfi_number name(const mpfi_number& x, const mpfi_number& y) {                            \
    mpfi_number r;                                                                                 \
    function(r.value, x.value, y.value);                                                           \
    return r;                                                                                      \
  }
GRAZE_MPFI_BINARY(operator+, mpfi_add)
GRAZE_MPFI_BINARY(operator-, mpfi_sub)
GRAZE_MPFI_BINARY(operator*, mpfi_mul)
GRAZE_MPFI_BINARY(operator/, mpfi_div)
#undef GRAZE_MPFI_BINARY
#define GRAZE_MPFI_UNARY(name, function)                                                           \
  inline mpfi_number name(const mpfi_number& x) {                                                  \
    mpfi_number r;                                                                                 \
    function(r.value, x.value);                                                                    \
    return r;                                                                                      \
  }
GRAZE_MPFI_UNARY(sqr, mpfi_sqr)
GRAZE_MPFI_UNARY(sqrt, mpfi_sqrt)
GRAZE_MPFI_UNARY(exp, mpfi_exp)
GRAZE_MPFI_UNARY(log, mpfi_log)
GRAZE_MPFI_UNARY(sin, mpfi_sin)
GRAZE_MPFI_UNARY(cos, mpfi_cos)
GRAZE_MPFI_UNARY(tan, mpfi_tan)
GRAZE_MPFI_UNARY(atan, mpfi_atan)
#undef GRAZE_MPFI_UNARY

} // namespace graze::bench
