/// The subject `control-words`: what runs in a rounding mode of its own restores the caller's, and
/// gives the same bits whatever the caller had set.
#include <cstring>
#include <fmt/format.h>
#include <graze/batch.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/point.hpp>
#include <graze/point_rare.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <self/control_words.hpp>
#include <self/interval_operations.hpp>

namespace graze::fuzz::self {

namespace {

namespace ranges = oracle::ranges;

constexpr unsigned rounding_bits = 0x6000, flags = 0x3f, all_masked = 0x1f80;

unsigned short any_x87(oracle::random_bits& random, bool masked) {
  static constexpr std::array<unsigned short, 3> precisions{0x0000, 0x0200, 0x0300};
  const std::uint64_t bits = random();
  const unsigned masks = masked ? 0x3f : static_cast<unsigned>(bits >> 32 & 0x3f);
  return static_cast<unsigned short>(0x40 | masks | precisions[bits % 3] | (bits >> 8 & 0x0c00));
}

control_words any_rounding(oracle::random_bits& random) {
  return control_words_rounding(static_cast<unsigned>(random()) & rounding_bits, random);
}

void say_from(const control_words& w, observations& out, std::size_t first) {
  for (std::size_t i = first; i < out.size(); ++i)
    out[i].what += ", from " + spelled(w);
}

bool same_bits(double x, double y) {
  return x != x ? y != y : std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

/// Operators of an interval type, which take a scope of B each, in any rounding mode.
template <class B> part operators_words() {
  return {fmt::format("interval<{}>", B::name),
          [](std::uint64_t seed, std::uint64_t index, observations& out) {
            using I = interval<B>;
            using P = typename I::traits_type;
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            const control_words w = any_rounding(random);
            bounds x, y, z;
            oracle::hard_intervals(random()).next(x, y, z);
            std::array<I, 5> r;
            control_words after{};
            {
              const I a = to_interval<P>(x), b = to_interval<P>(y);
              const control_words_scope set(w);
              r = {a + b, a - b, a * b, a / b, sqrt(a)};
              after = control_words_now();
            }
            const std::size_t first = out.size();
            compare_words(w, after, false, out);
            const std::string operands = text_of(x) + ", " + text_of(y);
            compare("+ of " + operands, ranges::add(x, y), to_bounds(r[0]), out);
            compare("- of " + operands, ranges::sub(x, y), to_bounds(r[1]), out);
            compare("* of " + operands, ranges::mul(x, y), to_bounds(r[2]), out);
            compare("/ of " + operands, ranges::div(x, y), to_bounds(r[3]), out);
            compare("sqrt of " + operands, ranges::sqrt(x), to_bounds(r[4]), out);
            say_from(w, out, first);
          }};
}

struct point_function {
  const char* name;
  double (*down)(double);
  double (*up)(double);
  bool restores_flags;
};
#define GRAZE_POINT(name) {#name, point::name##_down, point::name##_up, true}
#define GRAZE_RARE(name) {#name, point::name##_down, point::name##_up, false}
constexpr point_function point_functions[] = {
    GRAZE_POINT(exp),  GRAZE_POINT(exp2),  GRAZE_POINT(exp10), GRAZE_POINT(expm1),
    GRAZE_POINT(log),  GRAZE_POINT(log2),  GRAZE_POINT(log10), GRAZE_POINT(logp1),
    GRAZE_POINT(sin),  GRAZE_POINT(cos),   GRAZE_POINT(tan),   GRAZE_POINT(asin),
    GRAZE_POINT(acos), GRAZE_POINT(atan),  GRAZE_POINT(sinh),  GRAZE_POINT(cosh),
    GRAZE_POINT(tanh), GRAZE_POINT(asinh), GRAZE_POINT(acosh), GRAZE_POINT(atanh),
    GRAZE_POINT(cbrt), GRAZE_RARE(cot),    GRAZE_RARE(sec),    GRAZE_RARE(csc),
    GRAZE_RARE(acot),  GRAZE_RARE(coth),   GRAZE_RARE(sech),   GRAZE_RARE(csch),
    GRAZE_RARE(acoth),
};
#undef GRAZE_POINT
#undef GRAZE_RARE

/// The point functions, in any rounding mode. Those of graze/point.hpp restore the flags too.
void point_words(std::uint64_t seed, std::uint64_t index, observations& out) {
  oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
  const point_function& f = point_functions[random() % std::size(point_functions)];
  const double x = oracle::hard_arguments(random()).point({-20, 20});
  const double down = f.down(x), up = f.up(x);
  const control_words w = any_rounding(random);
  double down_there = 0, up_there = 0;
  control_words after{};
  {
    const control_words_scope set(w);
    down_there = f.down(x);
    up_there = f.up(x);
    after = control_words_now();
  }
  const std::size_t first = out.size();
  compare_words(w, after, f.restores_flags, out);
  if (!same_bits(down, down_there) || !same_bits(up, up_there))
    out.push_back(
        {flaw::difference,
         fmt::format("{}({}) = {}, not {} as at a program's start", f.name, text_of({x, x}),
                     text_of({down_there, up_there}), text_of({down, up}))});
  say_from(w, out, first);
}

struct span_operands {
  std::array<double, 24> lo, hi;
  std::size_t size;
  [[nodiscard]] batch::const_intervals in() const { return {{lo.data(), size}, {hi.data(), size}}; }
  batch::intervals out() { return {{lo.data(), size}, {hi.data(), size}}; }
};

void call_span(std::uint64_t n, const span_operands& x, const span_operands& y,
               const span_operands& z, span_operands& r) {
  switch (n) {
  case 0:
    return batch::add(x.in(), y.in(), r.out());
  case 1:
    return batch::sub(x.in(), y.in(), r.out());
  case 2:
    return batch::mul(x.in(), y.in(), r.out());
  case 3:
    return batch::div(x.in(), y.in(), r.out());
  case 4:
    return batch::sqr(x.in(), r.out());
  case 5:
    return batch::sqrt(x.in(), r.out());
  default:
    return batch::fma(x.in(), y.in(), z.in(), r.out());
  }
}

/// The span functions by a path, from any control words at all.
part batch_words(batch::path p) {
  return {fmt::format("batch {}", batch::name(p)),
          [p](std::uint64_t seed, std::uint64_t index, observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            oracle::hard_intervals make(random());
            span_operands x{}, y{}, z{}, r{}, expected{};
            x.size = y.size = z.size = r.size = expected.size = 1 + random() % x.lo.size();
            for (std::size_t i = 0; i < x.size; ++i) {
              bounds a, b, c;
              make.next(a, b, c);
              x.lo[i] = a.lo, x.hi[i] = a.hi;
              y.lo[i] = b.lo, y.hi[i] = b.hi;
              z.lo[i] = c.lo, z.hi[i] = c.hi;
            }
            const std::uint64_t n = random() % 7;
            batch::force_path(p);
            call_span(n, x, y, z, expected);
            const control_words w = any_control_words(random);
            control_words after{};
            {
              const control_words_scope set(w);
              call_span(n, x, y, z, r);
              after = control_words_now();
            }
            batch::unforce_path();
            const std::size_t first = out.size();
            compare_words(w, after, true, out);
            for (std::size_t i = 0; i < x.size; ++i)
              if (!same_bits(r.lo[i], expected.lo[i]) || !same_bits(r.hi[i], expected.hi[i]))
                out.push_back(
                    {flaw::difference,
                     fmt::format("operation {} of {}, {}, {} = {}, not {} as at a program's start",
                                 n, text_of({x.lo[i], x.hi[i]}), text_of({y.lo[i], y.hi[i]}),
                                 text_of({z.lo[i], z.hi[i]}), text_of({r.lo[i], r.hi[i]}),
                                 text_of({expected.lo[i], expected.hi[i]}))});
            say_from(w, out, first);
          }};
}

/// The voxelizer, which takes its scope itself.
void voxelizer_words(std::uint64_t seed, std::uint64_t index, observations& out) {
  using namespace octree;
  oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
  const quartdef f;
  const box domain{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}};
  const auto root = enclosing_root(domain, 2);
  static const auto expected_tree = voxelize(f, *root, domain);
  const bool lanes = random() % 2 == 0;
  const control_words w = any_rounding(random);
  std::optional<expected<sparse_octree>> tree;
  control_words after{};
  {
    const control_words_scope set(w);
    tree = lanes ? voxelize_in_lanes(f, *root, domain) : voxelize(f, *root, domain);
    after = control_words_now();
  }
  const std::size_t first = out.size();
  compare_words(w, after, false, out);
  if (!*tree || !(**tree == *expected_tree))
    out.push_back({flaw::difference, "another octree than at a program's start"});
  say_from(w, out, first);
}

} // namespace

control_words any_control_words(oracle::random_bits& random) {
  const std::uint64_t bits = random();
  unsigned mxcsr = static_cast<unsigned>(bits) & (rounding_bits | flags | 0x8040); // FTZ, DAZ
  mxcsr |= (bits >> 62) == 0 ? static_cast<unsigned>(bits >> 32) & all_masked : all_masked;
  // a flag that is raised while its exception is unmasked traps at no SSE instruction
  return {mxcsr, any_x87(random, (bits >> 60 & 3) != 0)};
}

control_words control_words_rounding(unsigned mode, oracle::random_bits& random) {
  return {all_masked | (mode & rounding_bits) | (static_cast<unsigned>(random()) & flags),
          any_x87(random, true)};
}

std::string spelled(const control_words& w) {
  return fmt::format("MXCSR {:#06x}, x87 {:#06x}", w.mxcsr, w.x87);
}

void compare_words(const control_words& before, const control_words& after, bool with_flags,
                   observations& out) {
  const unsigned ignored = with_flags ? 0 : flags;
  if ((before.mxcsr & ~ignored) != (after.mxcsr & ~ignored) || before.x87 != after.x87)
    out.push_back({flaw::control_word, spelled(after) + " is left"});
}

subject control_words_subject() {
  subject s{"control-words",
            "Backends, functions and batches from any MXCSR and x87 control word",
            {backend_words<rounding::switching>("switching", callers_words::any),
             backend_words<rounding::upward>("upward", callers_words::any),
             backend_words<rounding::split>("split", callers_words::any),
             backend_words<rounding::nearest>("nearest", callers_words::nearest),
             operators_words<rounding::switching>(), operators_words<rounding::upward>(),
             operators_words<rounding::split>(), part{"functions", point_words},
             part{"voxelizer", voxelizer_words}}};
  for (const batch::path p : batch::paths)
    if (!batch::refusal(p))
      s.parts.push_back(batch_words(p));
  return s;
}

} // namespace graze::fuzz::self
