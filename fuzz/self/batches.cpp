/// The subject `batches`.
#include <bit>
#include <fmt/format.h>
#include <graze/boolean.hpp>
#include <graze/decorated_functions.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <self/batches.hpp>
#include <self/interval_operations.hpp>

#include <self/eight.hpp>

namespace graze::fuzz::self {

namespace {

namespace f = functions;
using cb = const bounds&;
using ci = batch::const_intervals;
using sp = std::span<const bounds>;

bool same_bits(double x, double y) {
  return x != x ? y != y : std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}
bool same_bits(cb x, cb y) { return same_bits(x.lo, y.lo) && same_bits(x.hi, y.hi); }
/// Zeros of either sign are one.
bool same_set(cb x, cb y) {
  return x.is_empty() ? y.lo != y.lo && y.hi != y.hi : x.lo == y.lo && x.hi == y.hi;
}

constexpr std::size_t most = 40, guard = 4;
constexpr double untouched = 0x1.dead0beefp+100;

/// Arrays in memory that goes on before and after them.
struct arrays {
  std::array<double, most + 2 * guard> lo, hi;
  std::size_t size = 0;
  arrays() { lo.fill(untouched), hi.fill(untouched); }
  [[nodiscard]] ci in() const { return {{lo.data() + guard, size}, {hi.data() + guard, size}}; }
  batch::intervals out() { return {{lo.data() + guard, size}, {hi.data() + guard, size}}; }
  [[nodiscard]] bounds operator[](std::size_t i) const { return {lo[guard + i], hi[guard + i]}; }
  void set(std::size_t i, cb x) { lo[guard + i] = x.lo, hi[guard + i] = x.hi; }
  [[nodiscard]] bool beside_untouched() const {
    for (std::size_t i = 0; i < lo.size(); ++i)
      if ((i < guard || i >= guard + size) && (lo[i] != untouched || hi[i] != untouched))
        return false;
    return true;
  }
};

struct operands {
  arrays x, y, z;
  std::array<bounds, most> xs, ys, zs;
  std::size_t size;
  std::size_t invalid = most; ///< an element that is no interval; most: none

