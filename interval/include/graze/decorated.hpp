#pragma once
/// graze::decorated<Backend>: an interval with its decoration, and every function of IEEE 1788.1 on
/// it. What a decoration promises is in graze/decoration.hpp.
#include <graze/needs_cxx20.hpp>

#include <concepts>
#include <graze/boolean.hpp>
#include <graze/construct.hpp>
#include <graze/decorated_functions.hpp>
#include <graze/numeric.hpp>
#include <type_traits>
#include <utility>

namespace graze {

/// An interval of type interval<B> and a decoration; NaI ("not an interval") is what a failed
/// construction gives, and all that is computed from it. Numeric and boolean functions take it as
/// the decorated_bounds that it is.
template <rounding::Backend B = rounding::nearest> class decorated : public decorated_bounds {
public:
  /// [0, 0], com: as Boost's intervals start.
  constexpr decorated() : decorated_bounds{{0, 0}, decoration::com} {}
  /// [x, x], com; NaI for a NaN or an infinity, which are no real numbers.
  decorated(double x) : decorated_bounds(nums_to_decorated(x, x).value) {}
  /// nums_to_decorated: NaI where the bounds are none.
  decorated(double lower, double upper) : decorated_bounds(nums_to_decorated(lower, upper).value) {}
  /// new_dec: the best decoration for the set.
  decorated(const interval<B>& x) : decorated_bounds(new_dec(to_bounds(x))) {}
  /// The same value for another backend, or the result of a function on bounds.
  constexpr decorated(const decorated_bounds& x) : decorated_bounds(x) {}

  static constexpr decorated nai() { return decorated_bounds::nai(); }

  /// The set alone; empty for NaI (graze::interval_part tells).
  [[nodiscard]] interval<B> interval_part() const { return to_interval<policies<B>>(part); }
  [[nodiscard]] constexpr decoration decoration_part() const { return label; }
};

namespace detail {
/// What may stand beside a decorated<B> as an operand: one, its interval, a number, or an integer
/// exponent, which stays an integer.
template <rounding::Backend B, class X> auto operand_of(const X& x) {
  if constexpr (std::integral<X>)
    return x;
  else
    return decorated<B>(x);
}
} // namespace detail

/// F on decorated intervals: tightest, with the local decoration joined to the operands'.
template <class F, rounding::Backend B, class... Operands>
decorated<B> apply(const decorated<B>& x, const Operands&... more) {
  return apply_decorated<F>(static_cast<const decorated_bounds&>(x),
                            detail::operand_of<B>(more)...);
}

// x + y and so on, where one may be a number or a bare interval.
#define GRAZE_DECORATED_OPERATOR(symbol, function)                                                 \
  template <rounding::Backend B>                                                                   \
  decorated<B> operator symbol(const decorated<B>& x, const decorated<B>& y) {                     \
    return apply<functions::function>(x, y);                                                       \
  }                                                                                                \
  template <rounding::Backend B>                                                                   \
  decorated<B> operator symbol(const decorated<B>& x,                                              \
                               const std::type_identity_t<decorated<B>>& y) {                      \
    return apply<functions::function>(x, y);                                                       \
  }                                                                                                \
  template <rounding::Backend B>                                                                   \
  decorated<B> operator symbol(const std::type_identity_t<decorated<B>>& x,                        \
                               const decorated<B>& y) {                                            \
    return apply<functions::function>(x, y);                                                       \
  }                                                                                                \
  template <rounding::Backend B>                                                                   \
  decorated<B>& operator symbol##=(decorated<B>& x, const std::type_identity_t<decorated<B>>& y) { \
    return x = apply<functions::function>(x, y);                                                   \
  }
GRAZE_DECORATED_OPERATOR(+, add)
GRAZE_DECORATED_OPERATOR(-, sub)
GRAZE_DECORATED_OPERATOR(*, mul)
GRAZE_DECORATED_OPERATOR(/, div)
#undef GRAZE_DECORATED_OPERATOR

template <rounding::Backend B> decorated<B> operator+(const decorated<B>& x) { return x; }
template <rounding::Backend B> decorated<B> operator-(const decorated<B>& x) {
  return apply<functions::neg>(x);
}

// name(x, ...) for each function of the list.
#define GRAZE_DECORATED_FUNCTION(name)                                                             \
  template <rounding::Backend B, class... More>                                                    \
    requires requires(bounds x, const More&... more) {                                             \
      functions::name::value(x, detail::as_bounds(detail::operand_of<B>(more))...);                \
    }                                                                                              \
  decorated<B> name(const decorated<B>& x, const More&... more) {                                  \
    return apply<functions::name>(x, more...);                                                     \
  }
GRAZE_FOR_EACH_FUNCTION(GRAZE_DECORATED_FUNCTION)
#undef GRAZE_DECORATED_FUNCTION

/// The two pieces; the second one, a part of the line beyond 0, is trv.
template <rounding::Backend B>
std::pair<decorated<B>, decorated<B>> mul_rev_to_pair(const decorated<B>& b,
                                                      const std::type_identity_t<decorated<B>>& c) {
  using F = functions::mul_rev_to_pair;
  if (b.is_nai() || c.is_nai())
    return {decorated<B>::nai(), decorated<B>::nai()};
  const auto [first, second] = F::value(b.part, c.part);
  const decoration label = std::min({b.label, c.label, local_decoration<F>(first, b.part, c.part)});
  return {decorated_bounds{first, label}, decorated_bounds{second, decoration::trv}};
}

} // namespace graze
