#include "operation.hpp"
#include <graze/functions/reverse.hpp>

namespace graze::itf1788 {

namespace {

std::vector<result> mul_rev_to_pair(std::span<const value> operands) {
  using F = functions::mul_rev_to_pair;
  if (const auto bare = operands_of<bounds, 2>(operands)) {
    const auto [first, second] = F::value((*bare)[0], (*bare)[1]);
    return {result{{first, second}}};
  }
  if (const auto decorated = operands_of<decorated_bounds, 2>(operands)) {
    const auto& [b, c] = *decorated;
    if (b.is_nai() || c.is_nai())
      return {result{{decorated_bounds::nai(), decorated_bounds::nai()}}};
    const auto [first, second] = F::value(b.part, c.part);
    const decoration d = std::min({b.label, c.label, local_decoration<F>(first, b.part, c.part)});
    return {result{{decorated_bounds{first, d}, decorated_bounds{second, decoration::trv}}}};
  }
  return {};
}

} // namespace

std::span<const operation> reverse_operations() {
  static constexpr std::array table{
      operation{"sqrRev", function<functions::sqr_rev, 1>},
      operation{"sqrRevBin", function<functions::sqr_rev, 2>},
      operation{"absRev", function<functions::abs_rev, 1>},
      operation{"absRevBin", function<functions::abs_rev, 2>},
      operation{"pownRev", function_with_integer<functions::pown_rev, 1>},
      operation{"pownRevBin", function_with_integer<functions::pown_rev, 2>},
      operation{"sinRev", function<functions::sin_rev, 1>},
      operation{"sinRevBin", function<functions::sin_rev, 2>},
      operation{"cosRev", function<functions::cos_rev, 1>},
      operation{"cosRevBin", function<functions::cos_rev, 2>},
      operation{"tanRev", function<functions::tan_rev, 1>},
      operation{"tanRevBin", function<functions::tan_rev, 2>},
      operation{"coshRev", function<functions::cosh_rev, 1>},
      operation{"coshRevBin", function<functions::cosh_rev, 2>},
      operation{"mulRev", function<functions::mul_rev, 2>},
      operation{"mulRevTen", function<functions::mul_rev, 3>},
      operation{"mulRevToPair", mul_rev_to_pair},
      operation{"powRev1", function<functions::pow_rev1, 3>},
      operation{"powRev2", function<functions::pow_rev2, 3>},
  };
  return table;
}

} // namespace graze::itf1788
