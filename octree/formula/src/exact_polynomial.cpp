// Whether a tape is a polynomial, of which degree, and with which coefficients.
#include "exact_polynomial.hpp"

#include <algorithm>

namespace graze::octree::tape {
namespace {

/// Indices of the constants of an instruction.
std::pair<std::uint32_t, std::uint32_t> constants_of(const program& p, const instruction& i) {
  const auto n = static_cast<std::uint32_t>(i.n);
  switch (i.op) {
  case opcode::constant:
  case opcode::add_constant:
  case opcode::mul_constant:
    return {n, n + 1};
  case opcode::polynomial: {
    const polynomial& q = p.polynomials[n];
    return {q.first_coefficient, q.first_coefficient + q.degree + 1};
  }
  default:
    return {0, 0};
  }
}

split_rational split(const rational& x) {
  split_rational r{numerator_of(x), denominator_of(x), 0};
  if (r.n.is_zero())
    return r;
  const auto up = static_cast<unsigned>(lsb(r.n.sign() < 0 ? integer(-r.n) : r.n)),
             down = static_cast<unsigned>(lsb(r.d));
  r.n >>= up;
  r.d >>= down;
  r.exponent = static_cast<int>(up) - static_cast<int>(down);
  return r;
}

template <unsigned Bits> binary_number<fixed_integer<Bits>> binary(const split_rational& x) {
  constexpr int precision = precision_of<Bits>;
  const int shift =
      std::max(0, precision + static_cast<int>(bits_of(x.d)) - static_cast<int>(bits_of(x.n)));
  if (x.d == 1 && static_cast<int>(bits_of(x.n)) <= precision)
    return {fixed_integer<Bits>(x.n), x.exponent, true};
  integer n = (x.n << static_cast<unsigned>(shift)) / x.d;
  int exponent = x.exponent - shift;
  if (const int more = static_cast<int>(bits_of(n)) - precision; more > 0) {
    n >>= static_cast<unsigned>(more);
    exponent += more;
  }
  return {fixed_integer<Bits>(n), exponent, false};
}

} // namespace

std::shared_ptr<const exact_polynomial> exact_polynomial_of(const program& p,
                                                            const std::vector<number>& constants) {
  exact_polynomial r{p.code.size(), p.result, false, 0, 0, {}, {}, {}};
  // What does not move zeros is left out.
  for (; r.instructions > 0 && p.code[r.instructions - 1].target == r.result; --r.instructions) {
    const instruction& i = p.code[r.instructions - 1];
    const bool power = i.op == opcode::sqr || (i.op == opcode::pown && i.n > 1);
    const auto n = static_cast<std::size_t>(i.n);
    const bool scaled =
        i.op == opcode::mul_constant && (constants[n].lower() > 0 || constants[n].upper() < 0);
    if (!power && !scaled && i.op != opcode::neg && i.op != opcode::abs)
      break;
    r.is_power = r.is_power || power;
    r.result = i.a;
  }
  std::vector<std::uint64_t> degrees(program::most_registers, 1);
  r.constants.resize(constants.size());
  r.short_constants.resize(constants.size());
  r.long_constants.resize(constants.size());
  for (std::size_t k = 0; k < r.instructions; ++k) {
    const instruction& i = p.code[k];
    const std::uint64_t a = degrees[i.a], b = degrees[i.b];
    std::uint64_t degree = a;
    switch (i.op) {
    case opcode::constant:
      degree = 0;
      break;
    case opcode::add_constant:
    case opcode::neg:
      break;
    case opcode::mul_constant:
      r.work += a + 1;
      break;
    case opcode::add:
    case opcode::sub:
      degree = std::max(a, b);
      break;
    case opcode::mul:
      degree = a + b;
      r.work += (a + 1) * (b + 1);
      break;
    case opcode::sqr:
      degree = 2 * a;
      r.work += (a + 1) * (a + 1);
      break;
    case opcode::pown:
      if (i.n < 0)
        return nullptr;
      degree = a * static_cast<std::uint64_t>(i.n);
      r.work += 2 * (degree + 1) * (degree + 1);
      break;
    case opcode::polynomial: {
      const std::uint64_t n = p.polynomials[static_cast<std::size_t>(i.n)].degree;
      degree = a * n;
      r.work += n * (degree + 1) * (a + 1) / 2;
      break;
    }
    default:
      return nullptr;
    }
    if (degree > exact_polynomial::most_degree || r.work > exact_polynomial::most_work)
      return nullptr;
    degrees[i.target] = degree;
    const auto [first, last] = constants_of(p, i);
    for (std::uint32_t c = first; c < last; ++c) {
      if (r.constants[c].d.is_zero()) {
        const auto exact = constants[c].exact();
        if (!exact)
          return nullptr;
        r.constants[c] = split(*exact);
        r.short_constants[c] = binary<exact_polynomial::short_bits>(r.constants[c]);
        r.long_constants[c] = binary<exact_polynomial::long_bits>(r.constants[c]);
      }
    }
  }
  r.degree = static_cast<unsigned>(degrees[r.result]);
  return std::make_shared<const exact_polynomial>(std::move(r));
}

} // namespace graze::octree::tape
