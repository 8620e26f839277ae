// Uses the installed headers only; returns 0 when the bounds hold.
#include <graze/functions/exponential.hpp>
#include <graze/interval.hpp>
#include <graze/octree/sound.hpp>
#include <graze/point.hpp>
#include <graze/rounding/upward.hpp>

int main() {
  const graze::interval<> sum = graze::interval<>(0.1) + graze::interval<>(0.2);
  const bool enclosed = sum.lower() == 0x1.3333333333333p-2 && sum.upper() == 0x1.3333333333334p-2;

  // Compiled functions: the package brings the archives that they need.
  const graze::interval<> e = exp(graze::interval<>(1.0));
  const bool linked = e.lower() == 0x1.5bf0a8b145769p+1 && e.upper() == graze::point::exp_up(1);

  using method = graze::octree::sound<graze::rounding::upward, graze::octree::convention::owned>;
  const auto ray = graze::octree::ray::make({-1, 0.5, 0.5}, {1, 0, 0});
  const method::scope scope;
  method::state state;
  return enclosed && linked && ray && method(*ray).enter({{0, 0, 0}, 1}, state) ? 0 : 1;
}
