#include "eight_by.hpp"

void graze::fuzz::self::eight_by_avx2(const eight_operands& o, eight_results& r) {
  eight_by<batch::avx2>(o, r);
}
