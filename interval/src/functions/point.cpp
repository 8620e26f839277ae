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
GRAZE_FOR_EACH_POINT(GRAZE_DEFINE)
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
