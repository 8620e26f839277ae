#pragma once
/// The library's border: behind it the processor rounds to nearest and knows subnormal numbers,
/// whatever the caller has set. Internal.
///
/// Every entry point that is compiled here is immune in one of three ways: it is made of integers
/// and of comparisons that flushing (FTZ, DAZ) and rounding do not touch; it takes a scope of its
/// own before it looks at an operand (elementary/correctly_rounded.hpp, batches); or it is
///   double f(double x) { return at_border<inside::f>(x); }
#include <graze/rounding/hardware.hpp>
#include <utility>

namespace graze {

#if defined(__x86_64__)

/// What a caller has set, but for the flags that stay raised.
class callers_environment {
public:
  [[gnu::always_inline]] callers_environment() : found_(rounding::hardware::mxcsr()) {}
  [[nodiscard, gnu::always_inline]] bool is_default() const {
    return (found_ & ~flags) == at_start;
  }
  [[gnu::always_inline]] void set_default() const { rounding::hardware::set_mxcsr(at_start); }
  [[gnu::always_inline]] void restore() const { rounding::hardware::set_mxcsr(found_); }

private:
  static constexpr unsigned flags = 0x3f;
  static constexpr auto at_start = static_cast<unsigned>(rounding::hardware::mode::nearest);
  unsigned found_;
};

#else

class callers_environment {
public:
  callers_environment() { std::fegetenv(&found_); }
  [[nodiscard]] bool is_default() const {
    double tiny = 0x1p-1022;
    rounding::hardware::pin(tiny);
    double half = tiny / 2;
    rounding::hardware::pin(half);
    return std::fegetround() == FE_TONEAREST && half + half == tiny;
  }
  void set_default() const { std::fesetenv(FE_DFL_ENV); }
  void restore() const { std::fesetenv(&found_); }

private:
  std::fenv_t found_;
};

#endif

/// Nothing is computed with x before this, nor, of a result, moved behind it.
template <class T> [[gnu::always_inline]] inline void hold(T& x) {
  asm volatile("" : "+m"(x) : : "memory");
}

/// The same for two numbers in registers, within a scope: what is compared is compared there.
[[gnu::always_inline]] inline void hold(double& x, double& y) {
  rounding::hardware::pin(x), rounding::hardware::pin(y);
}

template <auto Function, class... X>
[[gnu::cold, gnu::noinline]] auto from_elsewhere(callers_environment caller, X... x) {
  caller.set_default();
  (hold(x), ...);
  auto result = Function(std::move(x)...);
  hold(result);
  caller.restore();
  return result;
}

/// Function(x...) behind the border. Costs the reading of one control word.
template <auto Function, class... X> [[gnu::always_inline]] inline auto at_border(X... x) {
  const callers_environment caller;
  if (caller.is_default()) [[likely]]
    return Function(std::move(x)...);
  return from_elsewhere<Function>(caller, std::move(x)...);
}

} // namespace graze
