#pragma once
/// The operations of Graze by the names that .itl files call them.
#include <graze/itf1788/value.hpp>
#include <span>
#include <string_view>

namespace graze::itf1788 {

/// What an operation gave: its results (two of mulRevToPair and midRad) and what it signalled.
struct result {
  std::vector<value> values;
  std::string signal; ///< the exception's name in IEEE 1788-2015; empty: none
};

/// Calls the operation of this name. Nothing if Graze has none for operands of these kinds.
/// Operands beyond those that the operation takes are ignored, as by the framework. All intervals
/// are bare or all are decorated.
std::optional<result> call(std::string_view name, std::span<const value> operands);

} // namespace graze::itf1788
