/// generate COUNT [SEED]: lines for the model and the code to answer. Three in four come from the
/// fuzzer's generators (rays through and beside the vertices, edges and faces of a cell), the rest
/// are made of special numbers, in which operands agree, or nearly, or lie as far apart as can be.
#include "line.hpp"
#include <cstdlib>
#include <generate/generators.hpp>
#include <limits>
#include <trial/number.hpp>

namespace {

using namespace graze;
using fuzz::random_stream;

/// A number at an edge of the format, or any; now and then one that is not finite, if asked for.
double special(random_stream& random, bool any) {
  using limits = std::numeric_limits<double>;
  const double s = random.sign();
  switch (random.below(any ? 14 : 12)) {
  case 0:
  case 1:
    return s * 0.0;
  case 2:
    return s * limits::denorm_min() * random.between(1, 3);
  case 3:
    return s * std::bit_cast<double>(random.bits(52));
  case 4:
    return s * fuzz::step_ulps(limits::min(), random.between(-2, 2));
  case 5:
    return s * fuzz::step_ulps(limits::max(), -random.between(0, 2));
  case 6:
    return s * std::ldexp(1.0, random.between(-1074, 1023));
  case 7:
    return s * fuzz::step_ulps(std::ldexp(1.0, random.between(-3, 3)), random.between(-2, 2));
  case 8: // products of two of these are at the edge of underflow or overflow
    return s * fuzz::step_ulps(std::ldexp(1.0, random.coin() ? random.between(-540, -530)
                                                             : random.between(508, 514)),
                               random.between(-3, 3));
  case 9:
    return s * std::bit_cast<double>(0x3fe0000000000000 + random.bits(53));
  case 10:
  case 11: { // any finite pattern
    const std::uint64_t bits = random.bits();
    return (bits >> 52 & 0x7ff) == 0x7ff ? s : std::bit_cast<double>(bits);
  }
  case 12:
    return s * limits::infinity();
  default:
    return limits::quiet_NaN();
  }
}

/// A number of its own, or near one that is there.
double related(random_stream& random, bool any, double other) {
  switch (random.below(6)) {
  case 0:
    return other;
  case 1:
    return -other;
  case 2:
    return other - other == 0 ? fuzz::step_ulps(other, random.between(-2, 2)) : other;
  default:
    return special(random, any);
  }
}

tie::line of_special_numbers(random_stream& random) {
  const bool any = random.one_in(16);
  tie::line l;
  const double first = special(random, any);
  const bool alike = random.one_in(4); // every component the same: ties of all bounds
  for (std::size_t i = 0; i < 3; ++i) {
    l.o[i] = alike && i > 0 ? l.o[0] : related(random, any, first);
    l.d[i] = alike && i > 0 ? l.d[0] : special(random, any);
    l.lo[i] = related(random, any, l.o[i]);
    l.hi[i] = related(random, any, random.coin() ? l.o[i] : l.lo[i]);
    l.mid[i] = related(random, any, l.o[i]);
    if (random.coin() && l.hi[i] < l.lo[i])
      std::swap(l.hi[i], l.lo[i]);
  }
  return l;
}

tie::line of_cell(random_stream& random, std::uint64_t seed, std::uint64_t index) {
  const auto& all = fuzz::generators();
  const auto& g = all[random.below(static_cast<unsigned>(all.size()))];
  const int level = random.between(4, octree::max_level);
  octree::cube root{{0, 0, 0}, 1};
  if (random.one_in(4)) // the symmetric root has one level less
    root = {{-1, -1, -1}, 2};
  else if (random.one_in(4))
    root.size = std::ldexp(1.0, random.between(-1, 40));
  const fuzz::trial t = fuzz::make_trial(g, seed, index, level, root);
  tie::line l;
  l.kind = random.one_in(8) ? 't' : 'c';
  // an ancestor of the trial's octant: mid-planes of one level below are exact, or of three
  const int least = l.kind == 't' ? 4 : 1;
  const int at = random.coin() ? random.between(0, level - least) : level - least;
  octree::cube cell = root;
  cell.size = std::ldexp(root.size, -at);
  for (std::size_t i = 0; i < 3; ++i)
    cell.lo[i] = root.lo[i] + static_cast<double>(t.base[i] >> (level - at)) * cell.size;
  l.o = t.origin, l.d = t.direction, l.lo = cell.lo, l.size = cell.size;
  if (!random.one_in(4))
    return l;
  l.kind = 'b'; // the same with planes that may be an ulp beside
  for (std::size_t i = 0; i < 3; ++i) {
    const auto moved = [&](double x) { return fuzz::step_ulps(x, random.between(-1, 1)); };
    l.hi[i] = moved(cell.hi(static_cast<int>(i)));
    l.mid[i] = random.one_in(4) ? l.o[i] : moved(cell.mid(static_cast<int>(i)));
    l.lo[i] = moved(l.lo[i]);
  }
  return l;
}

} // namespace

int main(int count, char** arguments) {
  char* end = nullptr;
  const long lines = count > 1 ? std::strtol(arguments[1], &end, 10) : 0;
  if (count > 3 || lines <= 0 || *end != '\0') {
    std::fprintf(stderr, "generate: usage: generate COUNT [SEED]\n");
    return 2;
  }
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  for (long k = 0; k < lines; ++k) {
    const auto index = static_cast<std::uint64_t>(k);
    random_stream random(seed, index);
    const tie::line l =
        random.one_in(4) ? of_special_numbers(random) : of_cell(random, seed, index);
    std::string text(1, l.kind);
    const auto add = [&](double x) { text += ' ' + tie::digits(tie::pattern(x), true); };
    for (const auto* three : {&l.o, &l.d, &l.lo})
      for (const double x : *three)
        add(x);
    if (l.kind == 'b')
      for (const auto* three : {&l.hi, &l.mid})
        for (const double x : *three)
          add(x);
    else
      add(l.size);
    std::puts(text.c_str());
  }
  return 0;
}
