// Not to be included by itself: the part of boost_functions.hpp that is written for bounds of the
// type GRAZE_BOUND, included for each.
#define GRAZE_UNARY(name)                                                                          \
  template <class P> rounded_interval<GRAZE_BOUND, P> name(const interval<GRAZE_BOUND, P>& x) {    \
    return graze::detail::from_c<interval<GRAZE_BOUND, P>>(graze_##name(graze::detail::to_c(x)));  \
  }
GRAZE_FOR_EACH_OF_BOOST(GRAZE_UNARY)
#undef GRAZE_UNARY

/// Encloses { t^n : t in x }, t != 0 for n < 0; t^0 = 1.
template <class P> rounded_interval<GRAZE_BOUND, P> pow(const interval<GRAZE_BOUND, P>& x, int n) {
  return graze::detail::from_c<interval<GRAZE_BOUND, P>>(graze_pown(graze::detail::to_c(x), n));
}
/// The same for an integer n of any type and size; for any other n, { t^n : t in x, t > 0, or t = 0
/// and n > 0 }.
template <class P, class N>
rounded_interval<GRAZE_BOUND, P, (graze::detail::is_number<N> && !std::is_enum_v<N>)>
pow(const interval<GRAZE_BOUND, P>& x, const N& n) {
  return graze::detail::from_c<interval<GRAZE_BOUND, P>>(
      graze::detail::power(graze::detail::to_c(x), n));
}
/// Encloses { s^t : s in x, t in y, s > 0, or s = 0 and t > 0 }.
template <class P>
rounded_interval<GRAZE_BOUND, P> pow(const interval<GRAZE_BOUND, P>& x,
                                     const interval<GRAZE_BOUND, P>& y) {
  return graze::detail::from_c<interval<GRAZE_BOUND, P>>(
      graze_pow(graze::detail::to_c(x), graze::detail::to_c(y)));
}
/// Encloses { s : s^n in x }, s >= 0 for n even; n > 0.
template <class P>
rounded_interval<GRAZE_BOUND, P> nth_root(const interval<GRAZE_BOUND, P>& x, int n) {
  return graze::detail::from_c<interval<GRAZE_BOUND, P>>(graze_rootn(graze::detail::to_c(x), n));
}

/// Encloses { fmod(s, t) : s in x, t in y, t != 0 }, with C's fmod: s - trunc(s / t) t, of s's
/// sign. Not on unprotect<interval>: there Boost's own, x - n y for one integer n, is what its
/// algorithms need.
template <class P>
rounded_interval<GRAZE_BOUND, P, (graze::detail::has_remainder<P>)>
fmod(const interval<GRAZE_BOUND, P>& x, const interval<GRAZE_BOUND, P>& y) {
  return graze::detail::from_c<interval<GRAZE_BOUND, P>>(
      graze_fmod(graze::detail::to_c(x), graze::detail::to_c(y)));
}
template <class P>
rounded_interval<GRAZE_BOUND, P, (graze::detail::has_remainder<P>)>
fmod(const interval<GRAZE_BOUND, P>& x, const GRAZE_BOUND& y) {
  return fmod(x, interval<GRAZE_BOUND, P>(y));
}
template <class P>
rounded_interval<GRAZE_BOUND, P, (graze::detail::has_remainder<P>)>
fmod(const GRAZE_BOUND& x, const interval<GRAZE_BOUND, P>& y) {
  return fmod(interval<GRAZE_BOUND, P>(x), y);
}

/// Boost's quotient, but for a divisor that reaches 0 from one side and a dividend that ends at 0:
/// [-1, 0] / [0, 1] is [-inf, 0], and not entire.
template <class P>
rounded_interval<GRAZE_BOUND, P> operator/(const interval<GRAZE_BOUND, P>& x,
                                           const interval<GRAZE_BOUND, P>& y) {
  const bool one_side = (y.lower() == 0) != (y.upper() == 0);
  if (one_side && (x.lower() == 0 || x.upper() == 0) && !graze::detail::is_none(x) &&
      !graze::detail::is_none(y))
    return graze::detail::from_c<interval<GRAZE_BOUND, P>>(
        graze_div(graze::detail::to_c(x), graze::detail::to_c(y)));
  return operator/ <GRAZE_BOUND, P>(x, y);
}

namespace interval_lib {
/// The same of Boost's quotient in two parts.
template <class P>
rounded_interval<GRAZE_BOUND, P> division_part1(const interval<GRAZE_BOUND, P>& x,
                                                const interval<GRAZE_BOUND, P>& y, bool& more) {
  if (y.lower() < 0 && 0 < y.upper())
    return division_part1<GRAZE_BOUND, P>(x, y, more);
  more = false;
  return x / y;
}
} // namespace interval_lib

// x + n and so on for numbers of other types than the bounds'. One that may be no bound is the
// tightest interval that holds it; an int is one. (Boost's ext/integer.hpp has int only, and takes
// what converts to it.)
#define GRAZE_MIXED(operation)                                                                     \
  template <class P>                                                                               \
  rounded_interval<GRAZE_BOUND, P> operator operation(const interval<GRAZE_BOUND, P>& x, int n) {  \
    return x operation graze::detail::operand<interval<GRAZE_BOUND, P>>(n);                        \
  }                                                                                                \
  template <class P>                                                                               \
  rounded_interval<GRAZE_BOUND, P> operator operation(int n, const interval<GRAZE_BOUND, P>& x) {  \
    return graze::detail::operand<interval<GRAZE_BOUND, P>>(n) operation x;                        \
  }                                                                                                \
  template <class P, class N>                                                                      \
  rounded_interval<GRAZE_BOUND, P, graze::detail::other_number<N, GRAZE_BOUND>>                    \
  operator operation(const interval<GRAZE_BOUND, P>& x, const N & n) {                             \
    return x operation interval<GRAZE_BOUND, P>(n);                                                \
  }                                                                                                \
  template <class P, class N>                                                                      \
  rounded_interval<GRAZE_BOUND, P, graze::detail::other_number<N, GRAZE_BOUND>>                    \
  operator operation(const N & n, const interval<GRAZE_BOUND, P>& x) {                             \
    return interval<GRAZE_BOUND, P>(n) operation x;                                                \
  }                                                                                                \
  template <class P, class N>                                                                      \
  std::enable_if_t<graze::detail::rounded<P> && (graze::detail::other_number<N, GRAZE_BOUND> ||    \
                                                 graze::detail::inexact_number<N, GRAZE_BOUND>),   \
                   interval<GRAZE_BOUND, P>&> operator operation##=(interval<GRAZE_BOUND, P>& x,   \
                                                                    const N & n) {                 \
    return x operation## = interval<GRAZE_BOUND, P>(n);                                            \
  }
