#include "closer_look.hpp"

#include <graze/octree_formula.hpp>

namespace graze::octree {

certified_hit formula_surface::look_closer(const ray& r, const box& domain,
                                           const certified_hit& found) const {
  if (const auto decided = closer_look::at_polynomial(*program_, r, domain, found))
    return *decided;
  if (const auto decided = closer_look::at_gaps(*program_, r, domain, found))
    return *decided;
  return found;
}

} // namespace graze::octree
