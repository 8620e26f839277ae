#pragma once
/// Expressions on which floating point fails, each written once, over any library of libraries.hpp.
/// An expression has a name, its formula as a text, what it needs, and value<L>().
#include "libraries.hpp"
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace graze::bench::hard {

/// What the compiler does not know: no expression is evaluated when it is compiled.
inline precise hidden(const char* decimal_text) { return precise(decimal_text); }

using std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt, std::tan;

/// S. M. Rump, "Algorithms for verified inclusions", in Reliability in Computing, 1988.
struct rump {
  std::string name = "Rump's expression";
  std::string formula = "333.75 b^6 + a^2 (11 a^2 b^2 - b^6 - 121 b^4 - 2) + 5.5 b^8 + a/(2b) at "
                        "a = 77617, b = 33096";
  static constexpr functions needs = functions::none;
  template <class L> typename L::number value() const {
    using N = typename L::number;
    const N a = L::constant(77617), b = L::constant(33096);
    const N a2 = sqr(a), b2 = sqr(b), b4 = sqr(b2), b6 = b4 * b2, b8 = sqr(b4);
    return N(333.75) * b6 + a2 * (N(11) * a2 * b2 - b6 - N(121) * b4 - N(2)) + N(5.5) * b8 +
           a / (N(2) * b);
  }
};

/// J. H. Wilkinson, "The evaluation of the zeros of ill-conditioned polynomials", Numerische
/// Mathematik 1, 1959: the product of x - k for k = 1 to 20, by its coefficients.
struct wilkinson {
  std::string name, formula;
  precise at, perturbation; ///< of the coefficient of x^19
  static constexpr functions needs = functions::none;

  wilkinson(const char* x, bool perturbed)
      : name("Wilkinson's polynomial"), formula("(x - 1)(x - 2)...(x - 20)"), at(hidden(x)),
        perturbation(perturbed ? -0x1p-23 : 0) {
    if (perturbed)
      name.append(", perturbed"), formula.append(" - 2^-23 x^19");
    formula.append(", by Horner's rule on its coefficients, at x = ").append(x);
  }

  /// Exact: integers below 2^64, and a perturbed one.
  [[nodiscard]] std::vector<precise> coefficients() const {
    std::vector<precise> c{1}; // from the constant one upwards
    for (int k = 1; k <= 20; ++k) {
      c.emplace_back(0);
      for (std::size_t i = c.size() - 1; i > 0; --i)
        c[i] = c[i - 1] - k * c[i];
      c[0] *= -k;
    }
    c[19] += perturbation;
    return c;
  }
  template <class L> typename L::number value() const {
    using N = typename L::number;
    const std::vector<precise> c = coefficients();
    const N x = L::constant(at);
    N r = L::constant(c.back());
    for (std::size_t i = c.size() - 1; i-- > 0;)
      r = r * x + L::constant(c[i]);
    return r;
  }
};

/// (x - r)^2 - d for r the double next to 1.1 by its coefficients: two roots 2 sqrt(d) apart.
struct near_double_roots {
  precise r = 0x1.199999999999ap+0, d;
  template <class L> typename L::number polynomial(const typename L::number& x) const {
    return x * x - L::constant(2 * r) * x + L::constant(r * r - d);
  }
};
struct between_roots : near_double_roots {
  between_roots() : near_double_roots{.d = 0x1p-50} {}
  std::string name = "Between near-double roots";
  std::string formula =
      "x^2 - 2 r x + (r^2 - 2^-50) at x = r = 0x1.199999999999ap+0: the roots are 2^-24 apart";
  static constexpr functions needs = functions::none;
  template <class L> typename L::number value() const { return polynomial<L>(L::constant(r)); }
};
/// A step of interval Newton: a result inside of the start proves that there is one root in it. For
/// plain double a step from the middle.
struct newton : near_double_roots {
  newton() : near_double_roots{.d = 0x1p-48} {}
  std::string name = "Newton at a near-double root";
  std::string formula =
      "m - p(m)/p'(X), p = x^2 - 2 r x + (r^2 - 2^-48), r = 0x1.199999999999ap+0, "
      "X = r + [2^-25, 3 2^-25], m in its middle";
  static constexpr functions needs = functions::none;
  [[nodiscard]] std::pair<double, double> start() const {
    return {rounded(r + 0x1p-25, MPFR_RNDD), rounded(r + 3 * precise(0x1p-25), MPFR_RNDU)};
  }
  template <class L> typename L::number value() const {
    using N = typename L::number;
    const auto [lower, upper] = start();
    const N x = L::make(lower, upper), m = L::constant(precise((lower + upper) / 2));
    return m - polynomial<L>(m) / (N(2) * x - L::constant(2 * r));
  }
  /// The root, not what a step of the reference would give.
  [[nodiscard]] precise truth() const { return r + sqrt(d); }
};

/// J.-M. Muller, "Arithmetique des ordinateurs", Masson, 1989: tends to 5, in floating point to
/// 100.
struct muller {
  std::string name, formula;
  int steps;
  static constexpr functions needs = functions::none;
  explicit muller(int n)
      : name("Muller's recurrence"),
        formula("x_n = 108 - (815 - 1500/x_{n-2})/x_{n-1}, x_0 = 4, x_1 = 4.25, n = " +
                std::to_string(n)),
        steps(n) {}
  template <class L> typename L::number value() const {
    using N = typename L::number;
    N before = L::constant(4), x = L::constant(4.25);
    for (int i = 1; i < steps; ++i) {
      const N next = N(108) - (N(815) - N(1500) / before) / x;
      before = x, x = next;
    }
    return x;
  }
};

struct thirds {
  std::string name = "Thirds", formula = "3 (4/3 - 1) - 1";
  static constexpr functions needs = functions::none;
  template <class L> typename L::number value() const {
    using N = typename L::number;
    return N(3) * (L::constant(4) / L::constant(3) - N(1)) - N(1);
  }
  /// No thirds in binary numbers, of whatever precision.
  [[nodiscard]] precise truth() const { return 0; }
};

/// An expression that is a lambda of the library.
template <functions needed, class Formula> struct short_expression {
  std::string name, formula;
  Formula f;
  static constexpr functions needs = needed;
  template <class L> typename L::number value() const { return f.template operator()<L>(); }
};
template <functions needed, class Formula>
auto expression(const char* name, const char* formula, Formula f) {
  return short_expression<needed, Formula>{name, formula, f};
}

/// A function at a point.
#define GRAZE_HARD_POINT(name, formula, needed, x, f)                                              \
  expression<functions::needed>(name, formula, []<class L>() { return f(L::constant(x)); })

/// each(expression) for all.
template <class Each> void for_each_expression(Each each) {
  each(rump());
  for (const char* x : {"1", "10.5", "20"})
    each(wilkinson(x, false));
  for (const char* x : {"16", "20.846908101482257"})
    each(wilkinson(x, true));
  each(between_roots());
  each(newton());
  each(expression<functions::none>("Absorption", "1e16 + 1 - 1e16", []<class L>() {
    using N = typename L::number;
    const N big = L::constant(hidden("1e16"));
    return big + N(1) - big;
  }));
  each(thirds());
  each(expression<functions::none>("Cancelling roots", "sqrt(x + 1) - sqrt(x) at x = 1e15",
                                   []<class L>() {
                                     using N = typename L::number;
                                     const N x = L::constant(hidden("1e15"));
                                     return N(sqrt(N(x + N(1))) - sqrt(x));
                                   }));
  each(expression<functions::elementary>("Cancelling cosine", "(1 - cos x)/x^2 at x = 1e-8",
                                         []<class L>() {
                                           using N = typename L::number;
                                           const N x = L::constant(hidden("1e-8"));
                                           return N((N(1) - cos(x)) / sqr(x));
                                         }));
  each(expression<functions::elementary>("Cancelling exponential",
                                         "(exp(x) - 1 - x)/x^2 at x = 1e-7", []<class L>() {
                                           using N = typename L::number;
                                           const N x = L::constant(hidden("1e-7"));
                                           return N((exp(x) - N(1) - x) / sqr(x));
                                         }));
  each(muller(8)), each(muller(30));
  each(GRAZE_HARD_POINT("Huge argument", "sin(2^1000)", elementary, 0x1p1000, sin));
  each(GRAZE_HARD_POINT("Huge argument", "cos(1e22)", elementary, 1e22, cos));
  each(GRAZE_HARD_POINT("Next to a multiple of pi", "sin(x) at x = 0x1.36bf9a50c044p+1012",
                        elementary, 0x1.36bf9a50c044p+1012, sin));
  each(GRAZE_HARD_POINT("Next to a pole",
                        "tan(x) at x = 6381956970095103 2^797, the double "
                        "nearest to a multiple of pi/2",
                        elementary, 0x1.6ac5b262ca1ffp+849, tan));
  each(GRAZE_HARD_POINT("At overflow", "exp(709.78271289338397), the last that is finite",
                        elementary, 0x1.62e42fefa39efp+9, exp));
  each(GRAZE_HARD_POINT("Beyond overflow", "exp(709.78271289338409)", elementary,
                        0x1.62e42fefa39f0p+9, exp));
  each(GRAZE_HARD_POINT("Nearly nothing", "exp(-745.13321910194111), the last that is not 0",
                        elementary, -0x1.74910d52d3051p+9, exp));
  each(expression<functions::power>("Power next to 1", "(1 + 2^-52)^(2^53)", []<class L>() {
    return pow(L::constant(1 + precise(0x1p-52)), L::constant(0x1p53));
  }));
  each(expression<functions::elementary>("Power next to 1, by logarithm",
                                         "exp(y log x) at x = 1 + 2^-30, y = 2^39", []<class L>() {
                                           using N = typename L::number;
                                           const N x = L::constant(1 + precise(0x1p-30));
                                           return exp(N(L::constant(0x1p39) * log(x)));
                                         }));
}
#undef GRAZE_HARD_POINT

} // namespace graze::bench::hard
