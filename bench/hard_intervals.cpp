// graze-hard-intervals: expressions on which floating point fails, evaluated by graze::interval,
// plain double and the interval libraries that are here. A JSON object a line: an expression, a
// library, its answer, and what it is worth. True values are MPFR's with 4,000 bits; the program
// fails (exit code 1) if 2,000 bits give another double.
#include "hard/expressions.hpp"
#include <cstdio>
#include <cstdlib>
#include <graze/rounding/environment.hpp>

namespace {

using namespace graze::bench::hard;

std::string quoted(const std::string& s) {
  std::string r(1, '"');
  for (const char c : s)
    r += c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ' ? '\'' : c;
  r.push_back('"');
  return r;
}

std::string hexadecimal(double x) {
  char text[48];
  std::snprintf(text, sizeof text, "\"%a\"", x);
  return text;
}

std::string decimals(const precise& x) {
  char text[64];
  mpfr_snprintf(text, sizeof text, "%.20Rg", x.backend().data());
  return text;
}

/// Where the true value is, and with how many digits it is told.
struct truth {
  precise value;
  double lower, upper;

  explicit truth(const precise& x)
      : value(x), lower(rounded(x, MPFR_RNDD)), upper(rounded(x, MPFR_RNDU)) {}
  [[nodiscard]] bool within(double lo, double hi) const { return lo <= lower && upper <= hi; }
};

template <class Expression> truth truth_of(const Expression& e) {
  if constexpr (requires { e.truth(); }) {
    return truth(e.truth());
  } else {
    const truth t(e.template value<reference<1204>>());
    const truth again(precise(e.template value<reference<602>>()));
    if (t.lower != again.lower || t.upper != again.upper) {
      std::fprintf(stderr, "graze-hard-intervals: 2,000 bits are too few for %s\n",
                   e.formula.c_str());
      std::exit(1);
    }
    return t;
  }
}

/// "wrong": the true value is outside. "useless": it is inside, and no digit of it is known: the
/// width is greater than the value (than 1/2 where that is 0). "holds" otherwise. "no answer": NaN.
const char* worth(double lo, double hi, const truth& t) {
  if (!(lo <= hi))
    return "no answer";
  if (!t.within(lo, hi))
    return "wrong";
  const double value = std::fmax(std::fabs(t.lower), std::fabs(t.upper));
  if (std::isinf(t.lower) || std::isinf(t.upper))
    return lo > 0 || hi < 0 ? "holds" : "useless"; // beyond the doubles
  return hi - lo <= (value > 0 ? value : 0.5) ? "holds" : "useless";
}

/// In ulps of the true value; where that is 0, as it is.
double error_of(double answer, const truth& t) {
  const double magnitude = std::fmax(std::fabs(t.lower), std::fabs(t.upper));
  const precise error = abs(precise(answer) - t.value);
  return static_cast<double>(
      magnitude > 0 ? error / precise(std::nextafter(magnitude, INFINITY) - magnitude) : error);
}

template <class L, class Expression> void evaluate(const Expression& e, const truth& t) {
  std::printf("{\"expression\": %s, \"formula\": %s, \"true\": %s, \"library\": %s",
              quoted(e.name).c_str(), quoted(e.formula).c_str(), quoted(decimals(t.value)).c_str(),
              quoted(L::name).c_str());
  if constexpr (static_cast<int>(Expression::needs) > static_cast<int>(L::has)) {
    std::printf(", \"verdict\": \"has no such function\"}\n");
  } else {
    double lo, hi;
    {
      [[maybe_unused]] const typename L::scope scope;
      const typename L::number r = e.template value<L>();
      lo = L::lower(r), hi = L::upper(r);
    }
    const double magnitude = std::fmax(std::fabs(t.lower), std::fabs(t.upper));
    const double ulp = std::nextafter(magnitude, INFINITY) - magnitude;
    std::printf(", \"lower\": %s, \"upper\": %s, \"verdict\": \"%s\"", hexadecimal(lo).c_str(),
                hexadecimal(hi).c_str(), worth(lo, hi, t));
    if (std::isfinite((hi - lo) / ulp) && t.value != 0)
      std::printf(", \"width_ulps\": %.4g", (hi - lo) / ulp);
    if (lo == hi && std::isfinite(lo)) // of a single number, where it is wrong
      std::printf(", \"error\": %.4g", error_of(lo, t));
    if constexpr (requires { e.start(); })
      std::printf(", \"proves\": %s",
                  e.start().first < lo && hi < e.start().second && lo < hi ? "true" : "false");
    std::printf("}\n");
  }
}

} // namespace

int main() {
  if (!graze::rounding::program_may_start("graze-hard-intervals"))
    return 2;
  const std::string inari = graze::bench::inari_library::get().missing();
  std::string missing = GRAZE_BENCH_MISSING;
  if (!inari.empty())
    missing.append("; inari (").append(inari).append(")");
  std::printf("{\"missing\": %s}\n",
              quoted(missing.starts_with("; ") ? missing.substr(2) : missing).c_str());
  for_each_expression([&](const auto& e) {
    const truth t = truth_of(e);
    evaluate<graze_intervals>(e, t);
    evaluate<plain>(e, t);
    evaluate<boost_intervals>(e, t);
#if defined(GRAZE_BENCH_MPFI)
    evaluate<mpfi_intervals>(e, t);
#endif
#if defined(GRAZE_BENCH_CGAL)
    evaluate<cgal_intervals>(e, t);
#endif
#if defined(GRAZE_BENCH_ARB)
    evaluate<arb_balls>(e, t);
#endif
    if (inari.empty())
      evaluate<inari_intervals>(e, t);
  });
  return 0;
}