  operands(oracle::random_bits& random, std::size_t count) : size(count) {
    oracle::hard_intervals make(random());
    x.size = y.size = z.size = size;
    for (std::size_t i = 0; i < size; ++i) {
      make.next(xs[i], ys[i], zs[i]);
      if (random() % 8 == 0)
        ys[i] = xs[i];
    }
    if (random() % 8 == 0) {
      invalid = random() % size;
      xs[invalid] = random() % 2 == 0 ? bounds{2, 1} : bounds{1, bounds::empty().lo};
    }
    for (std::size_t i = 0; i < size; ++i)
      x.set(i, xs[i]), y.set(i, ys[i]), z.set(i, zs[i]);
  }
};

void differ(const std::string& way, const operands& o, std::size_t i, cb got, cb right,
            observations& out) {
  out.push_back(
      {flaw::difference,
       fmt::format("{} of {}, {}, {}, element {} of {}: {}, not {}", way, text_of(o.xs[i]),
                   text_of(o.ys[i]), text_of(o.zs[i]), i, o.size, text_of(got), text_of(right))});
}

using predicate = void (*)(ci x, ci y, std::span<std::uint8_t> r);
struct batch_predicate {
  const char* name;
  predicate spans;
  bool (*scalar)(cb x, cb y);
};
constexpr batch_predicate predicates[] = {
    {"certainly_less",
     [](ci x, ci y, std::span<std::uint8_t> r) { batch::certainly_less(x, y, r); },
     [](cb x, cb y) { return strict_precedes(x, y); }},
    {"certainly_less_equal",
     [](ci x, ci y, std::span<std::uint8_t> r) { batch::certainly_less_equal(x, y, r); },
     [](cb x, cb y) { return precedes(x, y); }},
    {"equal", [](ci x, ci y, std::span<std::uint8_t> r) { batch::equal(x, y, r); },
     [](cb x, cb y) { return equal(x, y); }},
    {"subset", [](ci x, ci y, std::span<std::uint8_t> r) { batch::subset(x, y, r); },
     [](cb x, cb y) { return subset(x, y); }},
    {"overlaps", [](ci x, ci y, std::span<std::uint8_t> r) { batch::overlaps(x, y, r); },
     [](cb x, cb y) { return !disjoint(x, y); }},
    {"contains_zero", [](ci x, ci, std::span<std::uint8_t> r) { batch::contains_zero(x, r); },
     [](cb x, cb) { return x.contains(0); }},
    {"is_empty", [](ci x, ci, std::span<std::uint8_t> r) { batch::is_empty(x, r); },
     [](cb x, cb) { return x.is_empty(); }},
};
static_assert(std::size(predicates) == eight_predicates);

part predicates_by(batch::path p) {
  return {fmt::format("predicates {}", batch::name(p)),
          [p](std::uint64_t seed, std::uint64_t index, observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            const operands o(random, 1 + random() % most);
            const batch_predicate& test = predicates[random() % std::size(predicates)];
            const std::size_t bytes = (o.size + 7) / 8;
            std::array<std::uint8_t, most / 8 + 2> r;
            r.fill(0xa5);
            batch::force_path(p);
            test.spans(o.x.in(), o.y.in(), {r.data(), bytes});
            batch::unforce_path();
            for (std::size_t i = 0; i < 8 * bytes; ++i) {
              const bool got = (r[i / 8] >> i % 8 & 1) != 0;
              if (i != o.invalid && got != (i < o.size && test.scalar(o.xs[i], o.ys[i])))
                out.push_back({flaw::difference,
                               fmt::format("{}, element {} of {}: {}", test.name, i, o.size, got)});
            }
            if (r[bytes] != 0xa5)
              out.push_back(
                  {flaw::difference, fmt::format("{} writes beside its result", test.name)});
          }};
}

/// interval8 inline has the spans' bits.
part eight_part(std::string name, eight_kernel evaluate) {
  return {std::move(name), [evaluate](std::uint64_t seed, std::uint64_t index, observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            operands o(random, 8);
            eight_operands e{};
            for (std::size_t i = 0; i < 8; ++i) {
              e.lo[0][i] = o.xs[i].lo, e.hi[0][i] = o.xs[i].hi;
              e.lo[1][i] = o.ys[i].lo, e.hi[1][i] = o.ys[i].hi;
              e.lo[2][i] = o.zs[i].lo, e.hi[2][i] = o.zs[i].hi;
            }
            eight_results r{};
            evaluate(e, r);
            arrays right;
            right.size = 8;
            batch::force_path(batch::path::baseline);
            for (int k = 0; k < eight_operations; ++k) {
              const auto at = static_cast<std::size_t>(k);
              batch_operations()[at].arrays(o.x.in(), o.y.in(), o.z.in(), right.out());
              for (std::size_t i = 0; i < 8; ++i)
                if (const bounds got{r.lo[k][i], r.hi[k][i]};
                    i != o.invalid && !same_bits(got, right[i]))
                  differ(batch_operations()[at].name, o, i, got, right[i], out);
            }
            for (int k = 0; k < eight_predicates; ++k) {
              std::uint8_t bits = 0;
              predicates[k].spans(o.x.in(), o.y.in(), {&bits, 1});
              const unsigned ignored = o.invalid < 8 ? 1u << o.invalid : 0;
              if (((r.masks[k] ^ bits) & ~ignored) != 0)
                out.push_back(
                    {flaw::difference, fmt::format("{}: mask {:#x}, not {:#x}", predicates[k].name,
                                                   r.masks[k], bits)});
            }
            batch::unforce_path();
          }};
}

} // namespace

const std::vector<batch_operation>& batch_operations() {
#define GRAZE_UNARY(name, function)                                                                \
  batch_operation {                                                                                \
    #name, [](ci x, ci, ci, batch::intervals r) { batch::name(x, r); },                            \
        [](sp x, sp, sp, std::span<bounds> r) { batch::name(x, r); },                              \
        [](cb x, cb, cb) { return f::function::value(x); }                                         \
  }
#define GRAZE_BINARY(name, function)                                                               \
  batch_operation {                                                                                \
    #name, [](ci x, ci y, ci, batch::intervals r) { batch::name(x, y, r); },                       \
        [](sp x, sp y, sp, std::span<bounds> r) { batch::name(x, y, r); },                         \
        [](cb x, cb y, cb) { return f::function::value(x, y); }                                    \
  }
  static const std::vector<batch_operation> all{
      GRAZE_UNARY(neg, neg),
      GRAZE_UNARY(sqr, sqr),
      GRAZE_UNARY(sqrt, sqrt),
      GRAZE_UNARY(abs, abs),
      GRAZE_BINARY(add, add),
      GRAZE_BINARY(sub, sub),
      GRAZE_BINARY(mul, mul),
      GRAZE_BINARY(div, div),
      GRAZE_BINARY(min, min),
      GRAZE_BINARY(max, max),
      GRAZE_BINARY(intersection, intersection),
      GRAZE_BINARY(hull, convex_hull),
      batch_operation{"fma", [](ci x, ci y, ci z, batch::intervals r) { batch::fma(x, y, z, r); },
                      [](sp x, sp y, sp z, std::span<bounds> r) { batch::fma(x, y, z, r); },
                      [](cb x, cb y, cb z) { return f::fma::value(x, y, z); }},
  };
#undef GRAZE_UNARY
#undef GRAZE_BINARY
  return all;
}

part spans_by(batch::path p, std::vector<batch_operation> operations) {
  return {fmt::format("spans {}", batch::name(p)),
          [p, list = std::move(operations)](std::uint64_t seed, std::uint64_t index,
                                            observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            operands o(random, 1 + random() % most);
            const std::size_t which = random() % list.size();
            const batch_operation& operation = list[which];
            arrays base, r;
            base.size = r.size = o.size;
            std::array<bounds, most> pairs;
            batch::force_path(batch::path::baseline);
            batch_operations()[which].arrays(o.x.in(), o.y.in(), o.z.in(), base.out());
            batch::force_path(p);
            const bool in_place = random() % 4 == 0;
            arrays& to = in_place ? o.x : r;
            operation.arrays(o.x.in(), o.y.in(), o.z.in(), to.out());
            const auto n = [&o](const std::array<bounds, most>& from) {
              return sp(from.data(), o.size);
            };
            operation.pairs(n(o.xs), n(o.ys), n(o.zs), {pairs.data(), o.size});
            batch::unforce_path();
            for (std::size_t i = 0; i < o.size; ++i) {
              if (i == o.invalid)
                continue;
              const bounds right = operation.scalar(o.xs[i], o.ys[i], o.zs[i]);
              if (!same_set(to[i], right))
                differ(operation.name, o, i, to[i], right, out);
              if (!same_bits(to[i], base[i]))
                differ(operation.name + " beside the baseline", o, i, to[i], base[i], out);
              if (!same_bits(pairs[i], to[i]))
                differ(operation.name + " of pairs beside arrays", o, i, pairs[i], to[i], out);
            }
            if (!to.beside_untouched())
              out.push_back({flaw::difference, operation.name + " writes beside its result"});
          }};
}

subject batches_subject() {
  subject s{"batches", "Spans and interval8 on every path, against scalar functions", {}};
  for (const batch::path p : batch::paths)
    if (!batch::refusal(p)) {
      s.parts.push_back(spans_by(p));
      s.parts.push_back(predicates_by(p));
    }
  for (const batch::path p : batch::paths)
    if (!batch::refusal(p))
      s.parts.push_back(eight_part(std::string("interval8 ") + batch::name(p),
                                   GRAZE_ALL_PATHS(eight_kernel, evaluate_eight).on(p)));
  s.parts.push_back(eight_part("interval8 portable", evaluate_eight_portable));
  return s;
}

} // namespace graze::fuzz::self
