#pragma once
/// Is the thread's floating-point environment one in which bounds hold? Found out by computing, not
/// by reading a control word back: an emulator may store a rounding mode and go on to nearest.
#include <graze/needs_cxx20.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <graze/rounding/hardware.hpp>
#include <optional>
#include <string>

namespace graze::rounding {

namespace detail {

/// Bit for bit: where subnormal numbers count as zero, plain == would call them so.
inline bool same(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

/// What the processor makes of sums, products and quotients that every rounding makes differently.
struct witness {
  double sum, difference, quotient, subnormal_product, subnormal_operand;

  /// In the environment in force.
  [[nodiscard]] static witness now() {
    double one = 1, three = 3, small = 0x1p-60, tiny = 0x1p-1022, half = 0.5, least = 0x1p-1074;
    for (double* const x : {&one, &three, &small, &tiny, &half, &least})
      hardware::pin(*x);
    return {hardware::add(one, small), hardware::sub(one, small), hardware::div(one, three),
            hardware::mul(tiny, half), hardware::add(tiny, least)};
  }
  [[nodiscard]] bool rounds_to_nearest() const {
    return same(sum, 1) && same(difference, 1) && same(quotient, 0x1.5555555555555p-2);
  }
  [[nodiscard]] bool rounds_down() const {
    return same(sum, 1) && same(difference, 0x1.fffffffffffffp-1) &&
           same(quotient, 0x1.5555555555555p-2);
  }
  [[nodiscard]] bool rounds_up() const {
    return same(sum, 0x1.0000000000001p+0) && same(difference, 1) &&
           same(quotient, 0x1.5555555555556p-2);
  }
  [[nodiscard]] bool knows_subnormal_results() const { return same(subnormal_product, 0x1p-1023); }
  [[nodiscard]] bool knows_subnormal_operands() const {
    return same(subnormal_operand, 0x1.0000000000001p-1022);
  }
  [[nodiscard]] bool knows_subnormal_numbers() const {
    return knows_subnormal_results() && knows_subnormal_operands();
  }
};

/// A witness of the thread's own environment: all exceptions masked for as long as it takes, and
/// the flags as they were found.
inline witness witness_of_thread() {
#if defined(__x86_64__)
  constexpr unsigned all_masked = 0x1f80;
  const unsigned found = hardware::mxcsr();
  hardware::set_mxcsr(found | all_masked);
  const witness w = witness::now();
  hardware::set_mxcsr(found);
  return w;
#else
  return witness::now();
#endif
}
inline witness witness_within(hardware::mode m) {
  const hardware::mode_scope scope(m);
  return witness::now();
}

} // namespace detail

/// Why no bound computed in this environment can be trusted, as one line; nothing if all is well.
/// Either the thread flushes subnormal numbers (FTZ, DAZ: what is compiled in Graze is immune, and
/// every scope turns it off; plain code and comparisons of inlined intervals are not:
/// docs/numerics.md), or the machine does not round as it is told, in the scopes that say how.
inline std::optional<std::string> refusal() {
  const detail::witness thread = detail::witness_of_thread();
  if (!thread.knows_subnormal_results())
    return "the processor flushes subnormal results to zero (FTZ); bounds would not hold";
  if (!thread.knows_subnormal_operands())
    return "the processor takes subnormal operands for zero (DAZ); bounds would not hold";
  const detail::witness down = detail::witness_within(hardware::mode::down),
                        up = detail::witness_within(hardware::mode::up);
  if (!down.rounds_down() || !up.rounds_up() || !down.knows_subnormal_numbers() ||
      !up.knows_subnormal_numbers())
    return "this machine (an emulator, or valgrind) does not round as it is told; bounds would not "
           "hold";
  return std::nullopt;
}

/// As refusal(), and for the backend `nearest`: the rounding mode in force must be to-nearest.
inline std::optional<std::string> refusal_for_nearest() {
  if (auto reason = refusal())
    return reason;
  if (!detail::witness_of_thread().rounds_to_nearest())
    return "the rounding mode is not to-nearest, which the backend `nearest` needs";
  return std::nullopt;
}

/// The environment in which a program starts, for this thread and those that it will start: to
/// nearest, no flushing, all exceptions masked, the x87 at its full precision. A library linked
/// with -Ofast leaves another one in the thread that loads it.
inline void set_default_environment() {
#if defined(__x86_64__)
  asm volatile("fnclex" : "+m"(hardware::control_words));
  hardware::set_x87_control(0x037f);
  hardware::set_mxcsr(static_cast<unsigned>(hardware::mode::nearest));
#else
  std::fesetenv(FE_DFL_ENV);
#endif
}

/// For a program's main, first of all: sets the default environment, and where bounds would not
/// hold even so, says why on standard error ("PROGRAM: reason") and is false.
inline bool program_may_start(const char* program) {
  set_default_environment();
  const std::optional<std::string> reason = refusal_for_nearest();
  if (reason)
    std::fprintf(stderr, "%s: %s\n", program, reason->c_str());
  return !reason;
}

} // namespace graze::rounding
