#pragma once
/// What a trial may be shrunk to next.
#include <bit>
#include <shrink/shrink.hpp>
#include <utility>
#include <vector>

namespace graze::fuzz {

/// Collects trials that are legal, and simpler than one.
class candidates {
public:
  explicit candidates(const trial& t) : now_(complexity_of(t)) {}
  void offer(const trial& t) {
    if (complexity_of(t) < now_ && judgeable(t))
      found_.push_back(t);
  }
  std::vector<trial> take() { return std::move(found_); }

private:
  complexity now_;
  std::vector<trial> found_;
};

/// One cell of the block alone, or the block without a layer.
inline void offer_smaller_block(const trial& t, candidates& out) {
  for (octant_set left = t.all(); left != 0 && std::popcount(t.all()) > 1; left &= left - 1) {
    const int v = std::countr_zero(left);
    trial n = t;
    for (unsigned a = 0; a < 3; ++a)
      n.base[a] += static_cast<unsigned>(v) >> (2 * a) & 3u;
    n.extent = {1, 1, 1};
    out.offer(n);
  }
  for (unsigned a = 0; a < 3; ++a) {
    if (t.extent[a] == 1)
      continue;
    trial n = t;
    --n.extent[a];
    out.offer(n);
    ++n.base[a];
    out.offer(n);
  }
}

} // namespace graze::fuzz
