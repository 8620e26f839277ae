#pragma once
/// Decorations of IEEE 1788-2015, clause 11: what is known of how a result came to be.
#include <graze/needs_cxx20.hpp>

#include <cstdint>

namespace graze {

/// Ordered by what they promise, ill < trv < def < dac < com; a result has the least of its
/// operands' decorations and of the operation's own.
enum class decoration : std::uint8_t {
  ill = 0,  ///< not an interval: NaI only
  trv = 4,  ///< nothing
  def = 8,  ///< the function is defined everywhere on its box
  dac = 12, ///< defined and continuous on its box, which is not empty
  com = 16, ///< dac, the box bounded, and every computed result bounded
};

/// "com", "dac", "def", "trv", "ill".
const char* name_of(decoration d);

} // namespace graze
