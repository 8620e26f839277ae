#include "natural.hpp"
#include <algorithm>
#include <bit>
#include <cassert>

namespace graze::detail {

natural::natural(std::uint64_t n) {
  for (; n != 0; n >>= 32)
    limbs_.push_back(static_cast<std::uint32_t>(n));
}

void natural::trim() {
  while (!limbs_.empty() && limbs_.back() == 0)
    limbs_.pop_back();
}

void natural::multiply_add(std::uint32_t factor, std::uint32_t addend) {
  std::uint64_t carry = addend;
  for (std::uint32_t& limb : limbs_) {
    carry += std::uint64_t{limb} * factor;
    limb = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  if (carry != 0)
    limbs_.push_back(static_cast<std::uint32_t>(carry));
}

std::uint32_t natural::divide(std::uint32_t divisor) {
  std::uint64_t rest = 0;
  for (auto limb = limbs_.rbegin(); limb != limbs_.rend(); ++limb) {
    rest = (rest << 32) | *limb;
    *limb = static_cast<std::uint32_t>(rest / divisor);
    rest %= divisor;
  }
  trim();
  return static_cast<std::uint32_t>(rest);
}

natural natural::of_decimal(std::string_view digits) {
  natural n;
  n.limbs_.reserve(digits.size() / 9 + 1);
  while (!digits.empty()) {
    const std::string_view some = digits.substr(0, 9); // 10^9 < 2^32
    std::uint32_t value = 0, factor = 1;
    for (const char c : some) {
      value = value * 10 + static_cast<std::uint32_t>(c - '0');
      factor *= 10;
    }
    n.multiply_add(factor, value);
    digits.remove_prefix(some.size());
  }
  n.trim();
  return n;
}

natural natural::of_hexadecimal(std::string_view digits) {
  natural n;
  n.limbs_.assign(digits.size() / 8 + 1, 0);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const char c = digits[digits.size() - 1 - i];
    const auto digit = static_cast<std::uint32_t>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
    n.limbs_[i / 8] |= digit << (4 * (i % 8));
  }
  n.trim();
  return n;
}

natural natural::power_of_five(std::uint64_t exponent) {
  natural power = 1, square = 5;
  for (; exponent != 0; exponent >>= 1) {
    if ((exponent & 1) != 0)
      power = power * square;
    if (exponent > 1)
      square = square * square;
  }
  return power;
}

std::uint64_t natural::bit_length() const {
  return limbs_.empty()
             ? 0
             : 32 * limbs_.size() - static_cast<std::uint64_t>(std::countl_zero(limbs_.back()));
}

std::uint64_t natural::trailing_zeros() const {
  std::uint64_t n = 0;
  std::size_t i = 0;
  for (; limbs_[i] == 0; ++i)
    n += 32;
  return n + static_cast<std::uint64_t>(std::countr_zero(limbs_[i]));
}

std::string natural::decimal() const {
  if (is_zero())
    return "0";
  std::string reversed;
  for (natural rest = *this; !rest.is_zero();) {
    std::uint32_t some = rest.divide(1000000000);
    for (int i = 0; i < 9; ++i, some /= 10)
      reversed.push_back(static_cast<char>('0' + some % 10));
  }
  reversed.erase(reversed.find_last_not_of('0') + 1);
  std::reverse(reversed.begin(), reversed.end());
  return reversed;
}

natural& natural::operator+=(const natural& other) {
  limbs_.resize(std::max(limbs_.size(), other.limbs_.size()) + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    carry += std::uint64_t{limbs_[i]} + (i < other.limbs_.size() ? other.limbs_[i] : 0);
    limbs_[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  trim();
  return *this;
}

natural& natural::operator-=(const natural& other) {
  assert(other <= *this);
  std::int64_t carry = 0;
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    carry += std::int64_t{limbs_[i]} - (i < other.limbs_.size() ? other.limbs_[i] : 0);
    limbs_[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32; // arithmetic: -1 is a borrow
  }
  trim();
  return *this;
}

natural& natural::operator<<=(std::uint64_t bits) {
  if (is_zero())
    return *this;
  limbs_.insert(limbs_.begin(), bits / 32, 0);
  return multiply_add(std::uint32_t{1} << (bits % 32), 0), *this;
}

natural& natural::operator>>=(std::uint64_t bits) {
  if (bits / 32 >= limbs_.size()) {
    limbs_.clear();
    return *this;
  }
  limbs_.erase(limbs_.begin(), limbs_.begin() + static_cast<std::ptrdiff_t>(bits / 32));
  divide(std::uint32_t{1} << (bits % 32));
  return *this;
}

natural operator*(const natural& x, const natural& y) {
  natural product;
  product.limbs_.assign(x.limbs_.size() + y.limbs_.size(), 0);
  for (std::size_t i = 0; i < x.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < y.limbs_.size(); ++j) { // at most (2^32 - 1)^2 + 2 (2^32 - 1)
      carry += std::uint64_t{x.limbs_[i]} * y.limbs_[j] + product.limbs_[i + j];
      product.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    product.limbs_[i + y.limbs_.size()] = static_cast<std::uint32_t>(carry);
  }
  product.trim();
  return product;
}

std::strong_ordering operator<=>(const natural& x, const natural& y) {
  if (x.limbs_.size() != y.limbs_.size())
    return x.limbs_.size() <=> y.limbs_.size();
  return std::lexicographical_compare_three_way(x.limbs_.rbegin(), x.limbs_.rend(),
                                                y.limbs_.rbegin(), y.limbs_.rend());
}

// D. Knuth, The Art of Computer Programming 2, 4.3.1, algorithm D: each digit of the quotient is
// estimated from the leading two limbs of the divisor, whose first bit is set, and is at most one
// too large.
natural::quotient natural::divided_by(const natural& divisor) const {
  assert(!divisor.is_zero());
  natural u = *this, v = divisor;
  // at least two limbs, the first bit set; the same factor for both
  const std::uint64_t shift = (divisor.limbs_.size() == 1 ? 32 : 0) +
                              static_cast<std::uint64_t>(std::countl_zero(divisor.limbs_.back()));
  u <<= shift;
  v <<= shift;
  const std::size_t n = v.limbs_.size();
  if (u.limbs_.size() < n)
    return {0, !u.is_zero()};
  u.limbs_.push_back(0);
  const std::uint64_t v1 = v.limbs_[n - 1], v2 = v.limbs_[n - 2];
  rounding::exact::uint128 value = 0;
  for (std::size_t j = u.limbs_.size() - n; j-- > 0;) {
    std::uint32_t* const part = &u.limbs_[j];
    const std::uint64_t leading = (std::uint64_t{part[n]} << 32) | part[n - 1];
    std::uint64_t digit = leading / v1, rest = leading % v1;
    while (digit >> 32 != 0 || digit * v2 > ((rest << 32) | part[n - 2])) {
      --digit;
      rest += v1;
      if (rest >> 32 != 0)
        break;
    }
    std::int64_t borrow = 0;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < n; ++i) {
      carry += digit * v.limbs_[i];
      borrow += std::int64_t{part[i]} - static_cast<std::uint32_t>(carry);
      part[i] = static_cast<std::uint32_t>(borrow);
      borrow >>= 32;
      carry >>= 32;
    }
    borrow += std::int64_t{part[n]} - static_cast<std::int64_t>(carry);
    part[n] = static_cast<std::uint32_t>(borrow);
    if (borrow < 0) { // one too large
      --digit;
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < n; ++i) {
        sum += std::uint64_t{part[i]} + v.limbs_[i];
        part[i] = static_cast<std::uint32_t>(sum);
        sum >>= 32;
      }
      part[n] += static_cast<std::uint32_t>(sum);
    }
    value = (value << 32) | digit;
  }
  u.trim();
  return {value, !u.is_zero()};
}

} // namespace graze::detail
