#pragma once
/// Text and intervals (IEEE 1788-2015, 9.7, 12.11, 13.4): exact in both directions. Defined in
/// interval/src/text/text_to_interval.cpp and interval_to_text.cpp.
#include <graze/needs_cxx20.hpp>

#include <graze/construct.hpp>
#include <iosfwd>
#include <string>
#include <string_view>

namespace graze {

/// The tightest enclosure of what an interval literal means, in any case of letters:
///   "[1.5]" "[1, 2]" "[-0x1.8p-3, 1/3]" "[,3]" "[-inf, 3]" "[entire]" "[ ]" "[empty]"
///   "3.56?" (half a unit of the last place to each side), "3.56?12" (12 units), "3.56??" (no
///   limit), with u or d for one side only and an exponent: "3.56?1ue-2".
/// Numbers are decimal, hexadecimal (with a p exponent) or quotients of integers, of any length and
/// with exponents of any size. Blanks may stand within the brackets, around the numbers and words.
/// Anything else: empty and undefined_operation. Two ends, different and both strictly between the
/// same two neighbouring doubles, give that pair of doubles and possibly_undefined_operation,
/// whichever is the lesser.
signalling<bounds> text_to_interval(std::string_view text);

/// The same with "_com", "_dac", "_def" or "_trv" after the literal if wanted (a promise that the
/// literal, as an exact set, cannot keep is an error), and "[nai]". Without it, the best
/// decoration. Errors: NaI and undefined_operation. A `com` literal whose enclosure overflows
/// becomes `dac`.
signalling<decorated_bounds> text_to_decorated(std::string_view text);

enum class text_style {
  decimal,       ///< at each end the shortest decimal beyond the bound and before the next double
  exact_decimal, ///< every digit of the bounds
  hexadecimal,   ///< the bounds as hexadecimal numbers
};

/// A literal that holds x: text_to_interval gives x back from exact_decimal and hexadecimal; from
/// `decimal`, x or an interval wider by one ulp at an end.
std::string interval_to_text(const bounds& x, text_style style = text_style::decimal);
/// With the decoration: "[1, 2]_com", "[nai]".
std::string interval_to_text(const decorated_bounds& x, text_style style = text_style::decimal);
template <Real N, Policies P>
std::string interval_to_text(const interval_of<P, N>& x, text_style style = text_style::decimal) {
  return interval_to_text(to_bounds(x), style);
}

/// interval_to_text in the stream's style: hexadecimal under std::hexfloat, else decimal.
std::ostream& operator<<(std::ostream& out, const bounds& x);
std::ostream& operator<<(std::ostream& out, const decorated_bounds& x);

} // namespace graze
