#pragma once
/// The operations of Graze by the names that .itl files call them.
#include <graze/itf1788/value.hpp>
#include <span>
#include <string_view>

namespace graze::itf1788 {

/// What an operation gave: its results (two of mulRevToPair and midRad) and what it signalled.
struct result {
  std::vector<value> values;
  std::string signal = {}; ///< the exception's name in IEEE 1788-2015; empty: none
  std::string form = {}; ///< which way of calling the operation gave it, if not the function itself
};

/// Calls the operation of this name in every form that Graze has for operands of these kinds: the
/// function on bounds, the operator on intervals with each backend, ... Each result must be right.
/// Empty if there is no such operation. All intervals are bare or all are decorated. Operands
/// beyond those that the operation takes are ignored, as by the framework.
std::vector<result> call(std::string_view name, std::span<const value> operands);

} // namespace graze::itf1788
