#pragma once
/// The number that a literal means, before any rounding.
#include "natural.hpp"
#include <graze/rounding/exact.hpp>

namespace graze::detail {

/// (-1)^negative * numerator / denominator * 2^twos * 5^fives, denominator > 0.
struct exact_number {
  bool negative = false;
  natural numerator, denominator = 1;
  std::int64_t twos = 0, fives = 0; ///< any: at most 2^62 in magnitude

  void scale_by_ten_to(std::int64_t exponent) { twos += exponent, fives += exponent; }

  [[nodiscard]] double rounded(rounding::exact::direction d) const;
};

bool operator==(const exact_number& x, const exact_number& y);

} // namespace graze::detail
