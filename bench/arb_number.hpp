#pragma once
/// Arb's balls (a library of its own on FLINT in Debian 12) of 53 bits as C++ objects. A ball has a
/// midpoint and a radius of 30 bits: a pair of ends becomes the ball around both, which is wider.
#if __has_include(<arb.h>)
#include <arb.h>
#else
#include <flint/arb.h>
#endif

namespace graze::bench {

struct arb_number {
  static constexpr slong precision = 53;
  arb_t value;

  arb_number() { arb_init(value); }
  arb_number(double x) : arb_number() { arb_set_d(value, x); }
  arb_number(double lower, double upper) : arb_number() { assign(lower, upper); }
  arb_number(const arb_number& x) : arb_number() { arb_set(value, x.value); }
  arb_number& operator=(arb_number x) {
    arb_swap(value, x.value);
    return *this;
  }
  ~arb_number() { arb_clear(value); }

  void assign(double lower, double upper) {
    arf_t a, b;
    arf_init(a), arf_init(b);
    arf_set_d(a, lower), arf_set_d(b, upper);
    arb_set_interval_arf(value, a, b, precision);
    arf_clear(a), arf_clear(b);
  }
  /// The greatest double that is no greater than the ball's lower end, and the least that is no
  /// less than its upper end.
  [[nodiscard]] double lower() const { return end(arb_get_lbound_arf, ARF_RND_FLOOR); }
  [[nodiscard]] double upper() const { return end(arb_get_ubound_arf, ARF_RND_CEIL); }

private:
  template <class Bound> double end(Bound bound, arf_rnd_t to) const {
    arf_t a;
    arf_init(a);
    bound(a, value, precision);
    const double x = arf_get_d(a, to);
    arf_clear(a);
    return x;
  }
};

#define GRAZE_ARB_BINARY(name, function)                                                           \
  inline arb_number name(const arb_number& x, const arb_number& y) {                               \
    arb_number r;                                                                                  \
    function(r.value, x.value, y.value, arb_number::precision);                                    \
    return r;                                                                                      \
  }
GRAZE_ARB_BINARY(operator+, arb_add)
GRAZE_ARB_BINARY(operator-, arb_sub)
GRAZE_ARB_BINARY(operator*, arb_mul)
GRAZE_ARB_BINARY(operator/, arb_div)
GRAZE_ARB_BINARY(pow, arb_pow)
#undef GRAZE_ARB_BINARY
#define GRAZE_ARB_UNARY(name, function)                                                            \
  inline arb_number name(const arb_number& x) {                                                    \
    arb_number r;                                                                                  \
    function(r.value, x.value, arb_number::precision);                                             \
    return r;                                                                                      \
  }
GRAZE_ARB_UNARY(sqr, arb_sqr)
GRAZE_ARB_UNARY(sqrt, arb_sqrt)
GRAZE_ARB_UNARY(exp, arb_exp)
GRAZE_ARB_UNARY(log, arb_log)
GRAZE_ARB_UNARY(sin, arb_sin)
GRAZE_ARB_UNARY(cos, arb_cos)
GRAZE_ARB_UNARY(tan, arb_tan)
GRAZE_ARB_UNARY(atan, arb_atan)
#undef GRAZE_ARB_UNARY

} // namespace graze::bench
