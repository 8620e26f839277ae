#pragma once
/// What a tape is where it is a polynomial with rational coefficients: the numbers that its constants
/// enclose, and what a run of it over polynomials in one variable takes.
#include "exact_number.hpp"

#include <cstdint>
#include <graze/octree_formula/tape.hpp>
#include <memory>
#include <vector>

namespace graze::octree::tape {

/// An integer of at most Bits bits; its operations do not look for overflow.
template <unsigned Bits>
using fixed_integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<Bits, Bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// significand * 2^exponent, or next to it.
template <class Integer> struct binary_number {
  Integer significand;
  int exponent;
  bool is_exact;
};

/// x = n 2^exponent / d with d odd.
struct split_rational {
  integer n, d;
  int exponent;
};

struct exact_polynomial {
  static constexpr unsigned most_degree = 64;
  /// Products of coefficients in a run.
  static constexpr std::uint64_t most_work = 1 << 15;
  static constexpr unsigned short_bits = 256, long_bits = 1024;

  /// f has the zeros of this part of it: the first instructions of the tape, and where they leave it.
  std::size_t instructions;
  std::uint8_t result;
  bool is_power; ///< and f is a power of it: no zero is simple
  unsigned degree;
  std::uint64_t work;
  /// By the number of the program's constants; of those that are used.
  std::vector<split_rational> constants;
  std::vector<binary_number<fixed_integer<short_bits>>> short_constants;
  std::vector<binary_number<fixed_integer<long_bits>>> long_constants;
};

/// Bits of a significand of which products of two, and the sum of many of these, are Integers.
template <unsigned Bits> inline constexpr unsigned precision_of = Bits / 2 - 8;

/// Nothing where the program is no such polynomial, or too large a one.
std::shared_ptr<const exact_polynomial> exact_polynomial_of(const program& p,
                                                            const std::vector<number>& constants);

} // namespace graze::octree::tape
