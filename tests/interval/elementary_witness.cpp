// CRlibm, written apart from CORE-MATH, as a witness: on hard arguments the two agree in both
// directions. What they do not agree on is listed here, with MPFR's verdict.
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <algorithm>
#include <graze/oracle/elementary.hpp>
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
using graze::bounds;

namespace {

struct crlibm {
  const char* name; ///< as in CORE-MATH
  double (*down)(double);
  double (*up)(double);
};
#define GRAZE_ROW(name) {#name, name##_rd, name##_ru},
const crlibm witnesses[] = {GRAZE_ROW(exp) GRAZE_ROW(expm1) GRAZE_ROW(log) GRAZE_ROW(log1p)
                                GRAZE_ROW(log2) GRAZE_ROW(log10) GRAZE_ROW(sin) GRAZE_ROW(cos)
                                    GRAZE_ROW(tan) GRAZE_ROW(asin) GRAZE_ROW(acos) GRAZE_ROW(atan)
                                        GRAZE_ROW(sinh) GRAZE_ROW(cosh)};
#undef GRAZE_ROW

const test::unary& graze_function(const std::string& core_math) {
  const auto all = test::unary_functions();
  return *std::find_if(all.begin(), all.end(),
                       [&](const test::unary& f) { return f.core_math == core_math; });
}

} // namespace

TEST_CASE("interval.witness: CORE-MATH and CRlibm agree, but where CRlibm is wrong",
          "[property][mpfr][hardcase]") {
  std::set<std::string> disagreements;
  for (const crlibm& witness : witnesses) {
    const test::unary& f = graze_function(witness.name);
    const auto compare = [&](double x) {
      const bounds ours{f.down(x), f.up(x)}, theirs{witness.down(x), witness.up(x)};
      if (test::same(ours, theirs))
        return;
      const bounds truth = oracle::enclosed(f.exact, x);
      const char* verdict = !test::same(ours, truth) ? ": Graze is wrong"
                            : truth.within(theirs)   ? ": CRlibm is loose"
                                                     : ": CRlibm is unsound";
      disagreements.insert(test::call(f.name, x) + verdict);
    };
    oracle::hard_arguments make(2003);
    const int inputs = test::inputs_per_operation();
    for (int i = 0; i < inputs; ++i)
      compare(make.point(f.active));
    for (int i = 0; i < inputs / 50; ++i)
      compare(test::nearly_a_double(f, make.uniform(f.active.lo, f.active.hi)));
    for (const double literal : test::literals_of(witness.name))
      for (const int beside : {-1, 0, 1})
        for (const double sign : {1.0, -1.0})
          compare(sign * oracle::hard_operands::step(literal, beside));
  }
  for (const std::string& line : disagreements)
    UNSCOPED_INFO(line);
  CHECK(disagreements == std::set<std::string>{"acos(0x1.1a62633145c07p-54): CRlibm is loose",
                                               "asin(-0x1.e9950730c4696p-2): CRlibm is unsound",
                                               "sinh(-0x1.633ce8fb9f87ep+9): CRlibm is unsound",
                                               "sinh(0x1.633ce8fb9f87ep+9): CRlibm is unsound"});
}