GRAZE_MIXED(+)
GRAZE_MIXED(-)
GRAZE_MIXED(*)
GRAZE_MIXED(/)
#undef GRAZE_MIXED

#define GRAZE_MIXED(name)                                                                          \
  template <class P, class N>                                                                      \
  rounded_interval<GRAZE_BOUND, P,                                                                 \
                   (graze::detail::is_number<N> && !std::is_same_v<N, GRAZE_BOUND>)>               \
  name(const interval<GRAZE_BOUND, P>& x, const N& n) {                                            \
    return name(x, interval<GRAZE_BOUND, P>(n));                                                   \
  }                                                                                                \
  template <class P, class N>                                                                      \
  rounded_interval<GRAZE_BOUND, P,                                                                 \
                   (graze::detail::is_number<N> && !std::is_same_v<N, GRAZE_BOUND>)>               \
  name(const N& n, const interval<GRAZE_BOUND, P>& x) {                                            \
    return name(interval<GRAZE_BOUND, P>(n), x);                                                   \
  }
GRAZE_MIXED(fmod)
GRAZE_MIXED(hull)
GRAZE_MIXED(max)
GRAZE_MIXED(min)
#undef GRAZE_MIXED

/// Is the number n a member of x?
template <class P, class N>
std::enable_if_t<graze::detail::rounded<P> && graze::detail::is_number<N> &&
                     !std::is_same_v<N, GRAZE_BOUND>,
                 bool>
in(const N& n, const interval<GRAZE_BOUND, P>& x) {
  return graze::detail::round_down_to<GRAZE_BOUND>(n) == graze::detail::round_up_to<GRAZE_BOUND>(n)
             ? in(graze::detail::round_down_to<GRAZE_BOUND>(n), x)
             : in(graze::detail::round_down_to<GRAZE_BOUND>(n), x) &&
                   in(graze::detail::round_up_to<GRAZE_BOUND>(n), x);
}

// Boost's comparisons (which throw when unsure) with a number that may be no bound: in the bound
// next to it that gives the same answer. Policies with comparisons of ours have their own.
#define GRAZE_COMPARE(operation, round)                                                            \
  template <class P, class N>                                                                      \
  std::enable_if_t<graze::detail::rounded<P> && !graze::detail::compares_by_policy<P> &&           \
                       graze::detail::inexact_number<N, GRAZE_BOUND>,                              \
                   bool> operator operation(const interval<GRAZE_BOUND, P>& x, const N & n) {      \
    return x.operator operation(graze::detail::round##_to<GRAZE_BOUND>(n));                        \
  }
GRAZE_COMPARE(<, round_up)
GRAZE_COMPARE(<=, round_down)
GRAZE_COMPARE(>, round_down)
GRAZE_COMPARE(>=, round_up)
#undef GRAZE_COMPARE
#define GRAZE_COMPARE(operation)                                                                   \
  template <class P, class N>                                                                      \
  std::enable_if_t<graze::detail::rounded<P> && !graze::detail::compares_by_policy<P> &&           \
                       graze::detail::inexact_number<N, GRAZE_BOUND>,                              \
                   bool> operator operation(const interval<GRAZE_BOUND, P>& x, const N & n) {      \
    return x.operator operation(interval<GRAZE_BOUND, P>(n));                                      \
  }
GRAZE_COMPARE(==)
GRAZE_COMPARE(!=)
#undef GRAZE_COMPARE

/// "[1,2]", enclosing: at each end the shortest decimal beyond the bound and before the next
/// double (of floats too); the bounds themselves under std::hexfloat. "[]" is empty.
template <class Char, class Traits, class P>
std::enable_if_t<graze::detail::rounded<P>, std::basic_ostream<Char, Traits>&>
operator<<(std::basic_ostream<Char, Traits>& out, const interval<GRAZE_BOUND, P>& x) {
  using stream = std::basic_ostream<Char, Traits>;
  const bool hexadecimal =
      (out.flags() & stream::floatfield) == (stream::fixed | stream::scientific);
  std::basic_string<Char, Traits> text;
  for (const char c : graze::detail::to_text(x, hexadecimal))
    text += out.widen(c);
  return out << text;
}
