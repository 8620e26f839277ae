#pragma once
/// Surfaces from text: `formula::parse("x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8")`.
///
/// Grammar, blanks anywhere between (docs/formulas.md has it for users):
///   formula  = { definition ";" } any [ "=" any ] { ";" }  f = g is f - g
///   definition = [ "let" ] name "=" any                    of a name without a meaning, once
///   any      = all { ("or" | "||") all }
///   all      = negation { ("and" | "&&") negation }
///   negation = { "not" | "!" } comparison
///   comparison = sum [ ("<" | "<=" | ">" | ">=" | "==" | "!=") sum ]
///   sum      = product { ("+" | "-") product }
///   product  = signed { ("*" | "/" | "%") signed | power } the last: 5x^2, 2|x|, (x+1)(x-1)
///   signed   = { "+" | "-" } power                         -x^2 is -(x^2)
///   power    = primary [ ("^" | "**") signed | superscripts ]   x^y^z is x^(y^z)
///   primary  = number | name | name "(" any { "," any } ")" | "(" formula ")" | "|" sum "|"
/// A number is decimal (11.8, .5, 1e-3) or hexadecimal (0x1.8p-3) and means that real number: one
/// that is no double is enclosed by its two neighbours. Names, in upper case too: x y z, pi;
/// e,
///   r = hypot(x, y), rho = hypot(r, z), theta = atan2(y, x), phi = atan2(r, z) in [0, pi], the angle
///   from the z axis (these four may be defined anew); and, in upper case too, the functions
///   sqr sqrt cbrt abs exp exp2 exp10 expm1 log (ln) log2 log10 log1p sin cos tan cot sec csc asin
///   acos atan acot sinh cosh tanh coth sech csch asinh acosh atanh acoth sign floor ceil trunc,
///   atan2(y, x) hypot(x, y) pow(x, y) pown(x, n) rootn(x, n), min and max of two or more,
///   clamp(x, least, greatest) = min(max(x, least), greatest),
///   mod(x, m) = x % m = x - m floor(x/m), of the sign of m,
///   if(c, a, b): a where the comparison c holds, else b, and for
///   solids f <= 0: union(a, b, ...) = min, intersection(a, b, ...) = max,
///   difference(a, b) = max(a, -b). Where a solid is wanted, and as the whole, a comparison is one:
///   f < g and f <= g are f - g, "and" is max, "or" is min.
/// × · and − are signs, π θ φ ρ names, ≤ ≥ ≠ comparisons, ² and ⁻¹ exponents. A product without a sign
/// is refused where it could be read in two ways: after "/", "%" and "^", as in 1/2x and x^2y, and
/// beside a closing bar. A bar opens where a number may begin, and closes elsewhere. x^n with an
/// integer n is the power for all x; with any other exponent x^y = e^(y log x), for x > 0, or
/// x = 0 < y: the real cube root of any number is cbrt(x).
///
/// Where f is not defined there is no surface: {f = 0} holds points at which f is defined, that is,
/// at which every part of the formula is (min(sqrt(x), y) is not, for x < 0), but for the operand
/// that if(c, a, b) does not choose, and the comparisons that "and" and "or" in c do not need.
#include <graze/expected.hpp>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/inclusion.hpp>
#include <graze/octree_formula/evaluate.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace graze::octree {

