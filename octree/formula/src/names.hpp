#pragma once
/// The names that have a meaning in every formula, in upper case and lower case.
#include <graze/octree_formula/tape.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace graze::octree::tape {

struct built_in_name {
  enum class kind : std::uint8_t {
    coordinate, ///< `which` is the axis
    pi,
    e,
    radius, ///< r; these four may be defined anew
    distance,
    azimuth,
    polar_angle,
    unary, ///< of one operand
    binary,
    many, ///< of two or more, from left to right
    clamp,
    modulo,
    choice, ///< if(c, a, b)
    difference,
    power,
    integer_power,
    root,
    conjunction,
    disjunction,
    negation
  };
  std::string_view name;
  kind what;
  opcode op = opcode::variable;
  int which = 0;

  [[nodiscard]] bool may_be_defined() const {
    return what == kind::radius || what == kind::distance || what == kind::azimuth ||
           what == kind::polar_angle;
  }
  /// and, or, not
  [[nodiscard]] bool is_joint() const { return what >= kind::conjunction; }
  [[nodiscard]] bool is_function() const { return kind::unary <= what && what <= kind::root; }
};

/// Nothing where it is none.
const built_in_name* find_built_in(std::string_view name);

/// A known name, or one of `others`, that is nearly this one; empty if there is none.
std::string nearest_name(std::string_view name, std::span<const std::string> others);

} // namespace graze::octree::tape
