#pragma once
/// The functions of graze::functions on the operands of a campaign.
#include <self/interval_operations.hpp>

namespace graze::fuzz::self {

/// F::value or F::local, whichever `call` names, with as many operands as it takes.
template <class Call> auto on_operands(Call call, const interval_operands& o) {
  const auto& [x, y, z] = o.boxes;
  if constexpr (requires { call(x, y, z); })
    return call(x, y, z);
  else if constexpr (requires { call(x, y, o.n); })
    return call(x, y, o.n);
  else if constexpr (requires { call(x, y); })
    return call(x, y);
  else if constexpr (requires { call(x, o.n); })
    return call(x, o.n);
  else
    return call(x);
}

template <class F> bounds value_of(const interval_operands& o) {
  return on_operands([](const auto&... x) -> bounds
                       requires requires { F::value(x...); }
                     { return F::value(x...); },
                     o);
}
template <class F> decoration local_of(const interval_operands& o) {
  return on_operands([](const auto&... x) -> decoration
                       requires requires { F::local(x...); }
                     { return F::local(x...); },
                     o);
}

} // namespace graze::fuzz::self
