#pragma once
/// Runs a tape over a number type: double, intervals, eight intervals (operations_eight.hpp), and
/// duals of these.
#include <graze/octree_formula/continuity.hpp>
#include <graze/octree_formula/derivatives.hpp>
#include <type_traits>

namespace graze::octree::tape {

namespace detail {
template <class N> struct value_type {
  using type = N;
  static constexpr bool is_dual = false;
  static const N& value(const N& x) { return x; }
};
template <class N, std::size_t P> struct value_type<dual<N, P>> {
  using type = N;
  static constexpr bool is_dual = true;
  static const N& value(const dual<N, P>& x) { return x.value; }
};
/// Written before it is read; not initialized, since few of many are used.
template <class N> union register_slot {
  N number;
  register_slot() {} // NOLINT(modernize-use-equals-default): a default one would be deleted
};
} // namespace detail

/// What a run knows beside the value.
template <class N> struct outcome {
  N value;
  /// continuity<...>'s bits: proven that f is defined everywhere on the box, and continuous there.
  unsigned continuous;
};

/// f(x, y, z). With `Track` the run looks where f is continuous; otherwise it says nowhere, unless
/// it is so everywhere.
template <bool Track, class N>
outcome<N> run(const program& p, const N& x, const N& y, const N& z) {
  static_assert(std::is_trivially_copyable_v<N>, "registers are not initialized");
  using part = detail::value_type<N>;
  using where = continuity<typename part::type>;
  using o = operations<N>;
  detail::register_slot<N> r[program::most_registers];
  r[0].number = x;
  r[1].number = y;
  r[2].number = z;
  // of each register, as outcome::continuous; without `Track` it is not looked at
  [[maybe_unused]] unsigned continuous[Track ? program::most_registers : 1];
  if constexpr (Track)
    continuous[0] = continuous[1] = continuous[2] = where::everywhere;
  const instruction* const end = p.code.data() + p.code.size();
  for (const instruction* i = p.code.data(); i != end; ++i) {
    const N& a = r[i->a].number;
    const N& b = r[i->b].number;
    N& to = r[i->target].number;
    if constexpr (Track) {
      if (i->op == opcode::select) {
        continuous[i->target] =
            continuous[i->a] & where::chosen(part::value(a), continuous[i->b], continuous[i->n]);
      } else {
        // of what has one operand or none, the others are register 0
        unsigned here = continuous[i->a] & continuous[i->b];
        if (!continuous_everywhere(i->op, i->n))
          here &= where::bits(i->op, part::value(a), part::value(b), i->n);
        continuous[i->target] = here;
      }
    }
    const auto number = [&] {
      return operations<typename part::type>::number(p.constants.data()[i->n]);
    };
    switch (i->op) {
    case opcode::variable:
      break;
    case opcode::constant:
      to = o::number(p.constants.data()[i->n]);
      break;
    case opcode::add_constant:
      to = a + number();
      break;
    case opcode::mul_constant:
      to = a * number();
      break;
    case opcode::add:
      to = a + b;
      break;
    case opcode::sub:
      to = a - b;
      break;
    case opcode::mul:
      to = a * b;
      break;
    case opcode::neg:
      to = -a;
      break;
    case opcode::sqr:
      to = sqr(a);
      break;
    case opcode::div:
      to = o::div(a, b);
      break;
    case opcode::recip:
      to = o::recip(a);
      break;
    case opcode::sqrt:
      to = o::sqrt(a);
      break;
    case opcode::abs:
      to = o::abs(a);
      break;
    case opcode::min:
      to = o::min(a, b);
      break;
    case opcode::max:
      to = o::max(a, b);
      break;
    case opcode::pown:
      to = o::pown(a, i->n);
      break;
    case opcode::rootn:
      to = o::rootn(a, i->n);
      break;
    case opcode::polynomial: {
      const auto index = static_cast<std::uint32_t>(i->n);
      if constexpr (part::is_dual)
        to = o::polynomial(view(p, index), view(p, p.polynomials.data()[index].derivative), a);
      else
        to = o::polynomial(view(p, index), a);
      break;
    }
    case opcode::pow:
      to = o::pow(a, b);
      break;
    case opcode::hypot:
      to = o::hypot(a, b);
      break;
    case opcode::atan2:
      to = o::atan2(a, b);
      break;
    case opcode::select:
      to = o::select(a, b, r[i->n].number);
      break;
#define GRAZE_TAPE_CASE(name)                                                                      \
  case opcode::name:                                                                               \
    to = o::name(a);                                                                               \
    break;
      GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_CASE)
#undef GRAZE_TAPE_CASE
    }
  }
  if constexpr (Track)
    return {r[p.result].number, continuous[p.result]};
  else
    return {r[p.result].number, p.continuous ? where::everywhere : 0};
}

/// f(x, y, z) as surfaces give it: see formula_surface.
template <class N> N evaluate(const program& p, const N& x, const N& y, const N& z) {
  using part = detail::value_type<N>;
  using where = continuity<typename part::type>;
  if constexpr (where::everywhere == 0) {
    return run<false>(p, x, y, z).value;
  } else if constexpr (!part::is_dual) {
    const N value = run<false>(p, x, y, z).value;
    return p.continuous ? value : where::defined(value);
  } else {
    if (p.continuous)
      return run<false>(p, x, y, z).value;
    outcome<N> r = run<true>(p, x, y, z);
    r.value.value = where::defined(r.value.value);
    for (auto& partial : r.value.partial)
      partial = where::where(r.continuous, partial);
    return r.value;
  }
}

} // namespace graze::octree::tape
