#pragma once
/// Drives a ray/box predicate: what is needed to put one to the campaign is the predicate itself.
#include <graze/fuzz/traversal.hpp>

namespace graze::fuzz {

/// A predicate is made once a ray, from its origin and direction as they are, in double, and keeps
/// what its authors keep (the inverse direction, its signs); it is asked for each octant of the
/// block, by the exact corners, for t from 0 to infinity. Authors of such predicates promise
/// nothing about a box that the ray only touches: a miss is a box whose interior the ray crosses.
template <class Predicate> class box_traversal final : public traversal {
public:
  explicit box_traversal(std::string_view name) : name_(name) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }

  void visit(const trial& t, visited& out) override {
    const Predicate hits(t.origin, t.direction);
    for (voxel_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<voxel>(std::countr_zero(left));
      const cube box = t.octant(v);
      if (hits(box.lo, {box.hi(0), box.hi(1), box.hi(2)}))
        out.push(v);
    }
  }

private:
  std::string_view name_;
};

} // namespace graze::fuzz
