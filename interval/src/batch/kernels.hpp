#pragma once
/// The loops over arrays, for the path of the including file. Included once a file; everything is
/// in an unnamed namespace, or always_inline, so that no function compiled for a path can be taken
/// by the linker for another.
#include "table.hpp"
#include <graze/batch/formulas.hpp>

namespace graze::batch::detail {
namespace {

/// How elements are read and written. A register's worth at a time, from element i on.
template <class P> struct arrays {
  static constexpr bool is_pairs = false;
  using group = part<P>;
  static GRAZE_BATCH_INLINE group load(source x, std::size_t i) {
    return {P::load(x.lo + i), P::load(x.hi + i)};
  }
  static GRAZE_BATCH_INLINE void store(target r, std::size_t i, const group& x) {
    P::store(r.lo + i, x.lo);
    P::store(r.hi + i, x.hi);
  }
};

/// One array of lo, hi, lo, hi ...
template <class P> struct pairs {
  static constexpr bool is_pairs = true;
  using group = part<P>;
  static GRAZE_BATCH_INLINE group load(source x, std::size_t i) {
    const auto p = P::load(x.lo + 2 * i), q = P::load(x.lo + 2 * i + P::width);
    return {P::firsts(p, q), P::seconds(p, q)};
  }
  static GRAZE_BATCH_INLINE void store(target r, std::size_t i, const group& x) {
    P::store(r.lo + 2 * i, P::firsts(x.lo, x.hi));
    P::store(r.lo + 2 * i + P::width, P::seconds(x.lo, x.hi));
  }
};

/// The elements from i on, fewer than a register holds, with zeros behind them.
template <class P, template <class> class Layout> struct rest {
  double lo[2 * P::width] = {}, hi[P::width] = {};
  GRAZE_BATCH_INLINE rest() {}
  GRAZE_BATCH_INLINE rest(source x, std::size_t i, std::size_t n) {
    if constexpr (is_pairs) {
      for (std::size_t k = 2 * i; k < 2 * n; ++k)
        lo[k - 2 * i] = x.lo[k];
    } else {
      for (std::size_t k = i; k < n; ++k)
        lo[k - i] = x.lo[k], hi[k - i] = x.hi[k];
    }
  }
  GRAZE_BATCH_INLINE void store(target r, std::size_t i, std::size_t n) const {
    if constexpr (is_pairs) {
      for (std::size_t k = 2 * i; k < 2 * n; ++k)
        r.lo[k] = lo[k - 2 * i];
    } else {
      for (std::size_t k = i; k < n; ++k)
        r.lo[k] = lo[k - i], r.hi[k] = hi[k - i];
    }
  }
  GRAZE_BATCH_INLINE part<P> group() const { return Layout<P>::load({lo, hi}, 0); }
  GRAZE_BATCH_INLINE void set(const part<P>& x) { Layout<P>::store({lo, hi}, 0, x); }

private:
  static constexpr bool is_pairs = Layout<P>::is_pairs;
};

/// r[i] = operation(x[i] ...), an operation on parts.
template <class P, template <class> class Layout, class Operation, class... Sources>
GRAZE_BATCH_INLINE void map(std::size_t n, target r, Operation operation, Sources... x) {
  const typename P::scope scope;
  std::size_t i = 0;
  for (; n - i >= P::width; i += P::width)
    Layout<P>::store(r, i, operation(Layout<P>::load(x, i)...));
  if (i == n)
    return;
  rest<P, Layout> result;
  result.set(operation(rest<P, Layout>(x, i, n).group()...));
  result.store(r, i, n);
}

/// A call of one of formulas<P>'s members, always inlined.
template <auto Operation> struct call {
  template <class... Parts> GRAZE_BATCH_INLINE auto operator()(const Parts&... x) const {
    return Operation(x...);
  }
};

template <class P, template <class> class Layout, auto Operation>
void unary_loop(std::size_t n, target r, source x) {
  map<P, Layout>(n, r, call<Operation>{}, x);
}
template <class P, template <class> class Layout, auto Operation>
void binary_loop(std::size_t n, target r, source x, source y) {
  map<P, Layout>(n, r, call<Operation>{}, x, y);
}
template <class P, template <class> class Layout, auto Operation>
void ternary_loop(std::size_t n, target r, source x, source y, source z) {
  map<P, Layout>(n, r, call<Operation>{}, x, y, z);
}

/// Bit i % 8 of r[i / 8] = predicate(x[i] ...).
template <class P, class Predicate, class... Sources>
GRAZE_BATCH_INLINE void test(std::size_t n, std::uint8_t* r, Predicate predicate, Sources... x) {
  const typename P::scope scope;
  for (std::size_t i = 0; i < n; i += 8) {
    unsigned bits = 0;
    for (std::size_t k = i; k < i + 8 && k < n; k += P::width) {
      if (n - k >= P::width)
        bits |= P::bits(predicate(arrays<P>::load(x, k)...)) << (k - i);
      else
        bits |= (P::bits(predicate(rest<P, arrays>(x, k, n).group()...)) & ((1u << (n - k)) - 1))
                << (k - i);
    }
    r[i / 8] = static_cast<std::uint8_t>(bits);
  }
}
template <class P, auto Predicate> void unary_test(std::size_t n, std::uint8_t* r, source x) {
  test<P>(n, r, call<Predicate>{}, x);
}
template <class P, auto Predicate>
void binary_test(std::size_t n, std::uint8_t* r, source x, source y) {
  test<P>(n, r, call<Predicate>{}, x, y);
}

template <class P> GRAZE_BATCH_INLINE part<P> broadcast(pair x) {
  return {P::broadcast(x.lo), P::broadcast(x.hi)};
}

template <class P> struct biquadratic_formula {
  part<P> s, c;
  GRAZE_BATCH_INLINE part<P> operator()(const part<P>& x, const part<P>& y,
                                        const part<P>& z) const {
    using f = formulas<P>;
    const auto term = [this](const part<P>& t)
                          __attribute__((always_inline)) { return f::sqr(f::sub(f::sqr(t), s)); };
    return f::sub(f::add(f::add(term(x), term(y)), term(z)), c);
  }
};
template <class P>
void biquadratic_loop(std::size_t n, target r, source x, source y, source z, pair s, pair c) {
  const biquadratic_formula<P> formula{broadcast<P>(s), broadcast<P>(c)};
  map<P, arrays>(n, r, formula, x, y, z);
}

template <class P> struct horner_formula {
  const pair* coefficients;
  std::size_t count;
  GRAZE_BATCH_INLINE part<P> operator()(const part<P>& x) const {
    using f = formulas<P>;
    part<P> value = f::mul(x, broadcast<P>({0, 0})); // empty where x is
    for (std::size_t k = count; k-- > 0;)
      value = f::fma(x, value, broadcast<P>(coefficients[k]));
    return value;
  }
};
template <class P>
void horner_loop(std::size_t n, target r, source x, const pair* coefficients, std::size_t count) {
  map<P, arrays>(n, r, horner_formula<P>{coefficients, count}, x);
}

/// All kernels of a path, in the order of the enumerations.
template <class P> consteval table make_table() {
  using f = formulas<P>;
  return {
      {unary_loop<P, arrays, &f::neg>, unary_loop<P, arrays, &f::sqr>,
       unary_loop<P, arrays, &f::sqrt>, unary_loop<P, arrays, &f::abs>},
      {unary_loop<P, pairs, &f::neg>, unary_loop<P, pairs, &f::sqr>, unary_loop<P, pairs, &f::sqrt>,
       unary_loop<P, pairs, &f::abs>},
      {binary_loop<P, arrays, &f::add>, binary_loop<P, arrays, &f::sub>,
       binary_loop<P, arrays, &f::mul>, binary_loop<P, arrays, &f::div>,
       binary_loop<P, arrays, &f::min>, binary_loop<P, arrays, &f::max>,
       binary_loop<P, arrays, &f::intersection>, binary_loop<P, arrays, &f::hull>},
      {binary_loop<P, pairs, &f::add>, binary_loop<P, pairs, &f::sub>,
       binary_loop<P, pairs, &f::mul>, binary_loop<P, pairs, &f::div>,
       binary_loop<P, pairs, &f::min>, binary_loop<P, pairs, &f::max>,
       binary_loop<P, pairs, &f::intersection>, binary_loop<P, pairs, &f::hull>},
      ternary_loop<P, arrays, &f::fma>,
      ternary_loop<P, pairs, &f::fma>,
      {unary_test<P, &f::contains_zero>, unary_test<P, &f::is_empty>},
      {binary_test<P, &f::certainly_less>, binary_test<P, &f::certainly_less_equal>,
       binary_test<P, &f::equal>, binary_test<P, &f::subset>, binary_test<P, &f::overlaps>},
      biquadratic_loop<P>,
      horner_loop<P>,
  };
}

} // namespace
} // namespace graze::batch::detail
