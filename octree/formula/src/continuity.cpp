// Where operations are continuous: the decorations of the library's functions.
#include <graze/octree_formula/continuity.hpp>

namespace graze::octree::tape {

bool continuous_on(opcode op, const bounds& a, const bounds& b, int n) {
  switch (op) {
  case opcode::div:
    return functions::div::local(a, b) >= decoration::dac;
  case opcode::pow:
    return functions::pow::local(a, b) >= decoration::dac;
  case opcode::atan2:
    return functions::atan2::local(a, b) >= decoration::dac;
  case opcode::pown:
    return functions::pown::local(a, n) >= decoration::dac;
  case opcode::rootn:
    return functions::rootn::local(a, n) >= decoration::dac;
  case opcode::recip:
    return functions::recip::local(a) >= decoration::dac;
  case opcode::sqrt:
    return functions::sqrt::local(a) >= decoration::dac;
#define GRAZE_TAPE_LOCAL(name)                                                                     \
  case opcode::name:                                                                               \
    return functions::name::local(a) >= decoration::dac;
    GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_LOCAL)
#undef GRAZE_TAPE_LOCAL
  default:
    return true;
  }
}

} // namespace graze::octree::tape
