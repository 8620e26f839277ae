#pragma once
/// Is the thread's floating-point environment one in which bounds hold? For entry points: they
/// refuse to run where it is not.
#include <graze/needs_cxx20.hpp>

#include <graze/expected.hpp>
#include <graze/rounding/hardware.hpp>
#include <optional>
#include <string>

namespace graze::rounding {

/// Why no bound computed in this environment can be trusted (subnormals are flushed, by FTZ or
/// DAZ), as one line; nothing if all is well. The scopes of `upward`, `split` and `switching` turn
/// flushing off for their own operations, but the tests and plain code around them would still see
/// it.
inline std::optional<std::string> refusal() {
#if defined(__x86_64__)
  const unsigned found = hardware::mxcsr();
  if ((found & hardware::mxcsr_flush_to_zero) != 0)
    return "the processor flushes subnormal results to zero (FTZ); bounds would not hold";
  if ((found & hardware::mxcsr_denormals_zero) != 0)
    return "the processor takes subnormal operands for zero (DAZ); bounds would not hold";
  return std::nullopt;
#else
  double tiny = 0x1p-1022, half = 0.5;
  hardware::pin(tiny), hardware::pin(half);
  double product = tiny * half;
  hardware::pin(product);
  if (product * 2 != tiny)
    return "the processor flushes subnormal numbers to zero; bounds would not hold";
  return std::nullopt;
#endif
}

/// As refusal(), and for the backend `nearest`: the rounding mode in force must be to-nearest.
inline std::optional<std::string> refusal_for_nearest() {
  if (auto reason = refusal())
    return reason;
#if defined(__x86_64__)
  const bool to_nearest = (hardware::mxcsr() & hardware::mxcsr_rounding) == 0;
#else
  const bool to_nearest = std::fegetround() == FE_TONEAREST;
#endif
  if (!to_nearest)
    return "the rounding mode is not to-nearest, which the backend `nearest` needs";
  return std::nullopt;
}

} // namespace graze::rounding
