#include "operation.hpp"
#include <graze/functions/exponential.hpp>
#include <graze/functions/hyperbolic.hpp>
#include <graze/functions/integer_power.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/reciprocal_hyperbolic.hpp>
#include <graze/functions/reciprocal_trigonometric.hpp>
#include <graze/functions/trigonometric.hpp>

namespace graze::itf1788 {

std::span<const operation> elementary_operations() {
  static constexpr std::array table{
      operation{"exp", function<functions::exp, 1>},
      operation{"exp2", function<functions::exp2, 1>},
      operation{"exp10", function<functions::exp10, 1>},
      operation{"expm1", function<functions::expm1, 1>},
      operation{"log", function<functions::log, 1>},
      operation{"log2", function<functions::log2, 1>},
      operation{"log10", function<functions::log10, 1>},
      operation{"logp1", function<functions::logp1, 1>},
      operation{"sin", function<functions::sin, 1>},
      operation{"cos", function<functions::cos, 1>},
      operation{"tan", function<functions::tan, 1>},
      operation{"cot", function<functions::cot, 1>},
      operation{"sec", function<functions::sec, 1>},
      operation{"csc", function<functions::csc, 1>},
      operation{"asin", function<functions::asin, 1>},
      operation{"acos", function<functions::acos, 1>},
      operation{"atan", function<functions::atan, 1>},
      operation{"acot", function<functions::acot, 1>},
      operation{"atan2", function<functions::atan2, 2>},
      operation{"sinh", function<functions::sinh, 1>},
      operation{"cosh", function<functions::cosh, 1>},
      operation{"tanh", function<functions::tanh, 1>},
      operation{"coth", function<functions::coth, 1>},
      operation{"sech", function<functions::sech, 1>},
      operation{"csch", function<functions::csch, 1>},
      operation{"asinh", function<functions::asinh, 1>},
      operation{"acosh", function<functions::acosh, 1>},
      operation{"atanh", function<functions::atanh, 1>},
      operation{"acoth", function<functions::acoth, 1>},
      operation{"cbrt", function<functions::cbrt, 1>},
      operation{"hypot", function<functions::hypot, 2>},
      operation{"pow", function<functions::pow, 2>},
      operation{"pown", function_with_integer<functions::pown, 1>},
      operation{"rootn", function_with_integer<functions::rootn, 1>},
  };
  return table;
}

} // namespace graze::itf1788
