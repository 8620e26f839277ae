#pragma once
/// What a batch of intervals is measured against: the same operation on plain doubles, as fast as
/// the compiler makes it (-O3 -mavx512f -mprefer-vector-width=512, see CMakeLists.txt).
#include <cstddef>

namespace graze::bench::plain {

void add(std::size_t n, const double* x, const double* y, double* r);
void sub(std::size_t n, const double* x, const double* y, double* r);
void mul(std::size_t n, const double* x, const double* y, double* r);
void div(std::size_t n, const double* x, const double* y, double* r);
void fma(std::size_t n, const double* x, const double* y, const double* z, double* r);
void sqr(std::size_t n, const double* x, double* r);
void sqrt(std::size_t n, const double* x, double* r);
/// x^4-5x^2 + y^4-5y^2 + z^4-5z^2 + 11.8
void tanglecube(std::size_t n, const double* x, const double* y, const double* z, double* r);

} // namespace graze::bench::plain
