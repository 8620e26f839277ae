#include "border.hpp"
#include <algorithm>
#include <cstring>
#include <graze/boolean.hpp>
#include <graze/decorated_functions.hpp>
#include <graze/functions/remainder.hpp>
#include <graze/graze.h>
#include <graze/numeric.hpp>
#include <graze/overlap.hpp>
#include <graze/reductions.hpp>
#include <graze/text.hpp>

namespace {

using graze::bounds;

bounds in(graze_interval x) {
  return graze::checking::is_empty(x.inf, x.sup) ? bounds::empty() : bounds{x.inf, x.sup};
}
graze_interval out(const bounds& x) { return {x.lo, x.hi}; }

graze::rounded direction_of(int direction) {
  using enum graze::rounded;
  return direction < 0 ? down : direction > 0 ? up : nearest;
}

/// A C function's arguments as those of a struct of graze::functions.
bounds argument(graze_interval x) { return in(x); }
inline int argument(int n) { return n; }

template <class F, class... Arguments> graze_interval call(Arguments... x) {
  return out(F::value(argument(x)...));
}

} // namespace

#define GRAZE_C_UNARY(name)                                                                        \
  graze_interval graze_##name(graze_interval x) { return call<graze::functions::name>(x); }
#define GRAZE_C_BINARY(name)                                                                       \
  graze_interval graze_##name(graze_interval x, graze_interval y) {                                \
    return call<graze::functions::name>(x, y);                                                     \
  }
#define GRAZE_C_TERNARY(name)                                                                      \
  graze_interval graze_##name(graze_interval x, graze_interval y, graze_interval z) {              \
    return call<graze::functions::name>(x, y, z);                                                  \
  }
#define GRAZE_C_INTEGER(name)                                                                      \
  graze_interval graze_##name(graze_interval x, int n) {                                           \
    return call<graze::functions::name>(x, n);                                                     \
  }

extern "C" {

GRAZE_C_UNARY(pos)
GRAZE_C_UNARY(neg)
GRAZE_C_BINARY(add)
GRAZE_C_BINARY(sub)
GRAZE_C_BINARY(mul)
GRAZE_C_BINARY(div)
GRAZE_C_UNARY(recip)
GRAZE_C_UNARY(sqr)
GRAZE_C_UNARY(sqrt)
GRAZE_C_TERNARY(fma)
GRAZE_C_UNARY(abs)
GRAZE_C_BINARY(min)
GRAZE_C_BINARY(max)
GRAZE_C_BINARY(fmod)
GRAZE_C_UNARY(sign)
GRAZE_C_UNARY(ceil)
GRAZE_C_UNARY(floor)
GRAZE_C_UNARY(trunc)
GRAZE_C_UNARY(round_ties_to_even)
GRAZE_C_UNARY(round_ties_to_away)
GRAZE_C_BINARY(intersection)
GRAZE_C_BINARY(convex_hull)
GRAZE_C_BINARY(cancel_plus)
GRAZE_C_BINARY(cancel_minus)
GRAZE_FOR_EACH_ELEMENTARY(GRAZE_C_UNARY)
GRAZE_C_BINARY(atan2)
GRAZE_C_BINARY(hypot)
GRAZE_C_BINARY(pow)
GRAZE_C_INTEGER(pown)
GRAZE_C_INTEGER(rootn)
GRAZE_C_BINARY(sqr_rev)
GRAZE_C_BINARY(abs_rev)
GRAZE_C_BINARY(sin_rev)
GRAZE_C_BINARY(cos_rev)
GRAZE_C_BINARY(tan_rev)
GRAZE_C_BINARY(cosh_rev)
GRAZE_C_TERNARY(mul_rev)
GRAZE_C_TERNARY(pow_rev1)
GRAZE_C_TERNARY(pow_rev2)
graze_interval graze_pown_rev(graze_interval c, graze_interval x, int n) {
  return call<graze::functions::pown_rev>(c, x, n);
}
void graze_mul_rev_to_pair(graze_interval b, graze_interval c, graze_interval result[2]) {
  const auto pair = graze::functions::mul_rev_to_pair::value(in(b), in(c));
  result[0] = out(pair.first);
  result[1] = out(pair.second);
}

bool graze_nums_to_interval(double lower, double upper, graze_interval* result) {
  const auto made = graze::nums_to_interval(lower, upper);
  *result = out(made.value);
  return made.signal == graze::exception::none;
}
graze_interval graze_empty(void) { return out(bounds::empty()); }
graze_interval graze_entire(void) { return out(bounds::entire()); }

#define GRAZE_C_NUMBER(name)                                                                       \
  double graze_##name(graze_interval x) {                                                          \
    return graze::at_border<[](graze_interval t) { return graze::name(in(t)); }>(x);               \
  }
