// interval8's operations, compiled for each path.
#include <graze/interval8.hpp>
#include <self/eight.hpp>

namespace graze::fuzz::self {
namespace {

template <class Path> void evaluate(const eight_operands& o, eight_results& r) {
  using I = interval8<Path>;
  const typename Path::scope scope;
  const I x = I::load(o.lo[0], o.hi[0]), y = I::load(o.lo[1], o.hi[1]),
          z = I::load(o.lo[2], o.hi[2]);
  int k = 0;
  const auto keep = [&r, &k](const I& value) {
    value.store(r.lo[k], r.hi[k]);
    ++k;
  };
  // in the order of batch_operations()
  keep(-x), keep(sqr(x)), keep(sqrt(x)), keep(abs(x));
  keep(x + y), keep(x - y), keep(x * y), keep(x / y);
  keep(min(x, y)), keep(max(x, y)), keep(intersect(x, y)), keep(hull(x, y));
  keep(fma(x, y, z));
  r.masks[0] = (x < y).bits;
  r.masks[1] = (x <= y).bits;
  r.masks[2] = (x == y).bits;
  r.masks[3] = subset(x, y).bits;
  r.masks[4] = overlaps(x, y).bits;
  r.masks[5] = contains_zero(x).bits;
  r.masks[6] = empty(x).bits;
}

} // namespace

constinit const eight_kernel GRAZE_ON_PATH(evaluate_eight) = &evaluate<batch::this_path>;

} // namespace graze::fuzz::self
