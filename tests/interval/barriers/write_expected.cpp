// write_expected FILE: the bounds of every snippet by MPFR, as a C++ source. The judge's interval
// is a formula over corners that shares nothing with the operators under test.
#include "snippets.hpp"
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <graze/oracle/rounding.hpp>
#include <limits>

namespace {

using graze::oracle::mpfr;

/// A non-empty interval; division by one that holds zero and roots of negative numbers alone do not
/// occur.
class judged {
public:
  judged() : judged(0.0) {}
  judged(double x) : judged(x, x) {}
  judged(double lower, double upper) : lower_(lower), upper_(upper) {}
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }

  friend judged operator-(const judged& x) { return {-x.upper_, -x.lower_}; }
  friend judged operator+(const judged& x, const judged& y) {
    return {mpfr::add_down(x.lower_, y.lower_), mpfr::add_up(x.upper_, y.upper_)};
  }
  friend judged operator-(const judged& x, const judged& y) { return x + -y; }
  friend judged operator*(const judged& x, const judged& y) {
    return corners(x, y, mpfr::mul_down, mpfr::mul_up);
  }
  friend judged operator/(const judged& x, const judged& y) {
    if (y.lower_ <= 0 && y.upper_ >= 0)
      std::fprintf(stderr, "a snippet divides by zero\n"), std::exit(1);
    return corners(x, y, mpfr::div_down, mpfr::div_up);
  }
  friend judged square(const judged& x) {
    const double far = std::max(std::fabs(x.lower_), std::fabs(x.upper_));
    const double near = std::max({x.lower_, -x.upper_, 0.0});
    return {mpfr::mul_down(near, near), mpfr::mul_up(far, far)};
  }
  friend judged sqrt(const judged& x) {
    return {mpfr::sqrt_down(std::max(x.lower_, 0.0)), mpfr::sqrt_up(x.upper_)};
  }
  judged& operator+=(const judged& y) { return *this = *this + y; }
  judged& operator-=(const judged& y) { return *this = *this - y; }
  judged& operator*=(const judged& y) { return *this = *this * y; }
  judged& operator/=(const judged& y) { return *this = *this / y; }

private:
  using operation = double (*)(double, double);
  static judged corners(const judged& x, const judged& y, operation down, operation up) {
    judged r(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (const double a : {x.lower_, x.upper_})
      for (const double b : {y.lower_, y.upper_}) {
        r.lower_ = std::min(r.lower_, down(a, b));
        r.upper_ = std::max(r.upper_, up(a, b));
      }
    return r;
  }
  double lower_, upper_;
};

struct judge {
  using interval = judged;
  struct scope {
    scope() {}
  };
  static double sum_in_mode_down(double x, double y) { return mpfr::add_down(x, y); }
  static double sum_in_mode_up(double x, double y) { return mpfr::add_up(x, y); }
  static double other_product(double x, double y) { return x * y; }
  static double user_sum_rounded_up(double x, double y) { return x + y; }
  // 0.1 + 0.2; a test of the judge itself below
  static constexpr double constant_down() { return 0x1.3333333333333p-2; }
  static constexpr double constant_up() { return 0x1.3333333333334p-2; }
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_expected FILE\n");
    return 2;
  }
  if (mpfr::add_down(0.1, 0.2) != judge::constant_down() ||
      mpfr::add_up(0.1, 0.2) != judge::constant_up())
    return 1;
  std::FILE* file = std::fopen(argv[1], "w");
  if (file == nullptr) {
    std::fprintf(stderr, "cannot write %s\n", argv[1]);
    return 2;
  }
  std::fprintf(file, "// Written by write_expected: bounds by MPFR.\n#include \"expected.hpp\"\n"
                     "namespace graze::barriers {\nextern const bounds expected[] = {\n");
  std::size_t count = 0;
  const auto print = [&](double x) {
    if (std::isinf(x))
      std::fprintf(file, "%s__builtin_inf()", x < 0 ? "-" : "");
    else
      std::fprintf(file, "%a", x);
  };
  const auto write = [&](std::size_t, const char* name, const char* source, auto run) {
    const judged r = run();
    std::fprintf(file, "    {");
    print(r.lower());
    std::fprintf(file, ", ");
    print(r.upper());
    std::fprintf(file, "}, // %s %s\n", name, source);
    ++count;
  };
  graze::barriers::for_each_written<judge>(write);
  graze::barriers::for_each_crossed<judge>(write);
  std::fprintf(file, "};\nextern const std::size_t expected_count = %zu;\n}\n", count);
  return std::fclose(file) == 0 ? 0 : 2;
}
