// CRlibm, written apart from CORE-MATH, as a witness: on hard arguments the two agree in both
// directions. What they do not agree on is listed here, with MPFR's verdict.
#include "elementary_arguments.hpp"
#include "verdict.hpp"
#include <algorithm>
#include <graze/oracle/elementary.hpp>
#include <graze/point.hpp>
#include <iostream>
#include <set>

extern "C" {
#define GRAZE_DECLARE(name) double name##_rd(double), name##_ru(double);
GRAZE_DECLARE(exp)
GRAZE_DECLARE(expm1)
GRAZE_DECLARE(log)
GRAZE_DECLARE(log1p)
GRAZE_DECLARE(log2)
GRAZE_DECLARE(log10)
GRAZE_DECLARE(sin)
GRAZE_DECLARE(cos)
GRAZE_DECLARE(tan)
GRAZE_DECLARE(asin)
GRAZE_DECLARE(acos)
GRAZE_DECLARE(atan)
GRAZE_DECLARE(sinh)
GRAZE_DECLARE(cosh)
#undef GRAZE_DECLARE
}

namespace test = graze::test;
namespace oracle = graze::oracle;
namespace point = graze::point;
using graze::bounds;

namespace {

struct pair_of_libraries {
  const char* name;
  double (*down)(double);
  double (*up)(double);
  double (*witness_down)(double);
  double (*witness_up)(double);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  test::active_range active;
};
#define GRAZE_PAIR(name, crlibm, lo, hi)                                                           \
  pair_of_libraries {                                                                              \
    #name, point::name##_down, point::name##_up, crlibm##_rd, crlibm##_ru, mpfr_##crlibm, {        \
      lo, hi                                                                                       \
    }                                                                                              \
  }
const pair_of_libraries pairs[] = {
    GRAZE_PAIR(exp, exp, -0x1.74910d52d3051p+9, 0x1.62e42fefa39efp+9),
    GRAZE_PAIR(expm1, expm1, -0x1.25e4f7b2737fap+5, 0x1.62e42fefa39efp+9),
    GRAZE_PAIR(log, log, 0, 10),
    GRAZE_PAIR(logp1, log1p, -1, 10),
    GRAZE_PAIR(log2, log2, 0, 10),
    GRAZE_PAIR(log10, log10, 0, 10),
    GRAZE_PAIR(sin, sin, -20, 20),
    GRAZE_PAIR(cos, cos, -20, 20),
    GRAZE_PAIR(tan, tan, -20, 20),
    GRAZE_PAIR(asin, asin, -1, 1),
    GRAZE_PAIR(acos, acos, -1, 1),
    GRAZE_PAIR(atan, atan, -20, 20),
    GRAZE_PAIR(sinh, sinh, -0x1.633ce8fb9f87dp+9, 0x1.633ce8fb9f87dp+9),
    GRAZE_PAIR(cosh, cosh, -0x1.633ce8fb9f87dp+9, 0x1.633ce8fb9f87dp+9),
};

} // namespace

TEST_CASE("interval.witness: CORE-MATH and CRlibm agree, but where CRlibm is wrong",
          "[property][mpfr][hardcase]") {
  std::set<std::string> disagreements;
  for (const pair_of_libraries& f : pairs) {
    test::elementary_arguments make(2003);
    for (int i = 0, n = test::inputs_per_operation(); i < n; ++i) {
      const double x = make.point(f.active);
      const bounds one{f.down(x), f.up(x)}, other{f.witness_down(x), f.witness_up(x)};
      if (test::same(one, other))
        continue;
      const bounds truth = oracle::enclosed(f.exact, x);
      const bool right = test::same(one, truth), wrong = !test::same(other, truth);
      disagreements.insert(test::call(f.name, std::fabs(x)) +
                           (right && wrong ? ": CRlibm is wrong" : ": Graze is wrong"));
    }
  }
  for (const std::string& line : disagreements)
    UNSCOPED_INFO(line);
  CHECK(disagreements == std::set<std::string>{"sinh(0x1.633ce8fb9f87ep+9): CRlibm is wrong"});
}