/// f(x, y, z) of a formula, which must outlive it. Models Surface: a number type in, the same out,
/// over double, intervals of any policies, interval8 (octree_formula/operations_eight.hpp), and
/// duals of these. Copying costs nothing.
///
/// What an evaluation over intervals says of a box where f is not defined, or not continuous,
/// everywhere:
///   - The value encloses f at all points of the box at which f is defined. Hence an octant whose
///     value excludes 0 holds no surface, and any other is kept: also one in which f is defined
///     nowhere for all that intervals can tell.
///   - Where the value's enclosure is empty, f is defined nowhere on the box and has no zero there;
///     the value given is 1, which says just that.
///   - Derivatives are unbounded, [-inf, inf], unless f is proven to be defined and continuous on
///     the whole box: the mean value theorem needs the segment to the centre, and f monotone in
///     each variable means nothing across a gap. So the mean value form and the last-level test
///     discard nothing there.
///   - Signs at two points prove no zero between them unless continuous_on() holds for a box (or a
///     segment) that has both: 1/x changes its sign and has no zero.
/// Derivatives are those of f as it is on the box: at a kink (abs, min, max) within it those of
/// both branches, that is, Clarke's generalized gradient, for which the mean value theorem holds
/// (Lebourg); with a kink in the box's face those of the branch within.
class formula_surface {
public:
  explicit formula_surface(const tape::program& p) : program_(&p) {}

  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return tape::evaluate(*program_, x, y, z);
  }

  /// Proven: f is defined at every point of the box and continuous on it. Within a scope of B.
  template <rounding::Backend B> [[nodiscard]] bool continuous_on(const bound3<B>& x) const {
    return program_->continuous || tape::run<true>(*program_, x[0], x[1], x[2]).continuous != 0;
  }
  /// f is defined and continuous everywhere.
  [[nodiscard]] bool continuous() const { return program_->continuous; }
  /// The natural interval extension is the range but for rounding, so that a mean value form cannot
  /// be tighter (of min and max, as in surfaces.hpp: their lower, or upper, end).
  [[nodiscard]] bool natural_extension_suffices() const { return program_->tight; }
  [[nodiscard]] const tape::program& program() const { return *program_; }

  /// What certified_search leaves open along a ray in the domain, decided where that can be: where f is
  /// a polynomial; where it has no zero but jumps, has a pole, or ends (verdict.hpp); and where it is
  /// exactly 0 on a face of the domain. A polynomial's coefficients are the numbers that are written,
  /// rational (pi is not), its degree is 64 at most, and its roots are found whatever their order and
  /// however near to each other they are; what takes more than some milliseconds is left open.
  /// Within no scope.
  [[nodiscard]] certified_hit look_closer(const ray& r, const box& domain,
                                          const certified_hit& found) const;

private:
  const tape::program* program_;
};

/// A name with a value that is given from outside of the text.
struct parameter {
  static constexpr std::size_t longest_name = 100;
  std::string name, value;

  /// Refuses what is no name, or has a meaning already (but r, rho, theta, phi), and a value that is
  /// no constant, as a formula: "0.3" is that decimal's real number, "sqrt(5)/2" its. `column`, in
  /// bytes from 1, is where the value goes wrong; 0 if it does not.
  [[nodiscard]] static expected<parameter> make(std::string_view name, std::string_view value,
                                                std::size_t* column = nullptr);
};

/// A text formula, compiled. Copies share what was compiled, which never changes: any thread.
class formula {
public:
  /// Bytes of text, operators within operators, numbers' characters, and terms that are copied
  /// where definitions are used, beyond which a text is refused.
  static constexpr std::size_t longest_text = 65536, most_nested = 200, longest_number = 1000,
                               most_terms = 1 << 18;

  /// Refuses what is no formula, with a reason that begins with "column N: ", in characters of UTF-8
  /// from 1; `column`, if given, is the same place in bytes from 1. Any text, hostile ones included:
  /// time and memory are bounded, nothing is thrown. `set`: see parameter::make.
  [[nodiscard]] static expected<formula> parse(std::string_view text, std::size_t* column = nullptr,
                                               std::span<const parameter> set = {});

  [[nodiscard]] formula_surface surface() const { return formula_surface(*program_); }
  /// What was parsed.
  [[nodiscard]] const std::string& text() const { return program_->text; }
  /// Whether this parameter is part of it.
  [[nodiscard]] bool uses(std::string_view name) const;
  /// Of powers that are not proven to have a base >= 0 on the domain, such as x^(1/3), what else may
  /// be meant: "x^(1/3) is defined for x >= 0; cbrt(x)?".
  [[nodiscard]] std::vector<std::string> notes(const box& domain) const;

private:
  explicit formula(std::shared_ptr<const tape::program> p) : program_(std::move(p)) {}

  std::shared_ptr<const tape::program> program_;
};

} // namespace graze::octree
