#pragma once
/// The tape: what a text formula is compiled to, a list of operations on registers, without loops
/// and without anything that depends on the number type over which it is run (evaluate.hpp).
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

/// The functions of one variable that graze::functions has under the same names.
#define GRAZE_TAPE_FUNCTIONS(F)                                                                    \
  F(cbrt)                                                                                          \
  F(exp)                                                                                           \
  F(exp2)                                                                                          \
  F(exp10)                                                                                         \
  F(expm1)                                                                                         \
  F(log)                                                                                           \
  F(log2)                                                                                          \
  F(log10)                                                                                         \
  F(logp1)                                                                                         \
  F(sin)                                                                                           \
  F(cos)                                                                                           \
  F(tan)                                                                                           \
  F(cot)                                                                                           \
  F(sec)                                                                                           \
  F(csc)                                                                                           \
  F(asin)                                                                                          \
  F(acos)                                                                                          \
  F(atan)                                                                                          \
  F(acot)                                                                                          \
  F(sinh)                                                                                          \
  F(cosh)                                                                                          \
  F(tanh)                                                                                          \
  F(coth)                                                                                          \
  F(sech)                                                                                          \
  F(csch)                                                                                          \
  F(asinh)                                                                                         \
  F(acosh)                                                                                         \
  F(atanh)                                                                                         \
  F(acoth)                                                                                         \
  F(sign)                                                                                          \
  F(floor)                                                                                         \
  F(ceil)                                                                                          \
  F(trunc)

namespace graze::octree::tape {

enum class opcode : std::uint8_t {
  constant,     ///< constants[n]
  add_constant, ///< a + constants[n]
  mul_constant, ///< a constants[n]
  add,
  sub,
  mul,
  div,
  neg,
  recip, ///< 1 / a
  sqr,
  sqrt,
  abs,
  min,
  max,
  pown,       ///< a^n, n an integer
  rootn,      ///< the n-th root of a
  polynomial, ///< polynomials[n] at a
  pow,        ///< a^b = e^(b log a)
  hypot,
  atan2,  ///< the angle of (b, a)
  select, ///< register b where a > 0, register n where a <= 0
#define GRAZE_TAPE_OPCODE(name) name,
  GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_OPCODE)
#undef GRAZE_TAPE_OPCODE
      variable, ///< in the compiler only; on a tape a variable is a register
};

/// register `target` becomes op(register a, register b, n).
struct instruction {
  opcode op;
  std::uint8_t target, a, b;
  std::int32_t n;
};

/// Doubles that enclose a real number, and one near it.
struct constant {
  double lo, hi, nearest;
};

/// All turning points of a polynomial in [lo, hi], and all of its values there in [least,
/// greatest].
struct turn {
  double lo, hi, least, greatest;
};

/// Coefficients, the highest first, and turns, in ascending order, are parts of the program's.
/// Between the turns it is monotone.
struct polynomial {
  std::uint32_t first_coefficient, degree;
  std::uint32_t first_turn, turns;
  std::uint32_t derivative; ///< also one of the program's; of a derivative without meaning
};

/// What a reader should know where the power's base is not >= 0.
struct note {
  std::size_t instruction; ///< the power's
  std::string text;
};

/// f as a polynomial with rational coefficients: what a closer look is taken at.
struct exact_polynomial;

/// A tape with all that it refers to.
struct program {
  static constexpr unsigned most_registers = 128;
  std::vector<instruction> code;
  std::vector<tape::constant> constants;
  std::vector<tape::polynomial> polynomials;
  std::vector<turn> turns;
  /// x, y and z are in registers 0 to 2 at the beginning.
  std::uint8_t registers = 3, result = 0;
  /// The formula is defined and continuous at every point of space.
  bool continuous = true;
  /// Its natural interval extension is its range but for rounding.
  bool tight = true;
  /// Where f is a polynomial whose coefficients are rational and known, and which is not too large.
  std::shared_ptr<const exact_polynomial> exact;
  std::string text;                    ///< of which it was compiled
  std::vector<std::string> parameters; ///< those that it uses
  std::vector<note> notes;
};

} // namespace graze::octree::tape
