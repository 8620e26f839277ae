#pragma once
#include "evaluate.hpp"
#include <graze/octree/eight.hpp>
#include <graze/octree/surfaces.hpp>

namespace graze::test {
namespace {

template <class Path> void evaluate_by(const eight_boxes& b, eight_values& r) {
  using I = interval8<Path>;
  const typename Path::scope scope;
  const I x = I::load(b.lo[0], b.hi[0]), y = I::load(b.lo[1], b.hi[1]),
          z = I::load(b.lo[2], b.hi[2]);
  const auto keep = [&r](int scene, const I& value) {
    value.store(r.lo[scene], r.hi[scene]);
    r.holds_zero[scene] = contains_zero(value).bits;
  };
  keep(spheres_scene, octree::spheres{}(x, y, z));
  keep(quartdef_scene, octree::quartdef{}(x, y, z));
  keep(tanglecube_scene, octree::tanglecube{}(x, y, z));
  keep(holesrot_scene, octree::holesrot{}(x, y, z));
}

} // namespace
} // namespace graze::test
