#pragma once
/// Closer looks at a ray that certified_search leaves open. Each gives nothing where it is not for the
/// formula, or decides no more than `found`.
#include <graze/octree/certified_hit.hpp>
#include <graze/octree_formula/tape.hpp>
#include <optional>

namespace graze::octree::closer_look {

/// Where f is a polynomial: its roots along the ray.
std::optional<certified_hit> at_polynomial(const tape::program& f, const ray& r, const box& domain,
                                           const certified_hit& found);

/// Where f is not continuous: poles, jumps and the edges of its domain, at which it has no zero.
std::optional<certified_hit> at_gaps(const tape::program& f, const ray& r, const box& domain,
                                     const certified_hit& found);

/// Where f is exactly 0 at the point at which the ray enters or leaves the domain.
std::optional<certified_hit> at_face(const tape::program& f, const ray& r, const box& domain,
                                     const certified_hit& found);

} // namespace graze::octree::closer_look
