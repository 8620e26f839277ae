#pragma once
/// MPFR's numbers as C++ objects, and binary64's range of exponents.
#include <concepts>
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

/// The exponent range of binary64 in MPFR's terms (significands in [1/2, 1)), for the object's
/// life: the least positive number 2^-1074 has exponent -1073, the largest finite one 1024. The
/// caller's range is restored.
class binary64_range {
public:
  binary64_range() : emin_(mpfr_get_emin()), emax_(mpfr_get_emax()) {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
  }
  ~binary64_range() {
    mpfr_set_emin(emin_);
    mpfr_set_emax(emax_);
  }
  binary64_range(const binary64_range&) = delete;
  binary64_range& operator=(const binary64_range&) = delete;

private:
  mpfr_exp_t emin_, emax_;
};

} // namespace graze::oracle
