#include <graze/oracle/mpfr_number.hpp>
#include <graze/oracle/rounding.hpp>

namespace graze::oracle {
namespace {

template <class Operation> double rounded(Operation operation, double x, double y, mpfr_rnd_t to) {
  thread_local number a, b, result; // MPFR's storage is taken once a thread
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
