#include <cstdlib>
#include <fmt/format.h>
#include <trial/number.hpp>

namespace graze::fuzz {

std::string hex(double x) { return fmt::format("{:a}", x); }

std::optional<double> parse_number(std::string_view text) {
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
