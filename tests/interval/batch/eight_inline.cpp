// interval8 used inline, by the baseline and by the portable path: the bits of the span functions.
#include "batch_inputs.hpp"
#include <graze/batch/portable.hpp>
#include <graze/interval8.hpp>

namespace batch = graze::batch;
using graze::bounds;
using graze::interval8;
using graze::mask8;
using namespace graze::test;

namespace {

constexpr std::size_t n = 8;

/// Every operation in the path's scope; comparisons after it.
template <class Path> struct results {
  std::vector<arrays> values = std::vector<arrays>(13, arrays(n));
  std::vector<mask8> masks;

  results(const arrays& a, const arrays& b, const arrays& c) {
    using I = interval8<Path>;
    const typename Path::scope scope;
    const I x = I::load(a.lo.data(), a.hi.data()), y = I::load(b.lo.data(), b.hi.data()),
            z = I::load(c.lo.data(), c.hi.data());
    std::size_t k = 0;
    for (const I& r : {-x, sqr(x), sqrt(x), abs(x), x + y, x - y, x * y, x / y, min(x, y),
                       max(x, y), intersect(x, y), hull(x, y), fma(x, y, z)}) {
      r.store(values[k].lo.data(), values[k].hi.data());
      ++k;
    }
    masks = {x < y, x <= y, x == y, subset(x, y), overlaps(x, y), contains_zero(x), empty(x)};
  }
};

template <class Path> void same_as_spans() {
  hard_intervals make(13);
  arrays x(n), y(n), z(n);
  long wrong = 0;
  for (std::size_t done = 0; done < input_count(); done += n) {
    for (std::size_t i = 0; i < n; ++i) {
      bounds a, b, c;
      make.next(a, b, c);
      x.set(i, a), y.set(i, done % 3 == 0 ? a : b), z.set(i, c);
    }
    std::vector<arrays> expected(13, arrays(n));
    batch::neg(x, expected[0]);
    batch::sqr(x, expected[1]);
    batch::sqrt(x, expected[2]);
    batch::abs(x, expected[3]);
    batch::add(x, y, expected[4]);
    batch::sub(x, y, expected[5]);
    batch::mul(x, y, expected[6]);
    batch::div(x, y, expected[7]);
    batch::min(x, y, expected[8]);
    batch::max(x, y, expected[9]);
    batch::intersection(x, y, expected[10]);
    batch::hull(x, y, expected[11]);
    batch::fma(x, y, z, expected[12]);
    std::uint8_t bits[7];
    batch::certainly_less(x, y, {bits, 1});
    batch::certainly_less_equal(x, y, {bits + 1, 1});
    batch::equal(x, y, {bits + 2, 1});
    batch::subset(x, y, {bits + 3, 1});
    batch::overlaps(x, y, {bits + 4, 1});
    batch::contains_zero(x, {bits + 5, 1});
    batch::is_empty(x, {bits + 6, 1});
    const results<Path> r(x, y, z);
    for (std::size_t k = 0; k < expected.size(); ++k)
      for (std::size_t i = 0; i < n; ++i)
        wrong += !same_bits(r.values[k][i], expected[k][i]);
    for (std::size_t k = 0; k < r.masks.size(); ++k)
      for (std::size_t i = 0; i < n; ++i)
        wrong += r.masks[k][i] != ((bits[k] >> i & 1) != 0);
  }
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("interval.interval8: baseline, inline operations have the spans' bits", "[property]") {
  same_as_spans<batch::baseline>();
}
TEST_CASE("interval.interval8: portable, inline operations have the spans' bits", "[property]") {
  same_as_spans<batch::portable>();
}

TEST_CASE("interval.interval8: constructors and masks", "[unit]") {
  using I = interval8<batch::baseline>;
  const batch::baseline::scope scope;
  CHECK((I() == I(0.0)).all());
  CHECK((I(1, 2) < I(3.0)).all());
  CHECK((I(1, 2) < I(2.0)).none());
  const double lo[8] = {-1, 0, 1, -2, -0.0, 3, 4, -5}, hi[8] = {1, 0, 2, -1, 7, 3, 4, 5};
  const mask8 zero = contains_zero(I::load(lo, hi));
  CHECK(zero.bits == 0b10010011);
  CHECK((zero[0] && !zero[2] && zero.any() && !zero.all()));
}
