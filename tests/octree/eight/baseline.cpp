#include "evaluate_by.hpp"

void graze::test::evaluate_baseline(const eight_boxes& x, eight_values& r) {
  evaluate_by<batch::baseline>(x, r);
}
