#pragma once
/// What a surface leaves of an octant's eight children: the question that every voxelization asks,
/// eager, parallel or lazy.
#include <graze/needs_cxx20.hpp>

#include <concepts>
#include <cstdint>
#include <graze/octree/cube.hpp>

namespace graze::octree {

/// What is proven about the zeros of f in a closed box.
enum class content : std::uint8_t {
  none = 0,      ///< f has no zero in the box
  possible = 1,  ///< neither is proven
  certified = 2, ///< f has opposite proven signs at two corners, hence a zero in the box
};

/// The children at the last level: bit i of `mask` is set where child i is kept, and bit i of
/// `certified`, a part of it, where a zero in it is proven.
struct leaf_children {
  std::uint8_t mask = 0, certified = 0;
};

/// Decides about the children of an octant; its functions are called within a scope and depend on
/// nothing but the octant. `octant` is what the judge knows one by, and what it finds out about one
/// it may note there for the octants below: a cube, or more. `open(octant)`: bit i is clear only
/// where f is proven to have no zero in child i within the domain. `leaves(octant)`: the same for
/// children at the last level, by the last-level test.
template <class J>
concept ChildrenJudge = std::constructible_from<typename J::octant, const cube&> &&
                        requires(const J judge, typename J::octant octant, unsigned child) {
                          typename J::scope;
                          { octant.child(child) } -> std::same_as<typename J::octant>;
                          { judge.open(octant) } -> std::same_as<std::uint8_t>;
                          { judge.leaves(octant) } -> std::same_as<leaf_children>;
                        };

} // namespace graze::octree