GRAZE_C_NUMBER(inf)
GRAZE_C_NUMBER(sup)
GRAZE_C_NUMBER(mid)
GRAZE_C_NUMBER(rad)
GRAZE_C_NUMBER(wid)
GRAZE_C_NUMBER(mag)
GRAZE_C_NUMBER(mig)

#define GRAZE_C_TEST_OF_ONE(name)                                                                  \
  bool graze_##name(graze_interval x) {                                                            \
    return graze::at_border<[](graze_interval t) { return graze::name(in(t)); }>(x);               \
  }
GRAZE_C_TEST_OF_ONE(is_empty)
GRAZE_C_TEST_OF_ONE(is_entire)
GRAZE_C_TEST_OF_ONE(is_singleton)
GRAZE_C_TEST_OF_ONE(is_common_interval)
bool graze_is_member(double m, graze_interval x) {
  return graze::at_border<[](double t, graze_interval u) { return graze::is_member(t, in(u)); }>(m,
                                                                                                 x);
}

#define GRAZE_C_TEST(name)                                                                         \
  bool graze_##name(graze_interval x, graze_interval y) {                                          \
    return graze::at_border<[](graze_interval t, graze_interval u) {                               \
      return graze::name(in(t), in(u));                                                            \
    }>(x, y);                                                                                      \
  }
GRAZE_C_TEST(equal)
GRAZE_C_TEST(subset)
GRAZE_C_TEST(interior)
GRAZE_C_TEST(less)
GRAZE_C_TEST(strict_less)
GRAZE_C_TEST(precedes)
GRAZE_C_TEST(strict_precedes)
GRAZE_C_TEST(disjoint)

const char* graze_overlap(graze_interval x, graze_interval y) {
  return graze::at_border<[](graze_interval t, graze_interval u) {
    return graze::name_of(graze::overlap(in(t), in(u)));
  }>(x, y);
}

const char* graze_text_to_interval(const char* text, graze_interval* result) {
  const auto read = graze::text_to_interval(text);
  *result = out(read.value);
  return read.signal == graze::exception::none ? nullptr : graze::name_of(read.signal);
}

size_t graze_interval_to_text(graze_interval x, bool hexadecimal, char* buffer, size_t size) {
  using graze::text_style;
  const std::string text =
      graze::interval_to_text(in(x), hexadecimal ? text_style::hexadecimal : text_style::decimal);
  if (size != 0) {
    const std::size_t length = std::min(text.size(), size - 1);
    std::memcpy(buffer, text.data(), length);
    buffer[length] = '\0';
  }
  return text.size();
}

double graze_sum(const double* x, size_t n, int direction) {
  return graze::sum({x, n}, direction_of(direction));
}
double graze_sum_abs(const double* x, size_t n, int direction) {
  return graze::sum_abs({x, n}, direction_of(direction));
}
double graze_sum_sqr(const double* x, size_t n, int direction) {
  return graze::sum_sqr({x, n}, direction_of(direction));
}
double graze_dot(const double* x, const double* y, size_t n, int direction) {
  return graze::dot({x, n}, {y, n}, direction_of(direction));
}

} // extern "C"
