// Uses the installed headers only; returns 0 when the bounds hold.
#include <graze/interval.hpp>
#include <graze/octree/sound.hpp>
#include <graze/rounding/upward.hpp>

int main() {
  const graze::interval<> sum = graze::interval<>(0.1) + graze::interval<>(0.2);
  const bool enclosed = sum.lower() == 0x1.3333333333333p-2 && sum.upper() == 0x1.3333333333334p-2;

  using method = graze::octree::sound<graze::rounding::upward, graze::octree::convention::owned>;
  const auto ray = graze::octree::ray::make({-1, 0.5, 0.5}, {1, 0, 0});
  const method::scope scope;
  method::state state;
  return enclosed && ray && method(*ray).enter({{0, 0, 0}, 1}, state) ? 0 : 1;
}
