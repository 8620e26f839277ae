#pragma once
/// Numbers of a formula as they are meant: 0.1 is a tenth, not the doubles beside it.
#include <boost/multiprecision/cpp_int.hpp>
#include <graze/interval.hpp>
#include <memory>
#include <optional>
#include <string_view>

namespace graze::octree::tape {

using integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;
using rational = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
    boost::multiprecision::et_off>;

inline integer numerator_of(const rational& x) { return integer(numerator(x)); }
inline integer denominator_of(const rational& x) { return integer(denominator(x)); }
/// Bits of |x|, an integer of any kind; 0 for 0.
template <class Integer> unsigned bits_of(const Integer& x) {
  return x.is_zero() ? 0 : static_cast<unsigned>(msb(x.sign() < 0 ? Integer(-x) : x)) + 1;
}

/// The double as a rational; finite.
rational exactly(double x);
/// The tightest interval that holds x; unbounded beyond the greatest double.
graze::interval<> enclosure_of(const rational& x);
/// The number that a literal means: a sign or none, digits with one point at most, and an exponent after e, or, after
/// 0x, after p. Nothing where it needs too many bits.
std::optional<rational> exact_literal(std::string_view text);

/// A real number: an interval that encloses it and, where it is a rational of at most most_bits bits
/// above and below the line and is known, the number itself.
class number {
public:
  using interval = graze::interval<>;
  static constexpr unsigned most_bits = 2048;

  explicit number(double x) : enclosure_(x) {}
  number(double lo, double hi) : enclosure_(lo, hi) {}
  explicit number(const interval& enclosure) : enclosure_(enclosure) {}
  /// x, of any size.
  explicit number(const rational& x);
  /// What encloses a number, and the number, if it is known.
  number(const interval& enclosure, const std::optional<rational>& exact)
      : number(exact ? number(*exact) : number(enclosure)) {}

  [[nodiscard]] double lower() const { return enclosure_.lower(); }
  [[nodiscard]] double upper() const { return enclosure_.upper(); }
  [[nodiscard]] const interval& enclosure() const { return enclosure_; }
  [[nodiscard]] bool is_known() const { return exact_ || is_double(); }
  /// The number, if it is known.
  [[nodiscard]] std::optional<rational> exact() const;

  number operator-() const;
  friend number operator+(const number& x, const number& y);
  friend number operator-(const number& x, const number& y);
  friend number operator*(const number& x, const number& y);
  /// Where y may be 0 the enclosure is that of the quotients that are defined.
  friend number operator/(const number& x, const number& y);
  /// The same number, for all that is known.
  friend bool operator==(const number& x, const number& y);

private:
  [[nodiscard]] bool is_double() const { return lower() == upper() && lower() - lower() == 0; }

  interval enclosure_;
  std::shared_ptr<const rational> exact_; ///< of one that is known and no double
};

} // namespace graze::octree::tape
