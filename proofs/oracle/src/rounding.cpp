#include <graze/oracle/rounding.hpp>
#include <mpfr.h>

namespace graze::oracle {
namespace {

/// One 53-bit register; MPFR's storage is taken once a thread.
class value {
public:
  value() { mpfr_init2(number_, 53); }
  ~value() { mpfr_clear(number_); }
  value(const value&) = delete;
  value& operator=(const value&) = delete;
  operator mpfr_ptr() { return number_; }

private:
  mpfr_t number_;
};

/// The exponent range of binary64 in MPFR's terms (significands in [1/2, 1)): the least positive
/// number 2^-1074 has exponent -1073, the largest finite one 1024. Restored at the end, for the
/// caller's own MPFR computations.
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

template <class Operation> double rounded(Operation operation, double x, double y, mpfr_rnd_t to) {
  thread_local value a, b, result;
  const binary64_range range;
  mpfr_set_d(a, x, MPFR_RNDN); // exact
  mpfr_set_d(b, y, MPFR_RNDN);
  const int ternary = operation(result, a, b, to);
  mpfr_subnormalize(result, ternary, to);
  return mpfr_get_d(result, to); // exact
}

int square_root(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr, mpfr_rnd_t to) {
  return mpfr_sqrt(result, x, to);
}

} // namespace

double mpfr::add_down(double x, double y) { return rounded(mpfr_add, x, y, MPFR_RNDD); }
double mpfr::add_up(double x, double y) { return rounded(mpfr_add, x, y, MPFR_RNDU); }
double mpfr::sub_down(double x, double y) { return rounded(mpfr_sub, x, y, MPFR_RNDD); }
double mpfr::sub_up(double x, double y) { return rounded(mpfr_sub, x, y, MPFR_RNDU); }
double mpfr::mul_down(double x, double y) { return rounded(mpfr_mul, x, y, MPFR_RNDD); }
double mpfr::mul_up(double x, double y) { return rounded(mpfr_mul, x, y, MPFR_RNDU); }
double mpfr::div_down(double x, double y) { return rounded(mpfr_div, x, y, MPFR_RNDD); }
double mpfr::div_up(double x, double y) { return rounded(mpfr_div, x, y, MPFR_RNDU); }
double mpfr::sqrt_down(double x) { return rounded(square_root, x, 0, MPFR_RNDD); }
double mpfr::sqrt_up(double x) { return rounded(square_root, x, 0, MPFR_RNDU); }

} // namespace graze::oracle
