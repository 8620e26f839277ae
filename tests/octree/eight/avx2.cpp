#include "evaluate_by.hpp"

void graze::test::evaluate_avx2(const eight_boxes& x, eight_values& r) {
  evaluate_by<batch::avx2>(x, r);
}
