// Plain double and the C library's functions, not vectorised: what the others are measured in.
#include <cmath>

namespace graze::bench {
using std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
    std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
static double square(double x) { return x * x; }
static double pown(double x, int n) { return std::pow(x, n); }
} // namespace graze::bench
#include "measure.hpp"

namespace graze::bench {

namespace {
struct plain {
  static constexpr const char* name = "double";
  using number = double;
  struct scope {
    scope() {}
  };
  static void assign(double& x, const ends& e) { x = e.point; }
  static enclosure enclosed(double x) { return {x, x}; }
};
} // namespace

void measure_double() {
  using L = plain;
  measure_operators<L>();
  measure<L>("polynomial/mixed", operands::mixed, [](double& r, double x, double y, double z) {
    const double p = x * x, q = y * y, s = z * z;
    r = p * p - 5 * p + q * q - 5 * q + s * s - 5 * s + 11.8;
  });
  measure_functions<L>();
}

} // namespace graze::bench
