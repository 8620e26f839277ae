#pragma once
/// What the lanes of a path say of a surface on eight boxes.
#include <graze/batch/per_path.hpp>
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

template <class F> using evaluator = void (*)(const F&, const eight_inputs&, evaluation&);
template <class... F>
std::tuple<evaluator<F>...> evaluators_of(const std::tuple<octree::built_in_surface<F>...>&);

/// A path's verdicts on each surface.
struct evaluations {
  decltype(evaluators_of(octree::built_in_surfaces)) built_in;
  evaluator<twins::loose> loose;
  evaluator<twins::creased> creased;
  evaluator<octree::formula_surface> formula;
};
GRAZE_DECLARE_ON_PATHS(evaluations, evaluations_of);

} // namespace graze::twins
