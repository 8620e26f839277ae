#include "operation.hpp"
#include <unordered_map>

namespace graze::itf1788 {

std::vector<result> call(std::string_view name, std::span<const value> operands) {
  static const auto table = [] {
    std::unordered_map<std::string_view, const operation*> all;
    for (const auto& family : {arithmetic_operations(), elementary_operations(),
                               reverse_operations(), set_operations(), constructor_operations()})
      for (const operation& o : family)
        all.emplace(o.name, &o);
    return all;
  }();
  const auto found = table.find(name);
  return found == table.end() ? std::vector<result>{} : found->second->run(operands);
}

} // namespace graze::itf1788
