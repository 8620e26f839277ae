#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <trial/number.hpp>

namespace graze::fuzz {

std::string hex(double x) { return fmt::format("{:a}", x); }

std::string bits_of(double x) { return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(x)); }

std::optional<double> number_of_bits(std::string_view text) {
  std::uint64_t bits = 0;
  if (text.size() != 16 ||
      text.find_first_not_of("0123456789abcdefABCDEF") != std::string_view::npos)
    return std::nullopt;
  std::from_chars(text.data(), text.data() + text.size(), bits, 16);
  return std::bit_cast<double>(bits);
}

std::optional<double> parse_number(std::string_view text) {
  if (const auto exact = number_of_bits(text))
    return std::isfinite(*exact) ? exact : std::nullopt;
  const std::string copy(text);
  // strtod alone would take leading blanks, "nan" and "infinity", and an empty string
  if (copy.empty() || copy.find_first_not_of("0123456789abcdefABCDEFxXpP+-.") != std::string::npos)
    return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  if (end != copy.c_str() + copy.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

} // namespace graze::fuzz
