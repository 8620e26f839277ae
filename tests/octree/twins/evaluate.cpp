// What the lanes say of a surface on eight boxes, compiled for each path.
#include "evaluate.hpp"
#include <graze/octree/asterisk_eight.hpp>
#include <graze/octree/certified_eight.hpp>
#include <graze/octree_formula/operations_eight.hpp>

namespace graze::twins {
namespace {

template <class Path, class F> void evaluate(const F& f, const eight_inputs& b, evaluation& r) {
  using namespace octree;
  using I = interval8<Path>;
  const typename Path::scope scope;
  eight_boxes<Path> boxes;
  for (int a = 0; a < 3; ++a) {
    boxes.lo[a] = octet<Path>::load(b.axis[a].lo);
    boxes.hi[a] = octet<Path>::load(b.axis[a].hi);
  }
  const I x = boxes.axis(0), y = boxes.axis(1), z = boxes.axis(2);
  const auto keep = [](const I& v, eight_bounds& to) { v.store(to.lo, to.hi); };
  keep(f(x, y, z), r.value);
  keep(mean_value_form(f, x, y, z), r.mean_value);
  using gradient = dual<I>;
  const gradient g =
      f(gradient::variable(x, 0), gradient::variable(y, 1), gradient::variable(z, 2));
  keep(g.value, r.of_dual);
  for (int a = 0; a < 3; ++a)
    keep(g.partial[static_cast<std::size_t>(a)], r.gradient[a]);
  using slope = dual<I, 1>;
  const slope s = f(slope{x, {I(b.direction[0])}}, slope{y, {I(b.direction[1])}},
                    slope{z, {I(b.direction[2])}});
  keep(s.value, r.along);
  keep(s.partial[0], r.slope);
  r.no_zero = have_no_zero(f, boxes, 0xff);
  const eight_signs signs = signs_at(f, boxes);
  r.positive = signs.positive;
  r.negative = signs.negative;
}

template <class Path, class... F>
consteval evaluations make_evaluations(const std::tuple<octree::built_in_surface<F>...>&) {
  return {{&evaluate<Path, F>...},
          &evaluate<Path, twins::loose>,
          &evaluate<Path, twins::creased>,
          &evaluate<Path, octree::formula_surface>};
}

} // namespace

constinit const evaluations
    GRAZE_ON_PATH(evaluations_of) = make_evaluations<batch::this_path>(octree::built_in_surfaces);

} // namespace graze::twins
