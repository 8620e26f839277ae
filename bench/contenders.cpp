#include "measure.hpp"

namespace graze::bench {

std::string measure_all() {
  measure_double();
  measure_graze();
  std::string missing = GRAZE_BENCH_MISSING + measure_batches();
  measure_boost();
#if defined(GRAZE_BENCH_CGAL)
  measure_cgal();
#endif
#if defined(GRAZE_BENCH_MPFI)
  measure_mpfi();
#endif
#if defined(GRAZE_BENCH_ARB)
  measure_arb();
#endif
  missing += measure_inari();
  return missing.starts_with("; ") ? missing.substr(2) : missing;
}

} // namespace graze::bench
