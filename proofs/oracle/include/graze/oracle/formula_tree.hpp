#pragma once
/// Random formulas, and their values by MPFR: shares nothing with the parser but the grammar.
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <graze/oracle/random_bits.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace graze::oracle {

/// 600 bits.
using real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<180>,
                                           boost::multiprecision::et_off>;

/// A formula as a text and as a function; its value is missing where it is not defined.
struct tree {
  std::string text;
  std::vector<std::shared_ptr<tree>> operands;
  std::optional<real> (*value_of)(const std::vector<real>&) = nullptr;
  /// Of a choice: whether its third operand is the value, or its fourth; the other is not looked at.
  bool (*chooses)(const real&, const real&) = nullptr;
  int axis = -1;      ///< of a variable
  std::string digits; ///< of a constant

  /// The judge does not follow values beyond this, and says so in gave_up (to be cleared).
  static inline real greatest{"1e300"};
  static inline bool gave_up = false;

  [[nodiscard]] std::optional<real> operator()(const std::array<real, 3>& p) const {
    if (axis >= 0)
      return p[static_cast<std::size_t>(axis)];
    if (!digits.empty())
      return real(digits);
    std::vector<real> x;
    if (chooses != nullptr) {
      const auto a = (*operands[0])(p), b = (*operands[1])(p);
      if (!a || !b)
        return std::nullopt;
      // so near that they may be equal but for the judge's roundings
      gave_up = gave_up || (*a != *b && abs(*a - *b) < real("1e-100") * (1 + abs(*a)));
      return gave_up ? std::nullopt : (*operands[chooses(*a, *b) ? 2 : 3])(p);
    }
    for (const auto& t : operands) {
      const auto v = (*t)(p);
      if (!v)
        return std::nullopt;
      x.push_back(*v);
    }
    auto r = value_of(x);
    if (r && *r == 0)
      r = real(0); // real numbers have one zero: atan2(0, x) of MPFR tells -0 from it
    gave_up = gave_up || (r && (!isfinite(*r) || abs(*r) > greatest));
    return gave_up ? std::nullopt : r;
  }
};

using optional_real = std::optional<real>;
using arguments = std::vector<real>;

template <auto Function> optional_real by_mpfr(const arguments& x) {
  real r;
  if constexpr (std::is_invocable_v<decltype(Function), mpfr_ptr, mpfr_srcptr, mpfr_srcptr,
                                    mpfr_rnd_t>)
    Function(r.backend().data(), x[0].backend().data(), x[1].backend().data(), MPFR_RNDN);
  else
    Function(r.backend().data(), x[0].backend().data(), MPFR_RNDN);
  if (isnan(r))
    return std::nullopt;
  return r;
}

struct shape {
  const char* before;
  int operands;
  optional_real (*value)(const arguments&);
  bool (*chooses)(const real&, const real&) = nullptr;
};

inline optional_real modulo(const arguments& x) {
  if (x[1] == 0)
    return std::nullopt;
  return real(x[0] - x[1] * floor(real(x[0] / x[1])));
}

/// "f(" for a function; an operator otherwise; or the whole, with @ for each operand.
inline const std::vector<shape>& shapes() {
  using a = const arguments&;
  static const std::vector<shape> table{
      {"+", 2, [](a x) -> optional_real { return real(x[0] + x[1]); }},
      {"-", 2, [](a x) -> optional_real { return real(x[0] - x[1]); }},
      {"*", 2, [](a x) -> optional_real { return real(x[0] * x[1]); }},
      {"+", 2, [](a x) -> optional_real { return real(x[0] + x[1]); }},
      {"-", 2, [](a x) -> optional_real { return real(x[0] - x[1]); }},
      {"*", 2, [](a x) -> optional_real { return real(x[0] * x[1]); }},
      {"/", 2,
       [](a x) -> optional_real {
         return x[1] == 0 ? std::nullopt : optional_real(real(x[0] / x[1]));
       }},
      {"^2", 1, [](a x) -> optional_real { return real(x[0] * x[0]); }},
      {"^3", 1, [](a x) -> optional_real { return real(x[0] * x[0] * x[0]); }},
      {"^4", 1, [](a x) -> optional_real { return real(pow(x[0], 4)); }},
      {"^7", 1, [](a x) -> optional_real { return real(pow(x[0], 7)); }},
      {"^-1", 1,
       [](a x) -> optional_real {
         return x[0] == 0 ? std::nullopt : optional_real(real(1 / x[0]));
       }},
      {"^-2", 1,
       [](a x) -> optional_real {
         return x[0] == 0 ? std::nullopt : optional_real(real(1 / (x[0] * x[0])));
       }},
      {"^1.5", 1,
       [](a x) -> optional_real {
         return x[0] < 0 ? std::nullopt : optional_real(real(x[0] * sqrt(x[0])));
       }},
      {"sqr(", 1, [](a x) -> optional_real { return real(x[0] * x[0]); }},
      {"sqrt(", 1, by_mpfr<&mpfr_sqrt>},
      {"cbrt(", 1, by_mpfr<&mpfr_cbrt>},
      {"abs(", 1, [](a x) -> optional_real { return real(abs(x[0])); }},
      {"min(", 2, [](a x) -> optional_real { return x[1] < x[0] ? x[1] : x[0]; }},
      {"max(", 2, [](a x) -> optional_real { return x[0] < x[1] ? x[1] : x[0]; }},
      {"difference(", 2, [](a x) -> optional_real { return x[0] < -x[1] ? real(-x[1]) : x[0]; }},
      {"hypot(", 2, by_mpfr<&mpfr_hypot>},
      {"atan2(", 2,
       [](a x) { return x[0] == 0 && x[1] == 0 ? std::nullopt : by_mpfr<&mpfr_atan2>(x); }},
      {"pow(", 2,
       [](a x) -> optional_real {
         if (x[0] < 0 || (x[0] == 0 && x[1] <= 0))
           return std::nullopt;
         return by_mpfr<&mpfr_pow>(x);
       }},
      {"exp(", 1, by_mpfr<&mpfr_exp>},
      {"exp2(", 1, by_mpfr<&mpfr_exp2>},
      {"exp10(", 1, by_mpfr<&mpfr_exp10>},
      {"expm1(", 1, by_mpfr<&mpfr_expm1>},
      {"log(", 1, by_mpfr<&mpfr_log>},
      {"log2(", 1, by_mpfr<&mpfr_log2>},
      {"log10(", 1, by_mpfr<&mpfr_log10>},
      {"log1p(", 1, by_mpfr<&mpfr_log1p>},
      {"sin(", 1, by_mpfr<&mpfr_sin>},
      {"cos(", 1, by_mpfr<&mpfr_cos>},
      {"tan(", 1, by_mpfr<&mpfr_tan>},
      {"cot(", 1, by_mpfr<&mpfr_cot>},
      {"sec(", 1, by_mpfr<&mpfr_sec>},
      {"csc(", 1, by_mpfr<&mpfr_csc>},
      {"asin(", 1, by_mpfr<&mpfr_asin>},
      {"acos(", 1, by_mpfr<&mpfr_acos>},
      {"atan(", 1, by_mpfr<&mpfr_atan>},
      {"acot(", 1, [](a x) { return by_mpfr<&mpfr_atan2>({real(1), x[0]}); }},
      {"sinh(", 1, by_mpfr<&mpfr_sinh>},
      {"cosh(", 1, by_mpfr<&mpfr_cosh>},
      {"tanh(", 1, by_mpfr<&mpfr_tanh>},
      {"coth(", 1, by_mpfr<&mpfr_coth>},
      {"sech(", 1, by_mpfr<&mpfr_sech>},
      {"csch(", 1, by_mpfr<&mpfr_csch>},
      {"asinh(", 1, by_mpfr<&mpfr_asinh>},
      {"acosh(", 1, by_mpfr<&mpfr_acosh>},
      {"atanh(", 1, by_mpfr<&mpfr_atanh>},
      {"acoth(", 1,
       [](a x) -> optional_real {
         return x[0] == 0 ? std::nullopt : by_mpfr<&mpfr_atanh>({real(1 / x[0])});
       }},
      {"floor(", 1, [](a x) -> optional_real { return real(floor(x[0])); }},
      {"ceil(", 1, [](a x) -> optional_real { return real(ceil(x[0])); }},
      {"trunc(", 1, [](a x) -> optional_real { return real(trunc(x[0])); }},
      {"sign(", 1, [](a x) -> optional_real { return real(x[0].sign()); }},
      {"mod(", 2, modulo},
      {"%", 2, modulo},
      {"|@|", 1, [](a x) -> optional_real { return real(abs(x[0])); }},
      {"(@)²", 1, [](a x) -> optional_real { return real(x[0] * x[0]); }},
      {"clamp(@,-0.5,1)", 1,
       [](a x) -> optional_real { return x[0] < -0.5 ? real(-0.5)
                                         : x[0] > 1  ? real(1)
                                                     : x[0]; }},
      {"if(@<@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s < t; }},
      {"if(@<=@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s <= t; }},
      {"if(@>@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s > t; }},
      {"if(not @>=@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s < t; }},
      {"if(@==@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s == t; }},
      {"if(@!=@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s != t; }},
      {"if(@>=@,@,@)", 4, nullptr, [](const real& s, const real& t) { return s >= t; }},
  };
  return table;
}

inline std::size_t below(random_bits& random, std::size_t n) { return random() % n; }

/// A random formula. `arithmetic`: polynomials alone.
inline std::shared_ptr<tree> some_tree(random_bits& random, int depth, bool arithmetic) {
  auto t = std::make_shared<tree>();
  if (depth == 0 || below(random, 5) == 0) {
    if (below(random, 4) == 0) {
      static const char* const constants[] = {"1",   "2",    "0.5",  "0.1", "3",
                                              "1.7", "11.8", "0.25", "5"};
      t->digits = t->text = constants[below(random, std::size(constants))];
    } else {
      t->axis = static_cast<int>(below(random, 3));
      t->text = std::string(1, "xyz"[t->axis]);
    }
    return t;
  }
  const shape& s = shapes()[below(random, arithmetic              ? 6
                                          : below(random, 2) == 0 ? 13
                                                                  : shapes().size())];
  t->value_of = s.value;
  t->chooses = s.chooses;
  for (int i = 0; i < s.operands; ++i)
    t->operands.push_back(some_tree(random, depth - 1, arithmetic));
  const std::string name = s.before;
  if (name.find('@') != name.npos) {
    auto operand = t->operands.begin();
    for (const char c : name)
      c == '@' ? t->text += "(" + (*operand++)->text + ")" : t->text += c;
  } else if (name.back() == '(')
    t->text =
        name + t->operands[0]->text + (s.operands == 2 ? "," + t->operands[1]->text : "") + ")";
  else if (s.operands == 2)
    t->text = "(" + t->operands[0]->text + name + t->operands[1]->text + ")";
  else
    t->text = "(" + t->operands[0]->text + ")" + name;
  return t;
}

} // namespace graze::oracle
