#include "operation.hpp"

namespace graze::itf1788 {

namespace {

std::vector<result> mul_rev_to_pair(std::span<const value> operands) {
  if (const auto bare = operands_of<bounds, 2>(operands)) {
    const auto& [b, c] = *bare;
    using nearest = policies<rounding::nearest>;
    const auto [first, second] = functions::mul_rev_to_pair::value(b, c);
    const auto intervals = graze::mul_rev_to_pair(to_interval<nearest>(b), to_interval<nearest>(c));
    std::array<graze_interval, 2> pieces{};
    graze_mul_rev_to_pair(to_c(b), to_c(c), pieces.data());
    return {{{first, second}},
            {{to_value(intervals.first), to_value(intervals.second)}, "", "interval<>"},
            {{to_value(pieces[0]), to_value(pieces[1])}, "", "graze.h"}};
  }
  if (const auto marked = operands_of<decorated_bounds, 2>(operands)) {
    const auto [first, second] =
        graze::mul_rev_to_pair(decorated<>((*marked)[0]), decorated<>((*marked)[1]));
    return {{{to_value(first), to_value(second)}}};
  }
  return {};
}

} // namespace

std::span<const operation> reverse_operations() {
  static constexpr std::array table{
      GRAZE_OPERATION("sqrRev", sqr_rev, 1),
      GRAZE_OPERATION("sqrRevBin", sqr_rev, 2),
      GRAZE_OPERATION("absRev", abs_rev, 1),
      GRAZE_OPERATION("absRevBin", abs_rev, 2),
      GRAZE_OPERATION_WITH_INTEGER("pownRev", pown_rev, 1),
      GRAZE_OPERATION_WITH_INTEGER("pownRevBin", pown_rev, 2),
      GRAZE_OPERATION("sinRev", sin_rev, 1),
      GRAZE_OPERATION("sinRevBin", sin_rev, 2),
      GRAZE_OPERATION("cosRev", cos_rev, 1),
      GRAZE_OPERATION("cosRevBin", cos_rev, 2),
      GRAZE_OPERATION("tanRev", tan_rev, 1),
      GRAZE_OPERATION("tanRevBin", tan_rev, 2),
      GRAZE_OPERATION("coshRev", cosh_rev, 1),
      GRAZE_OPERATION("coshRevBin", cosh_rev, 2),
      GRAZE_OPERATION("mulRev", mul_rev, 2),
      GRAZE_OPERATION("mulRevTen", mul_rev, 3),
      operation{"mulRevToPair", mul_rev_to_pair},
      GRAZE_OPERATION("powRev1", pow_rev1, 3),
      GRAZE_OPERATION("powRev2", pow_rev2, 3),
  };
  return table;
}

} // namespace graze::itf1788
