#pragma once
/// x y + z rounded once, towards -inf or +inf: no fused instruction is needed, and one that the
/// compiler might use is not relied on. Defined in interval/src/functions/fused.cpp.
namespace graze::rounding {

/// Correctly rounded on every input, in any environment; NaN and infinities as IEEE 754 has it for
/// fusedMultiplyAdd. An exact zero is -0 for `down` and +0 for `up`, unless both terms are zeros of
/// one sign.
double fma_down(double x, double y, double z);
double fma_up(double x, double y, double z);

namespace detail {
/// fma_up where the processor rounds to nearest and flushes nothing: within a scope.
double fma_up(double x, double y, double z);
} // namespace detail

} // namespace graze::rounding
