#include "elementary_functions.hpp"
#include <filesystem>
#include <fstream>
#include <graze/oracle/elementary.hpp>
#include <graze/point.hpp>
#include <iterator>
#include <regex>

namespace graze::test {
namespace {

#define GRAZE_UNARY(name, core_math, lo, hi)                                                       \
  unary { #name, point::name##_down, point::name##_up, mpfr_##core_math, {lo, hi}, #core_math }
const unary one_argument[] = {
    GRAZE_UNARY(exp, exp, -0x1.74910d52d3051p+9, 0x1.62e42fefa39efp+9),
    GRAZE_UNARY(exp2, exp2, -1075, 1024),
    GRAZE_UNARY(exp10, exp10, -0x1.439b746e36b52p+8, 0x1.34413509f79ffp+8),
    GRAZE_UNARY(expm1, expm1, -0x1.25e4f7b2737fap+5, 0x1.62e42fefa39efp+9),
    GRAZE_UNARY(log, log, 0, 10),
    GRAZE_UNARY(log2, log2, 0, 10),
    GRAZE_UNARY(log10, log10, 0, 10),
    GRAZE_UNARY(logp1, log1p, -1, 10),
    GRAZE_UNARY(sin, sin, -20, 20),
    GRAZE_UNARY(cos, cos, -20, 20),
    GRAZE_UNARY(tan, tan, -20, 20),
    GRAZE_UNARY(asin, asin, -1, 1),
    GRAZE_UNARY(acos, acos, -1, 1),
    GRAZE_UNARY(atan, atan, -20, 20),
    GRAZE_UNARY(sinh, sinh, -0x1.633ce8fb9f87dp+9, 0x1.633ce8fb9f87dp+9),
    GRAZE_UNARY(cosh, cosh, -0x1.633ce8fb9f87dp+9, 0x1.633ce8fb9f87dp+9),
    GRAZE_UNARY(tanh, tanh, -0x1.30fc1931f09cap+4, 0x1.30fc1931f09cap+4),
    GRAZE_UNARY(asinh, asinh, -20, 20),
    GRAZE_UNARY(acosh, acosh, 1, 20),
    GRAZE_UNARY(atanh, atanh, -1, 1),
    GRAZE_UNARY(cbrt, cbrt, -20, 20),
};

const binary two_arguments[] = {
    {"atan2", point::atan2_down, point::atan2_up, mpfr_atan2},
    {"hypot", point::hypot_down, point::hypot_up, mpfr_hypot},
    {"pow", point::pow_down, point::pow_up, mpfr_pow},
};

} // namespace

std::span<const unary> unary_functions() { return one_argument; }
std::span<const binary> binary_functions() { return two_arguments; }

std::vector<double> literals_of(const std::string& function) {
  std::vector<double> found;
  const std::filesystem::path folder =
      std::filesystem::path(GRAZE_CORE_MATH_DIR) / "src" / "binary64" / function;
  for (const std::string& name : {function + ".c", std::string("check_special.c")}) {
    std::ifstream file(folder / name);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    static const std::regex literal("0x[0-9a-fA-F]*\\.?[0-9a-fA-F]*p[-+]?[0-9]+");
    for (std::sregex_iterator each(text.begin(), text.end(), literal), end; each != end; ++each) {
      const double x = std::strtod(each->str().c_str(), nullptr);
      if (std::isfinite(x))
        found.push_back(x);
    }
  }
  return found;
}

} // namespace graze::test
