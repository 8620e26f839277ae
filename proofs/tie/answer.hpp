#pragma once
/// What the code answers to a line, with any backend: the same names in the same order as
/// graze_model.ml.
#include "line.hpp"
#include "tree.hpp"
#include <graze/octree/ray.hpp>
#include <graze/octree/sound.hpp>

namespace graze::tie {

/// The method with the ray as the line gives it, as the model has it: not by its scaled direction.
template <octree::Method M> M prepared(const octree::ray& r) {
  return M(M::bounds::prepare(r.origin(), r.direction()));
}

/// The children that a method passes, in its order, and the descent; "-" for none.
template <octree::Method M>
std::string order_of_split(const octree::ray& r, const octree::cube& cell) {
  const M method = prepared<M>(r);
  typename M::state at{};
  (void)method.enter(cell, at);
  octree::branches<typename M::state> out;
  method.split(cell, at, out);
  std::string text;
  for (unsigned i = 0; i < out.size(); ++i)
    text += static_cast<char>('0' + out[i].index);
  return text.empty() ? "-" : text;
}

template <octree::Method M>
std::string order_of_visits(const octree::ray& r, const octree::cube& root) {
  unsigned count = 0;
  const std::uint64_t h = visits(prepared<M>(r), root, count);
  return visits_text(count, h);
}

/// The whole answer with backend B. Its scope is taken here.
template <rounding::Backend B> [[gnu::noinline]] answers answer(const line& l, bool show = false) {
  using namespace octree;
  using bounds = ray_bounds<B>;
  using interval = typename bounds::interval;
  constexpr auto closed = convention::closed, owned = convention::owned;
  const typename B::scope scope;
  answers a(show);
  const cube cell{l.lo, l.size};
  point hi = l.hi, mid = l.mid;
  if (l.kind != 'b')
    for (int i = 0; i < 3; ++i)
      hi[static_cast<std::size_t>(i)] = cell.hi(i), mid[static_cast<std::size_t>(i)] = cell.mid(i);
  const auto axes = bounds::prepare(l.o, l.d);
  std::array<interval, 3> at;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& axis = axes[i];
    const char* name = i == 0 ? "x" : i == 1 ? "y" : "z";
    a.number(name, ".c_down", axis.c_down);
    a.number(name, ".c_up", axis.c_up);
    a.number(name, ".lowb(lo,hi)", bounds::lowb(axis, l.lo[i], hi[i]));
    a.number(name, ".uppb(lo,hi)", bounds::uppb(axis, l.lo[i], hi[i]));
    a.number(name, ".lowb(mid,o)", bounds::lowb(axis, mid[i], axis.origin));
    a.number(name, ".uppb(mid,o)", bounds::uppb(axis, mid[i], axis.origin));
    a.number(name, ".enter_at(mid)", bounds::enter_at(axis, mid[i]));
    a.number(name, ".leave_at<closed>(mid)", bounds::template leave_at<closed>(axis, mid[i]));
    a.number(name, ".leave_at<owned>(mid)", bounds::template leave_at<owned>(axis, mid[i]));
    const interval in_owned = bounds::template within<owned>(axis, l.lo[i], hi[i]);
    at[i] = bounds::template within<closed>(axis, l.lo[i], hi[i]);
    a.number(name, ".within<owned>.enter", in_owned.enter);
    a.number(name, ".within<owned>.leave", in_owned.leave);
    a.number(name, ".within<closed>.enter", at[i].enter);
    a.number(name, ".within<closed>.leave", at[i].leave);
  }
  const auto both = [&](const char* name, const interval& p, const interval& q) {
    const interval c = bounds::common(p, q);
    a.number(name, ".enter", c.enter);
    a.number(name, ".leave", c.leave);
  };
  both("common(x,y)", at[0], at[1]);
  both("common(y,x)", at[1], at[0]);
  both("common(y,z)", at[1], at[2]);
  a.verdict("touches", bounds::touches_box(axes, l.lo, hi) ? "1" : "0");
  a.verdict("passes(x,y)", bounds::passes(at[0], at[1]) ? "1" : "0");

  // Between any planes: as sound<B, C> does between a cell's, which follows below.
  unsigned sides = 0, children[2] = {0, 0};
  std::array<std::array<interval, 2>, 3> half[2];
  for (std::size_t i = 0; i < 3; ++i) {
    sides |= (axes[i].origin >= mid[i] ? 1u : 0u) << i;
    const std::size_t entry = axes[i].direction == heading::backward ? 1 : 0;
    const double enter = bounds::enter_at(axes[i], mid[i]);
    half[0][i][entry] = {at[i].enter, bounds::template leave_at<closed>(axes[i], mid[i])};
    half[1][i][entry] = {at[i].enter, bounds::template leave_at<owned>(axes[i], mid[i])};
    half[0][i][1 - entry] = half[1][i][1 - entry] = {enter, at[i].leave};
  }
  for (unsigned c = 0; c < 2; ++c)
    for (unsigned i = 0; i < 8; ++i)
      children[c] |=
          (bounds::passes(half[c][0][i & 1], half[c][1][i >> 1 & 1], half[c][2][i >> 2]) ? 1u : 0u)
          << i;
  a.verdict("origin_side", std::to_string(sides));
  a.verdict("children<closed>", mask_text(children[0]));
  a.verdict("children<owned>", mask_text(children[1]));
  if (l.kind == 'b')
    return a;

  const auto ray = octree::ray::make(l.o, l.d);
  if (!ray) {
    a.verdict("ray", "refused");
    return a;
  }
  using in_closed = sound<B, closed>;
  using in_owned = sound<B, owned>;
  typename in_closed::state root{};
  a.verdict("entered", prepared<in_closed>(*ray).enter(cell, root) ? "1" : "0");
  a.verdict("split<closed>", order_of_split<in_closed>(*ray, cell));
  a.verdict("split<owned>", order_of_split<in_owned>(*ray, cell));
  if (l.kind == 't') {
    a.verdict("descent<closed>", order_of_visits<in_closed>(*ray, cell));
    a.verdict("descent<owned>", order_of_visits<in_owned>(*ray, cell));
  }
  return a;
}

} // namespace graze::tie
