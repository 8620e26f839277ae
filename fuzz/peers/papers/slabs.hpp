#pragma once
/// What ray/box tests by slabs keep of a ray. The tests (williams, ize, tavian, pbrt) are in double,
/// written from their papers: made once a ray, from its origin and direction as they are, and asked
/// for boxes by their exact corners, for t >= 0.
#include <graze/octree/vector.hpp>

namespace graze::peers {

using octree::vec3;

class slabs {
public:
  slabs(const vec3& origin, const vec3& direction) : origin_(origin) {
    for (unsigned a = 0; a < 3; ++a)
      inverse_[a] = 1 / direction[a];
  }

protected:
  vec3 origin_, inverse_{};
};

} // namespace graze::peers
