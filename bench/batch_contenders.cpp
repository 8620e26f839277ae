// Intervals in batches, on each path that the processor has, and plain double vectorised.
#include "aligned.hpp"
#include "measure.hpp"
#include <graze/batch.hpp>
#if defined(GRAZE_BENCH_VECTORISED)
#include "plain_vectorised.hpp"
#endif

namespace graze::bench {

namespace {
struct arrays {
  aligned_vector<double> lo, hi;
  explicit arrays(std::size_t n) : lo(n), hi(n) {}
  explicit arrays(const std::vector<ends>& from) : arrays(from.size()) {
    for (std::size_t i = 0; i < from.size(); ++i)
      lo[i] = from[i].lower, hi[i] = from[i].upper;
  }
  operator batch::const_intervals() const { return {lo, hi}; }
  operator batch::intervals() { return {lo, hi}; }
  [[nodiscard]] std::vector<enclosure> enclosures() const {
    std::vector<enclosure> all;
    for (std::size_t i = 0; i < lo.size(); ++i)
      all.push_back({lo[i], hi[i]});
    return all;
  }
};

/// operation(x, y, r) on arrays.
template <class Operation>
void measure_path(batch::path path, const char* name, operands kind, Operation operation) {
  const auto time = [=](benchmark::State& state) {
    const arrays x(make(kind, 1)), y(make(kind, 2));
    arrays r(size);
    batch::force_path(path);
    for ([[maybe_unused]] auto pass : state) {
      operation(x, y, r);
      benchmark::ClobberMemory();
    }
    batch::unforce_path();
  };
  const auto answers = [=](const std::vector<ends>& a, const std::vector<ends>& b,
                           const std::vector<ends>&) {
    const arrays x(a), y(b);
    arrays r(a.size());
    batch::force_path(path);
    operation(x, y, r);
    batch::unforce_path();
    return r.enclosures();
  };
  enlist(name, kind, std::string("batch ") + batch::name(path), false, time, answers);
}

/// Returns which paths cannot run here, and why.
std::string measure_paths() {
  std::string missing;
  using in = batch::const_intervals;
  using out = batch::intervals;
  for (const batch::path p : batch::paths) {
    if (const auto reason = batch::refusal(p)) {
      missing += std::string("; batch ") + batch::name(p) + " (" + *reason + ")";
      continue;
    }
    const auto mixed = operands::mixed;
    measure_path(p, "add/mixed", mixed, [](in x, in y, out r) { batch::add(x, y, r); });
    measure_path(p, "sub/mixed", mixed, [](in x, in y, out r) { batch::sub(x, y, r); });
    measure_path(p, "mul/mixed", mixed, [](in x, in y, out r) { batch::mul(x, y, r); });
    measure_path(p, "div/mixed", mixed, [](in x, in y, out r) { batch::div(x, y, r); });
    measure_path(p, "sqr/mixed", mixed, [](in x, in, out r) { batch::sqr(x, r); });
    measure_path(p, "sqrt/positive", operands::positive,
                 [](in x, in, out r) { batch::sqrt(x, r); });
  }
  return missing;
}

#if defined(GRAZE_BENCH_VECTORISED)
/// operation(n, x, y, r) on points.
template <class Operation>
void measure_vectorised(const char* name, operands kind, Operation operation) {
  const auto points = [](const std::vector<ends>& from) {
    aligned_vector<double> to;
    for (const ends& e : from)
      to.push_back(e.point);
    return to;
  };
  const auto time = [=](benchmark::State& state) {
    const aligned_vector<double> x = points(make(kind, 1)), y = points(make(kind, 2));
    aligned_vector<double> r(size);
    for ([[maybe_unused]] auto pass : state) {
      operation(size, x.data(), y.data(), r.data());
      benchmark::ClobberMemory();
    }
  };
  const auto answers = [=](const std::vector<ends>& a, const std::vector<ends>& b,
                           const std::vector<ends>&) {
    const aligned_vector<double> x = points(a), y = points(b);
    aligned_vector<double> r(a.size());
    operation(a.size(), x.data(), y.data(), r.data());
    std::vector<enclosure> all;
    for (const double v : r)
      all.push_back({v, v});
    return all;
  };
  enlist(name, kind, "double vectorised", true, time, answers);
}

void measure_all_vectorised() {
  if (batch::refusal(batch::path::avx512)) // what it is compiled for
    return;
  const auto unary = [](auto f) {
    return [f](std::size_t n, const double* x, const double*, double* r) { f(n, x, r); };
  };
  measure_vectorised("add/mixed", operands::mixed, plain::add);
  measure_vectorised("sub/mixed", operands::mixed, plain::sub);
  measure_vectorised("mul/mixed", operands::mixed, plain::mul);
  measure_vectorised("div/mixed", operands::mixed, plain::div);
  measure_vectorised("sqr/mixed", operands::mixed, unary(plain::sqr));
  measure_vectorised("sqrt/positive", operands::positive, unary(plain::sqrt));
}
#endif
} // namespace

std::string measure_batches() {
#if defined(GRAZE_BENCH_VECTORISED)
  measure_all_vectorised();
#endif
  return measure_paths();
}

} // namespace graze::bench
