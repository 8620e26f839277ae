#pragma once
/// Trials of a backend's scope: entered from any MXCSR and x87 control word, left normally or by an
/// exception, it must restore both, and the bounds must hold in the meantime. x86-64 only.
#if !defined(__x86_64__)
#error "graze: these control words are those of x86-64"
#endif
#include <graze/oracle/hard_operands.hpp>
#include <graze/rounding/hardware.hpp>
#include <self/backend_operations.hpp>

namespace graze::fuzz::self {

/// What a caller may have set.
struct control_words {
  unsigned mxcsr;
  unsigned short x87;
  friend bool operator==(const control_words&, const control_words&) = default;
};
[[gnu::always_inline]] inline control_words control_words_now() {
  return {rounding::hardware::mxcsr(), rounding::hardware::x87_control()};
}
/// Every rounding mode, FTZ, DAZ, flags, exceptions masked or not; every precision and rounding of
/// the x87.
control_words any_control_words(oracle::random_bits& random);
/// Plain arithmetic is what it is at a program's start, but for this rounding (bits 13 and 14):
/// flags and the x87's words are any, all exceptions are masked, nothing is flushed.
control_words control_words_rounding(unsigned mode, oracle::random_bits& random);
/// "MXCSR 0x1f80, x87 0x037f"
std::string spelled(const control_words& w);

/// Control words for its life, then the process's own. In between, code that is not under test may
/// load and store numbers, no more: exceptions may be unmasked.
class control_words_scope {
public:
  explicit control_words_scope(const control_words& w) : found_(control_words_now()) {
    rounding::hardware::set_x87_control(w.x87);
    rounding::hardware::set_mxcsr(w.mxcsr);
  }
  ~control_words_scope() {
    asm volatile("fnclex");
    rounding::hardware::set_x87_control(found_.x87);
    rounding::hardware::set_mxcsr(found_.mxcsr);
  }
  control_words_scope(const control_words_scope&) = delete;
  control_words_scope& operator=(const control_words_scope&) = delete;

private:
  control_words found_;
};

/// Adds a flaw where control words changed. `flags`: the status flags count too.
void compare_words(const control_words& before, const control_words& after, bool flags,
                   observations& out);

/// Whose scope needs which words of the caller.
enum class callers_words {
  any,     ///< a scope that sets what it needs
  nearest, ///< the backend needs round to nearest and no flushing, and may raise flags
};

namespace detail {
struct thrown {};

/// Three operations in a scope of B within `w`, left by an exception where `leave_by_throw`.
template <class B>
[[gnu::noinline]] control_words in_scope(const control_words& w, const int (&n)[3],
                                         const double (&x)[3], const double (&y)[3], double (&r)[3],
                                         bool leave_by_throw) {
  const control_words_scope set(w);
  try {
    [[maybe_unused]] const typename B::scope scope;
    for (int i = 0; i < 3; ++i)
      r[i] = backend_operation<B>(n[i], x[i], y[i]);
    if (leave_by_throw)
      throw thrown{};
  } catch (const thrown&) {
  }
  const control_words after = control_words_now();
  asm volatile("fld1\n\tfstp %%st(0)" ::: "st"); // a pending x87 exception would trap here
  return after;
}
} // namespace detail

/// Trials of B's scope and of its ten operations within.
template <class B> part backend_words(std::string name, callers_words callers) {
  return {std::move(name), [callers](std::uint64_t seed, std::uint64_t index, observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            oracle::hard_operands make(random());
            const control_words w = callers == callers_words::any
                                        ? any_control_words(random)
                                        : control_words_rounding(0, random);
            int n[3];
            double x[3], y[3], r[3];
            for (int i = 0; i < 3; ++i) {
              n[i] = static_cast<int>(random() % 10);
              const auto p = make.next(static_cast<oracle::hardness>(
                  make.below(static_cast<std::uint64_t>(oracle::hardness::count))));
              x[i] = p.x, y[i] = p.y;
            }
            const bool leave_by_throw = random() % 4 == 0;
            const control_words after = detail::in_scope<B>(w, n, x, y, r, leave_by_throw);
            const std::size_t first = out.size();
            compare_words(w, after, callers == callers_words::any, out);
            for (int i = 0; i < 3; ++i)
              compare_operation(n[i], x[i], y[i], r[i], out);
            for (std::size_t i = first; i < out.size(); ++i)
              out[i].what += ", from " + spelled(w) + (leave_by_throw ? ", left by a throw" : "");
          }};
}

subject control_words_subject();

} // namespace graze::fuzz::self
