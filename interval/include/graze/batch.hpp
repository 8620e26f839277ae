#pragma once
/// Interval operations over arrays, on the widest instructions that the processor has.
///
/// Layout: the lower bounds in one array, the upper bounds in another. A register then holds eight
/// ends of the same kind with no shuffling, and code that reads one kind of end (a comparison, a
/// reduction) touches half of the memory. Arrays of graze::bounds are taken too: their pairs are
/// sorted in registers.
///
/// Every operation is the tightest enclosure in each element (0 ulp), set-based, with the same bits
/// on every path; a zero bound is of either sign, the payload of the empty set's NaN is not
/// specified. Operands must be valid: both ends NaN (the empty set), or lo <= hi, lo < inf,
/// hi > -inf; what an invalid element gives is not specified, its neighbours are not touched by it.
///
/// The caller's rounding mode, FTZ, DAZ, exception masks and flags do not matter and are as before
/// afterwards: each call sets MXCSR and restores it. Any thread. A result may be an operand's own
/// arrays; arrays that overlap otherwise are a programming error, as are unequal sizes.
#include <graze/needs_cxx20.hpp>

#include <cstddef>
#include <cstdint>
#include <graze/bounds.hpp>
#include <optional>
#include <span>
#include <string>

namespace graze::batch {

/// Intervals [lo[i], hi[i]].
struct const_intervals {
  std::span<const double> lo, hi;
  [[nodiscard]] std::size_t size() const { return lo.size(); }
};
struct intervals {
  std::span<double> lo, hi;
  [[nodiscard]] std::size_t size() const { return lo.size(); }
  operator const_intervals() const { return {lo, hi}; }
};

// Which instructions.

enum class path {
  baseline, ///< SSE2 on x86-64; elsewhere one number at a time
  avx2,     ///< AVX2, FMA and POPCNT
  avx512,   ///< AVX-512 F and DQ (embedded rounding), BMI2 and POPCNT
};
inline constexpr path paths[] = {path::baseline, path::avx2, path::avx512};
/// baseline, avx2, avx512.
const char* name(path p);
/// Why this processor (or this build) cannot run the path; nothing if it can.
std::optional<std::string> refusal(path p);
/// The path that the span functions take: the last one forced; else the one that the environment
/// variable GRAZE_BATCH_PATH names; else the widest that runs here. Found out once.
path path_in_use();
/// All span functions of the process take p from now on. Refused with a reason if p cannot run
/// here; then nothing changes.
std::optional<std::string> force_path(path p);
/// Back to the path that the environment variable or the processor decides.
void unforce_path();
/// Why GRAZE_BATCH_PATH is not followed (an unknown name, or a path that cannot run here, in which
/// case the widest one runs: the bits are the same); nothing if it is not set or is followed.
std::optional<std::string> environment_refusal();

// Operations: r[i] encloses the operation's range over x[i], y[i], z[i], tightest.

#define GRAZE_BATCH_UNARY(operation)                                                               \
  void operation(const_intervals x, intervals r);                                                  \
  void operation(std::span<const bounds> x, std::span<bounds> r)
#define GRAZE_BATCH_BINARY(operation)                                                              \
  void operation(const_intervals x, const_intervals y, intervals r);                               \
  void operation(std::span<const bounds> x, std::span<const bounds> y, std::span<bounds> r)

GRAZE_BATCH_UNARY(neg);
GRAZE_BATCH_UNARY(sqr);
GRAZE_BATCH_UNARY(sqrt); ///< of the members that are not negative
GRAZE_BATCH_UNARY(abs);
GRAZE_BATCH_BINARY(add);
GRAZE_BATCH_BINARY(sub);
GRAZE_BATCH_BINARY(mul);
GRAZE_BATCH_BINARY(div); ///< by the members that are not zero; empty for y = [0, 0]
GRAZE_BATCH_BINARY(min);
GRAZE_BATCH_BINARY(max);
GRAZE_BATCH_BINARY(intersection);
GRAZE_BATCH_BINARY(hull);
#undef GRAZE_BATCH_UNARY
#undef GRAZE_BATCH_BINARY
/// x y + z, rounded once.
void fma(const_intervals x, const_intervals y, const_intervals z, intervals r);
void fma(std::span<const bounds> x, std::span<const bounds> y, std::span<const bounds> z,
         std::span<bounds> r);

// Predicates: element i is bit i % 8 of result[i / 8]; result has (size + 7) / 8 bytes, the last
// one's spare bits are 0. certainly_*: for all pairs of members, so also where one is empty.

void certainly_less(const_intervals x, const_intervals y, std::span<std::uint8_t> result);
void certainly_less_equal(const_intervals x, const_intervals y, std::span<std::uint8_t> result);
void equal(const_intervals x, const_intervals y, std::span<std::uint8_t> result);
void subset(const_intervals x, const_intervals y, std::span<std::uint8_t> result);
/// A common member exists.
void overlaps(const_intervals x, const_intervals y, std::span<std::uint8_t> result);
void contains_zero(const_intervals x, std::span<std::uint8_t> result);
void is_empty(const_intervals x, std::span<std::uint8_t> result);

// Polynomials. Each operation within is tightest; so is the whole but for rounding where no
// variable occurs twice.

/// (x^2 - s)^2 + (y^2 - s)^2 + (z^2 - s)^2 - c: the range but for rounding, since each variable
/// occurs once. With s = 5/2 and c = 139/20 this is x^4-5x^2 + y^4-5y^2 + z^4-5z^2 + 11.8 (the
/// tangle cube), with s = c = 1 the surface quartdef.
void biquadratic(const_intervals x, const_intervals y, const_intervals z, bounds s, bounds c,
                 intervals r);
/// c[0] + x (c[1] + x (c[2] + ...)), each step x * p + c rounded once; 0 for no coefficient. Holds
/// the range; wider than it where x occurs with both signs of influence.
void horner(std::span<const bounds> coefficients, const_intervals x, intervals r);

} // namespace graze::batch
