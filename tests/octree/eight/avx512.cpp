#include "evaluate_by.hpp"

void graze::test::evaluate_avx512(const eight_boxes& x, eight_values& r) {
  evaluate_by<batch::avx512>(x, r);
}
