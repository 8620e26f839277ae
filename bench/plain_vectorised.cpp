// Plain double, vectorised by the compiler. Compiled without Graze's flags: a*b+c may be fused.
#include "plain_vectorised.hpp"
#include <cmath>

namespace graze::bench::plain {

#define GRAZE_EACH(expression)                                                                     \
  for (std::size_t i = 0; i < n; ++i)                                                              \
  r[i] = (expression)

void add(std::size_t n, const double* __restrict x, const double* __restrict y,
         double* __restrict r) {
  GRAZE_EACH(x[i] + y[i]);
}
void sub(std::size_t n, const double* __restrict x, const double* __restrict y,
         double* __restrict r) {
  GRAZE_EACH(x[i] - y[i]);
}
void mul(std::size_t n, const double* __restrict x, const double* __restrict y,
         double* __restrict r) {
  GRAZE_EACH(x[i] * y[i]);
}
void div(std::size_t n, const double* __restrict x, const double* __restrict y,
         double* __restrict r) {
  GRAZE_EACH(x[i] / y[i]);
}
void fma(std::size_t n, const double* __restrict x, const double* __restrict y,
         const double* __restrict z, double* __restrict r) {
  GRAZE_EACH(x[i] * y[i] + z[i]);
}
void sqr(std::size_t n, const double* __restrict x, double* __restrict r) {
  GRAZE_EACH(x[i] * x[i]);
}
void sqrt(std::size_t n, const double* __restrict x, double* __restrict r) {
  GRAZE_EACH(std::sqrt(x[i]));
}
void tanglecube(std::size_t n, const double* __restrict x, const double* __restrict y,
                const double* __restrict z, double* __restrict r) {
  for (std::size_t i = 0; i < n; ++i) {
    const double a = x[i] * x[i], b = y[i] * y[i], c = z[i] * z[i];
    r[i] = a * (a - 5) + b * (b - 5) + c * (c - 5) + 11.8;
  }
}

} // namespace graze::bench::plain
