#pragma once
/// What the lanes of a path say of a surface on eight boxes.
#include <graze/batch/per_path.hpp>
#include <graze/octree/asterisk.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree_formula.hpp>

namespace graze::twins {

struct eight_bounds {
  double lo[8], hi[8];
};

/// Box i is lane i of the three.
struct eight_inputs {
  eight_bounds axis[3];
  double direction[3]; ///< of a line, for the derivative along it
};

struct evaluation {
  eight_bounds value, mean_value, of_dual, gradient[3], along, slope;
  unsigned no_zero, positive, negative; ///< lane i is bit i
};

/// Its natural extension is loose, so that the mean value form decides.
struct loose {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return x * x * y - y * z + z * z * z - x * y * z;
  }
};

/// The lesser of two of which either may be undefined, or its slopes unknown.
struct creased {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    using octree::lesser;
    return lesser(lesser(x - sqrt(y), sqrt(z) - y), z / x - y);
  }
};

/// A path's verdicts on each surface.
struct evaluations {
  void (*spheres)(const octree::spheres&, const eight_inputs&, evaluation&);
  void (*quartdef)(const octree::quartdef&, const eight_inputs&, evaluation&);
  void (*tanglecube)(const octree::tanglecube&, const eight_inputs&, evaluation&);
  void (*holesrot)(const octree::holesrot&, const eight_inputs&, evaluation&);
  void (*asterisk_3_4)(const octree::asterisk<3, 4>&, const eight_inputs&, evaluation&);
  void (*asterisk_9_18)(const octree::asterisk<9, 18>&, const eight_inputs&, evaluation&);
  void (*loose)(const twins::loose&, const eight_inputs&, evaluation&);
  void (*creased)(const twins::creased&, const eight_inputs&, evaluation&);
  void (*formula)(const octree::formula_surface&, const eight_inputs&, evaluation&);
};
GRAZE_DECLARE_ON_PATHS(evaluations, evaluations_of);

} // namespace graze::twins
