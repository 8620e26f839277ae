#include "../border.hpp"
#include <algorithm>
#include <graze/construct.hpp>

namespace graze {

const char* name_of(exception e) {
  switch (e) {
  case exception::none:
    return "";
  case exception::undefined_operation:
    return "UndefinedOperation";
  case exception::possibly_undefined_operation:
    return "PossiblyUndefinedOperation";
  case exception::interval_part_of_nai:
    return "IntvlPartOfNaI";
  }
  return "";
}

signalling<bounds> nums_to_interval(double lower, double upper) {
  if (at_border<checking::is_empty>(lower, upper))
    return {bounds::empty(), exception::undefined_operation};
  return {{lower, upper}};
}

signalling<decorated_bounds> nums_to_decorated(double lower, double upper) {
  if (at_border<checking::is_empty>(lower, upper))
    return {decorated_bounds::nai(), exception::undefined_operation};
  return {new_dec({lower, upper})};
}

decorated_bounds new_dec(const bounds& x) {
  return {x, x.is_empty() ? decoration::trv : x.is_common() ? decoration::com : decoration::dac};
}

signalling<decorated_bounds> set_dec(const bounds& x, decoration d) {
  if (d == decoration::ill)
    return {decorated_bounds::nai(), exception::undefined_operation};
  return {{x, std::min(d, new_dec(x).label)}};
}

signalling<bounds> interval_part(const decorated_bounds& x) {
  return {x.part, x.is_nai() ? exception::interval_part_of_nai : exception::none};
}

} // namespace graze
