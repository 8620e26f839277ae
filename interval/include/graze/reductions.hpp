#pragma once
/// Reductions of IEEE 1788.1, 12.12.12: sums of any length, exact until one final rounding. Defined
/// in interval/src/functions/reductions.cpp (a long accumulator).
#include <graze/needs_cxx20.hpp>

#include <span>

namespace graze {

/// Which double stands for the exact sum.
enum class rounded { nearest, down, up };

// A NaN among the operands, infinities of both signs in a sum, or 0 times infinity give NaN; other
// infinities give infinity. An exact zero, and the sum of nothing, is +0. Error: correctly rounded.

/// The sum of x.
double sum(std::span<const double> x, rounded to = rounded::nearest);
/// The sum of |x|.
double sum_abs(std::span<const double> x, rounded to = rounded::nearest);
/// The sum of x^2.
double sum_sqr(std::span<const double> x, rounded to = rounded::nearest);
/// The sum of the products x[i] y[i]; x and y of the same length.
double dot(std::span<const double> x, std::span<const double> y, rounded to = rounded::nearest);

} // namespace graze
