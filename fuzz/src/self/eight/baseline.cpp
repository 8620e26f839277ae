#include "eight_by.hpp"
#include <graze/batch/portable.hpp>

void graze::fuzz::self::eight_by_baseline(const eight_operands& o, eight_results& r) {
  eight_by<batch::baseline>(o, r);
}
void graze::fuzz::self::eight_by_portable(const eight_operands& o, eight_results& r) {
  eight_by<batch::portable>(o, r);
}
