#include "operation.hpp"

namespace graze::itf1788 {

std::span<const operation> elementary_operations() {
  static constexpr std::array table{
      GRAZE_OPERATION("exp", exp, 1),
      GRAZE_OPERATION("exp2", exp2, 1),
      GRAZE_OPERATION("exp10", exp10, 1),
      GRAZE_OPERATION("expm1", expm1, 1),
      GRAZE_OPERATION("log", log, 1),
      GRAZE_OPERATION("log2", log2, 1),
      GRAZE_OPERATION("log10", log10, 1),
      GRAZE_OPERATION("logp1", logp1, 1),
      GRAZE_OPERATION("sin", sin, 1),
      GRAZE_OPERATION("cos", cos, 1),
      GRAZE_OPERATION("tan", tan, 1),
      GRAZE_OPERATION("cot", cot, 1),
      GRAZE_OPERATION("sec", sec, 1),
      GRAZE_OPERATION("csc", csc, 1),
      GRAZE_OPERATION("asin", asin, 1),
      GRAZE_OPERATION("acos", acos, 1),
      GRAZE_OPERATION("atan", atan, 1),
      GRAZE_OPERATION("acot", acot, 1),
      GRAZE_OPERATION("atan2", atan2, 2),
      GRAZE_OPERATION("sinh", sinh, 1),
      GRAZE_OPERATION("cosh", cosh, 1),
      GRAZE_OPERATION("tanh", tanh, 1),
      GRAZE_OPERATION("coth", coth, 1),
      GRAZE_OPERATION("sech", sech, 1),
      GRAZE_OPERATION("csch", csch, 1),
      GRAZE_OPERATION("asinh", asinh, 1),
      GRAZE_OPERATION("acosh", acosh, 1),
      GRAZE_OPERATION("atanh", atanh, 1),
      GRAZE_OPERATION("acoth", acoth, 1),
      GRAZE_OPERATION("cbrt", cbrt, 1),
      GRAZE_OPERATION("hypot", hypot, 2),
      GRAZE_OPERATION("pow", pow, 2),
      GRAZE_OPERATION_WITH_INTEGER("pown", pown, 1),
      GRAZE_OPERATION_WITH_INTEGER("rootn", rootn, 1),
  };
  return table;
}

} // namespace graze::itf1788
