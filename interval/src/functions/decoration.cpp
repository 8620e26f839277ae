#include <graze/decoration.hpp>

namespace graze {

const char* name_of(decoration d) {
  switch (d) {
  case decoration::ill:
    return "ill";
  case decoration::trv:
    return "trv";
  case decoration::def:
    return "def";
  case decoration::dac:
    return "dac";
  case decoration::com:
    return "com";
  }
  return "ill";
}

} // namespace graze
