#include "closer_look.hpp"

#include <graze/octree_formula.hpp>

namespace graze::octree {

certified_hit formula_surface::look_closer(const ray& r, const box& domain,
                                           const certified_hit& found) const {
  if (const auto decided = closer_look::at_polynomial(*program_, r, domain, found))
    return *decided;
  const certified_hit rest = closer_look::at_gaps(*program_, r, domain, found).value_or(found);
  return closer_look::at_face(*program_, r, domain, rest).value_or(rest);
}

} // namespace graze::octree
