#pragma once
#include "walk.hpp"
#include <graze/octree/sound_eight.hpp>

namespace graze::test {

/// With any Method; its scope is taken here.
template <octree::Method M> trail walk(const octree::ray& r, const way& w) {
  [[maybe_unused]] const typename M::scope scope;
  trail t;
  const M method(r);
  typename M::state at{};
  t.entered = method.enter(w.root, at);
  if (!t.entered)
    return t;
  octree::cube cell = w.root;
  bool astray = false;
  std::uint64_t choices = w.choices;
  for (int level = 0; level < w.level; ++level) {
    octree::branches<typename M::state> out;
    method.split(cell, at, out);
    std::uint32_t seen = out.size() << 24;
    for (unsigned i = 0; i < out.size(); ++i)
      seen |= out[i].index << 3 * i;
    t.children[static_cast<std::size_t>(t.steps++)] = seen;
    if (out.size() == 0)
      return t;
    const int shift = w.level - level - 1;
    const auto towards =
        static_cast<unsigned>((w.target[0] >> shift & 1) | (w.target[1] >> shift & 1) << 1 |
                              (w.target[2] >> shift & 1) << 2);
    unsigned next = out.size();
    for (unsigned i = 0; !astray && i < out.size(); ++i)
      if (out[i].index == towards)
        next = i;
    if (next == out.size()) {
      astray = true;
      next = static_cast<unsigned>(choices % out.size());
      choices = choices >> 3 | choices << 61;
    }
    at = out[next].state;
    cell = cell.child(out[next].index);
  }
  return t;
}

template <class Path> consteval path_under_test walks_by() {
  return {&walk<octree::sound_eight<Path, octree::convention::closed>>,
          &walk<octree::sound_eight<Path, octree::convention::owned>>};
}

} // namespace graze::test
