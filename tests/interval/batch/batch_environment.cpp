// Whatever floating-point environment the caller has, results have the same bits and the
// environment is as before; which path runs can be forced, and a path that cannot run is refused.
#include "batch_inputs.hpp"
#include <graze/rounding/hardware.hpp>

namespace batch = graze::batch;
using graze::bounds;
using namespace graze::test;

#if defined(__x86_64__)
namespace {

namespace hardware = graze::rounding::hardware;

// default; flags raised; each rounding mode; FTZ; FTZ and DAZ, rounding down; all exceptions
// unmasked; unmasked with FTZ and DAZ, towards zero
constexpr unsigned environments[] = {0x1f80, 0x1fbf, 0x3f80, 0x5f80, 0x7f80,
                                     0x9f80, 0xbfc0, 0x0000, 0xe040};

void any_environment(batch::path p) {
  const forced path(p);
  if (!path.runs())
    return;
  constexpr std::size_t n = 1003;
  hard_intervals make(12);
  arrays x(n), y(n), z(n);
  for (std::size_t i = 0; i < n; ++i) {
    bounds a, b, c;
    make.next(a, b, c);
    x.set(i, a), y.set(i, b), z.set(i, c);
  }
  const bounds s{2.5, 2.5};
  const auto everything = [&] {
    std::vector<arrays> r(16, arrays(n));
    std::vector<std::vector<std::uint8_t>> m(7, std::vector<std::uint8_t>((n + 7) / 8));
    const unsigned own = hardware::mxcsr();
    std::vector<unsigned> seen;
    seen.reserve(32);
    const auto look = [&] { seen.push_back(hardware::mxcsr()); };
    batch::neg(x, r[0]), look();
    batch::sqr(x, r[1]), look();
    batch::sqrt(x, r[2]), look();
    batch::abs(x, r[3]), look();
    batch::add(x, y, r[4]), look();
    batch::sub(x, y, r[5]), look();
    batch::mul(x, y, r[6]), look();
    batch::div(x, y, r[7]), look();
    batch::min(x, y, r[8]), look();
    batch::max(x, y, r[9]), look();
    batch::intersection(x, y, r[10]), look();
    batch::hull(x, y, r[11]), look();
    batch::fma(x, y, z, r[12]), look();
    batch::biquadratic(x, y, z, s, s, r[13]), look();
    batch::horner({&s, 1}, x, r[14]), look();
    batch::certainly_less(x, y, m[0]), look();
    batch::certainly_less_equal(x, y, m[1]), look();
    batch::equal(x, y, m[2]), look();
    batch::subset(x, y, m[3]), look();
    batch::overlaps(x, y, m[4]), look();
    batch::contains_zero(x, m[5]), look();
    batch::is_empty(x, m[6]), look();
    const bool kept = std::all_of(seen.begin(), seen.end(), [own](unsigned u) { return u == own; });
    return std::tuple(r, m, kept);
  };
  const auto [expected, expected_masks, unused] = everything();
  for (const unsigned environment : environments) {
    const unsigned own = hardware::mxcsr();
    hardware::set_mxcsr(environment);
    const auto [results, masks, kept] = everything();
    hardware::set_mxcsr(own);
    CAPTURE(environment);
    CHECK(kept);
    CHECK(masks == expected_masks);
    long wrong = 0;
    for (std::size_t k = 0; k < results.size(); ++k)
      for (std::size_t i = 0; i < n; ++i)
        wrong += !same_bits(results[k][i], expected[k][i]);
    CHECK(wrong == 0);
  }
}

} // namespace

TEST_CASE("interval.batch: baseline, any caller's MXCSR, restored", "[unit]") {
  any_environment(batch::path::baseline);
}
TEST_CASE("interval.batch: avx2, any caller's MXCSR, restored", "[unit]") {
  any_environment(batch::path::avx2);
}
TEST_CASE("interval.batch: avx512, any caller's MXCSR, restored", "[unit]") {
  any_environment(batch::path::avx512);
}
#endif

TEST_CASE("interval.batch: a path is forced, or refused with a reason", "[unit]") {
  CHECK(!batch::refusal(batch::path::baseline));
  batch::path widest = batch::path::baseline;
  for (const batch::path p : batch::paths) {
    const batch::path before = batch::path_in_use();
    const auto refused = batch::force_path(p);
    CHECK(refused == batch::refusal(p));
    CHECK(batch::path_in_use() == (refused ? before : p));
    if (refused)
      CHECK_FALSE(refused->empty());
    else
      widest = p;
  }
  batch::unforce_path();
  if (std::getenv("GRAZE_BATCH_PATH") == nullptr) {
    CHECK(batch::path_in_use() == widest);
    CHECK(!batch::environment_refusal());
  }
}

TEST_CASE("interval.batch: the environment variable chooses the path", "[unit]") {
  const char* found = std::getenv("GRAZE_BATCH_PATH");
  const std::optional<std::string> before =
      found == nullptr ? std::nullopt : std::optional<std::string>(found);
  unsetenv("GRAZE_BATCH_PATH");
  batch::unforce_path();
  const batch::path widest = batch::path_in_use();
  for (const batch::path p : batch::paths) {
    setenv("GRAZE_BATCH_PATH", batch::name(p), 1);
    batch::unforce_path();
    CHECK(batch::environment_refusal() == batch::refusal(p));
    CHECK(batch::path_in_use() == (batch::refusal(p) ? widest : p));
  }
  setenv("GRAZE_BATCH_PATH", "mmx", 1);
  batch::unforce_path();
  CHECK(batch::environment_refusal());
  CHECK(batch::path_in_use() == widest);
  if (before)
    setenv("GRAZE_BATCH_PATH", before->c_str(), 1);
  else
    unsetenv("GRAZE_BATCH_PATH");
  batch::unforce_path();
}
