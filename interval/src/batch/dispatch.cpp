// Which path runs, and the span functions: they check sizes and call the path's kernels.
#include "table.hpp"
#include <atomic>
#include <cassert>
#include <cstdlib>
#include <graze/batch.hpp>
#include <string_view>

namespace graze::batch {

namespace {

using detail::source;
using detail::table;
using detail::target;

const table* table_of(path p) {
  using namespace detail;
  return &GRAZE_ALL_PATHS(table, kernels).on(p);
}

struct choice {
  path chosen = path::baseline;
  std::optional<std::string> refused;
};

/// By the environment variable, or the widest.
choice choose() {
  choice c;
  for (const path p : paths)
    if (!refusal(p))
      c.chosen = p;
  const char* requested = std::getenv("GRAZE_BATCH_PATH");
  if (requested == nullptr || *requested == '\0')
    return c;
  for (const path p : paths)
    if (std::string_view(requested) == name(p)) {
      c.refused = refusal(p);
      if (!c.refused)
        c.chosen = p;
      return c;
    }
  c.refused = "GRAZE_BATCH_PATH names no path: " + std::string(requested) +
              " (baseline, avx2 or avx512 are known)";
  return c;
}

/// Null until the first use. All that is written are addresses of constants, and threads that find
/// out at the same time find out the same.
constinit std::atomic<const table*> in_use{nullptr};

const table& kernels() {
  const table* t = in_use.load(std::memory_order_relaxed);
  if (t == nullptr) [[unlikely]] {
    const table* const found = table_of(choose().chosen);
    // a path forced in the meantime stays
    if (in_use.compare_exchange_strong(t, found, std::memory_order_relaxed))
      t = found;
  }
  return *t;
}

source from(const_intervals x, [[maybe_unused]] std::size_t n) {
  assert(x.lo.size() == n && x.hi.size() == n);
  return {x.lo.data(), x.hi.data()};
}
target to(intervals r) {
  assert(r.lo.size() == r.hi.size());
  return {r.lo.data(), r.hi.data()};
}

static_assert(sizeof(bounds) == 2 * sizeof(double) && offsetof(bounds, hi) == sizeof(double));
source from(std::span<const bounds> x, [[maybe_unused]] std::size_t n) {
  assert(x.size() == n);
  return {reinterpret_cast<const double*>(x.data()), nullptr};
}
target to(std::span<bounds> r) { return {reinterpret_cast<double*>(r.data()), nullptr}; }

} // namespace

const char* name(path p) {
  switch (p) {
  case path::avx512:
    return "avx512";
  case path::avx2:
    return "avx2";
  default:
    return "baseline";
  }
}

std::optional<std::string> refusal(path p) {
#if defined(__x86_64__)
  if (p == path::avx2 && !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                           __builtin_cpu_supports("popcnt")))
    return "the processor or the system has no AVX2, FMA and POPCNT";
  if (p == path::avx512 && !(__builtin_cpu_supports("avx512f") &&
                             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("bmi") &&
                             __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt")))
    return "the processor or the system has no AVX-512 F and DQ, BMI2 and POPCNT";
#else
  if (p != path::baseline)
    return "not an x86-64 processor";
#endif
  return std::nullopt;
}

path path_in_use() {
  const table* const t = &kernels();
  for (const path p : paths)
    if (t == table_of(p))
      return p;
  return path::baseline;
}

std::optional<std::string> force_path(path p) {
  if (auto reason = refusal(p))
    return reason;
  in_use.store(table_of(p), std::memory_order_relaxed);
  return std::nullopt;
}

void unforce_path() { in_use.store(nullptr, std::memory_order_relaxed); }

std::optional<std::string> environment_refusal() { return choose().refused; }

#define GRAZE_BATCH_UNARY(operation)                                                               \
  void operation(const_intervals x, intervals r) {                                                 \
    kernels().arrays_unary[detail::op_##operation](r.size(), to(r), from(x, r.size()));            \
  }                                                                                                \
  void operation(std::span<const bounds> x, std::span<bounds> r) {                                 \
    kernels().pairs_unary[detail::op_##operation](r.size(), to(r), from(x, r.size()));             \
  }
GRAZE_BATCH_UNARY(neg)
GRAZE_BATCH_UNARY(sqr)
GRAZE_BATCH_UNARY(sqrt)
GRAZE_BATCH_UNARY(abs)
#undef GRAZE_BATCH_UNARY

#define GRAZE_BATCH_BINARY(operation)                                                              \
  void operation(const_intervals x, const_intervals y, intervals r) {                              \
    kernels().arrays_binary[detail::op_##operation](r.size(), to(r), from(x, r.size()),            \
                                                    from(y, r.size()));                            \
  }                                                                                                \
  void operation(std::span<const bounds> x, std::span<const bounds> y, std::span<bounds> r) {      \
    kernels().pairs_binary[detail::op_##operation](r.size(), to(r), from(x, r.size()),             \
                                                   from(y, r.size()));                             \
  }
GRAZE_BATCH_BINARY(add)
GRAZE_BATCH_BINARY(sub)
GRAZE_BATCH_BINARY(mul)
GRAZE_BATCH_BINARY(div)
GRAZE_BATCH_BINARY(min)
GRAZE_BATCH_BINARY(max)
GRAZE_BATCH_BINARY(intersection)
GRAZE_BATCH_BINARY(hull)
#undef GRAZE_BATCH_BINARY

void fma(const_intervals x, const_intervals y, const_intervals z, intervals r) {
  const std::size_t n = r.size();
  kernels().arrays_fma(n, to(r), from(x, n), from(y, n), from(z, n));
}
void fma(std::span<const bounds> x, std::span<const bounds> y, std::span<const bounds> z,
         std::span<bounds> r) {
  const std::size_t n = r.size();
  kernels().pairs_fma(n, to(r), from(x, n), from(y, n), from(z, n));
}

#define GRAZE_BATCH_TEST(predicate)                                                                \
  void predicate(const_intervals x, const_intervals y, std::span<std::uint8_t> result) {           \
    assert(result.size() == (x.size() + 7) / 8);                                                   \
    kernels().binary_predicates[detail::op_##predicate](x.size(), result.data(),                   \
                                                        from(x, x.size()), from(y, x.size()));     \
  }
GRAZE_BATCH_TEST(certainly_less)
GRAZE_BATCH_TEST(certainly_less_equal)
GRAZE_BATCH_TEST(equal)
GRAZE_BATCH_TEST(subset)
GRAZE_BATCH_TEST(overlaps)
#undef GRAZE_BATCH_TEST

#define GRAZE_BATCH_TEST(predicate)                                                                \
  void predicate(const_intervals x, std::span<std::uint8_t> result) {                              \
    assert(result.size() == (x.size() + 7) / 8);                                                   \
    kernels().unary_predicates[detail::op_##predicate](x.size(), result.data(),                    \
                                                       from(x, x.size()));                         \
  }
GRAZE_BATCH_TEST(contains_zero)
GRAZE_BATCH_TEST(is_empty)
#undef GRAZE_BATCH_TEST

void biquadratic(const_intervals x, const_intervals y, const_intervals z, bounds s, bounds c,
                 intervals r) {
  const std::size_t n = r.size();
  kernels().biquadratic(n, to(r), from(x, n), from(y, n), from(z, n), {s.lo, s.hi}, {c.lo, c.hi});
}

void horner(std::span<const bounds> coefficients, const_intervals x, intervals r) {
  static_assert(sizeof(bounds) == sizeof(detail::pair));
  kernels().horner(r.size(), to(r), from(x, r.size()),
                   reinterpret_cast<const detail::pair*>(coefficients.data()), coefficients.size());
}

} // namespace graze::batch
