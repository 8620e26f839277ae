#include "../elementary/correctly_rounded.hpp"
#include <graze/point.hpp>

namespace graze::point {

#define GRAZE_DEFINE(name)                                                                         \
  double name##_down(double x) {                                                                   \
    [[maybe_unused]] const correctly_rounded::name::scope scope;                                   \
    return correctly_rounded::name::down(x);                                                       \
  }                                                                                                \
  double name##_up(double x) {                                                                     \
    [[maybe_unused]] const correctly_rounded::name::scope scope;                                   \
    return correctly_rounded::name::up(x);                                                         \
  }
GRAZE_DEFINE(exp)
GRAZE_DEFINE(exp2)
GRAZE_DEFINE(exp10)
GRAZE_DEFINE(expm1)
GRAZE_DEFINE(log)
GRAZE_DEFINE(log2)
GRAZE_DEFINE(log10)
GRAZE_DEFINE(logp1)
GRAZE_DEFINE(sin)
GRAZE_DEFINE(cos)
GRAZE_DEFINE(tan)
GRAZE_DEFINE(asin)
GRAZE_DEFINE(acos)
GRAZE_DEFINE(atan)
GRAZE_DEFINE(sinh)
GRAZE_DEFINE(cosh)
GRAZE_DEFINE(tanh)
GRAZE_DEFINE(asinh)
GRAZE_DEFINE(acosh)
GRAZE_DEFINE(atanh)
GRAZE_DEFINE(cbrt)
#undef GRAZE_DEFINE

#define GRAZE_DEFINE(name)                                                                         \
  double name##_down(double x, double y) {                                                         \
    [[maybe_unused]] const correctly_rounded::name::scope scope;                                   \
    return correctly_rounded::name::down(x, y);                                                    \
  }                                                                                                \
  double name##_up(double x, double y) {                                                           \
    [[maybe_unused]] const correctly_rounded::name::scope scope;                                   \
    return correctly_rounded::name::up(x, y);                                                      \
  }
GRAZE_DEFINE(atan2)
GRAZE_DEFINE(hypot)
GRAZE_DEFINE(pow)
#undef GRAZE_DEFINE

const char* source() {
#if defined(GRAZE_ELEMENTARY_CRLIBM)
  return "CRlibm";
#else
  return "CORE-MATH";
#endif
}

} // namespace graze::point
