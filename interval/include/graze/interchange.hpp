#pragma once
/// The interchange representation of IEEE 1788.1, 7.3 (IEEE 1788-2015, 14.4): the bytes of inf and
/// sup, and the decoration's octet. Exact both ways; the same bytes on every machine for the same
/// byte order.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <graze/decorated_bounds.hpp>
#include <graze/numeric.hpp>
#include <optional>

namespace graze {

using interval_bytes = std::array<std::byte, 16>;
using decorated_bytes = std::array<std::byte, 17>;

namespace detail {
inline void put_double(std::byte* to, double x, std::endian order) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  for (int i = 0; i < 8; ++i)
    to[order == std::endian::little ? i : 7 - i] = static_cast<std::byte>(bits >> (8 * i) & 0xff);
}
inline double get_double(const std::byte* from, std::endian order) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i)
    bits |= std::to_integer<std::uint64_t>(from[order == std::endian::little ? i : 7 - i])
            << (8 * i);
  return std::bit_cast<double>(bits);
}
} // namespace detail

/// inf(x), then sup(x): a zero is -0 as inf and +0 as sup, the empty set (+inf, -inf).
inline interval_bytes to_bytes(const bounds& x, std::endian order = std::endian::little) {
  interval_bytes bytes;
  detail::put_double(bytes.data(), inf(x), order);
  detail::put_double(bytes.data() + 8, sup(x), order);
  return bytes;
}

/// The same and an octet: ill 0, trv 4, def 8, dac 12, com 16. NaI is (NaN, NaN, ill).
inline decorated_bytes to_bytes(const decorated_bounds& x,
                                std::endian order = std::endian::little) {
  decorated_bytes bytes;
  detail::put_double(bytes.data(), inf(x), order);
  detail::put_double(bytes.data() + 8, sup(x), order);
  bytes[16] = static_cast<std::byte>(x.label);
  return bytes;
}

/// The set that the bytes stand for; nothing for any other pair of doubles (the standard's
/// InvalidOperand). Zeros of either sign are read.
inline std::optional<bounds> bounds_from_bytes(const interval_bytes& bytes,
                                               std::endian order = std::endian::little) {
  const double lower = detail::get_double(bytes.data(), order),
               upper = detail::get_double(bytes.data() + 8, order);
  if (lower == checking::infinity && upper == -checking::infinity)
    return bounds::empty();
  if (checking::is_empty(lower, upper))
    return std::nullopt;
  return bounds{lower, upper};
}

/// The same with its decoration, which must be one that the set can have.
inline std::optional<decorated_bounds>
decorated_from_bytes(const decorated_bytes& bytes, std::endian order = std::endian::little) {
  const auto label = static_cast<decoration>(bytes[16]);
  if (label == decoration::ill) {
    const bool nai = checking::is_nan(detail::get_double(bytes.data(), order)) &&
                     checking::is_nan(detail::get_double(bytes.data() + 8, order));
    return nai ? std::optional(decorated_bounds::nai()) : std::nullopt;
  }
  interval_bytes set;
  std::copy_n(bytes.begin(), set.size(), set.begin());
  const std::optional<bounds> x = bounds_from_bytes(set, order);
  if (!x)
    return std::nullopt;
  switch (label) {
  case decoration::com:
    return x->is_common() ? std::optional(decorated_bounds{*x, label}) : std::nullopt;
  case decoration::dac:
  case decoration::def:
    return x->is_empty() ? std::nullopt : std::optional(decorated_bounds{*x, label});
  case decoration::trv:
    return decorated_bounds{*x, label};
  default:
    return std::nullopt;
  }
}

} // namespace graze
