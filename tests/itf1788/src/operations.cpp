#include <graze/itf1788/operations.hpp>

namespace graze::itf1788 {

std::optional<result> call(std::string_view name, std::span<const value> operands) {
  if (name == "intersection" && operands.size() == 2)
    return result{{operands[0]}, ""};
  return std::nullopt;
}

} // namespace graze::itf1788
