#pragma once
/// The language of .itl files ("ITL", the interval test language of the ITF1788 framework):
///   file      = testcase+                      testcase  = "testcase" name ("." name)* "{" test+
///   "}" test      = operation literal* results ";" results   = ["=" literal+] ["<=" literal+]
///                                                          ["signal" exception]
///   literal   = interval | number | integer | string | array | true, false | decoration | overlap
///   interval  = "[" number "," number "]" | "[empty]" | "[entire]", each with an optional "_" and
///               decoration, | "[nai]"
///   number    = decimal or hexadecimal of C with an optional suffix f or l, infinity, NaN
///   array     = "{" [number ("," number)*] "}"
/// A number that is no double is kept as it is written (other_format), not rounded: a hexadecimal
/// one, and a decimal one of more than 17 digits; shorter decimals mean the nearest double. So is
/// whatever else stands in a literal's place and is none. Their statements are not supported.
/// Comments: // or # to the end of the line, /* ... */ and #* ... *#.
/// Source: M. Kiesner, M. Nehmeier, J. Wolff von Gudenberg, "ITF1788: An Interval Testframework for
/// IEEE 1788", Technical Report 495, University of Wuerzburg, 2015. More lenient than there:
/// comments may stand anywhere, integers may stand for numbers, decimals with an exponent need no
/// point.
#include <graze/expected.hpp>
#include <graze/itf1788/value.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace graze::itf1788 {

/// One statement: what the operation must give on these operands.
struct statement {
  int line = 0;          ///< where it begins, from 1
  std::string written;   ///< its text, without ";", each space or comment one blank
  std::string operation; ///< by its name in the file: "sin", "d-textToInterval"
  std::vector<value> operands;
  std::vector<value> tightest; ///< after "=": the results, exactly; empty if not stated
  std::vector<value> accurate; ///< after "<=": what they must lie within; empty if not stated
  std::string signal;          ///< the exception that must be signalled; empty: none may be
};

/// The statements of a file in their order. Refused: anything else than the grammar above, an
/// interval literal that holds no number, a decoration that its interval cannot have; the reason
/// begins with `name`:line.
expected<std::vector<statement>> parse(std::string_view text, const std::string& name);

} // namespace graze::itf1788
