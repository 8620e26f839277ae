#pragma once
/// MPFR's numbers as C++ objects, and a format's range of exponents.
#include <concepts>
#include <limits>
#include <mpfr.h>

namespace graze::oracle {

/// A number of MPFR's: a NaN of so many bits (53 hold every double), or a double.
class number {
public:
  number() : number(53) {}
  explicit number(std::integral auto bits) { mpfr_init2(value_, bits); }
  explicit number(std::same_as<double> auto x) : number() { mpfr_set_d(value_, x, MPFR_RNDN); }
  ~number() { mpfr_clear(value_); }
  number(const number&) = delete;
  number& operator=(const number&) = delete;
  operator mpfr_ptr() { return value_; }

private:
  mpfr_t value_;
};

/// The exponent range of a format (double: binary64; float: binary32) in MPFR's terms
/// (significands in [1/2, 1)), for the object's life: the least positive double 2^-1074 has
/// exponent -1073, the largest finite one 1024. The caller's range is restored.
template <std::floating_point Number> class range_of {
public:
  range_of() : emin_(mpfr_get_emin()), emax_(mpfr_get_emax()) {
    mpfr_set_emin(limits::min_exponent - limits::digits + 1);
    mpfr_set_emax(limits::max_exponent);
  }
  ~range_of() {
    mpfr_set_emin(emin_);
    mpfr_set_emax(emax_);
  }
  range_of(const range_of&) = delete;
  range_of& operator=(const range_of&) = delete;

private:
  using limits = std::numeric_limits<Number>;
  mpfr_exp_t emin_, emax_;
};
using binary64_range = range_of<double>;

} // namespace graze::oracle
