#pragma once
/// The directed point functions, with MPFR's of the same value and where they are of interest.
#include <graze/oracle/hard_arguments.hpp>
#include <mpfr.h>
#include <span>
#include <vector>

namespace graze::test {

struct unary {
  const char* name;
  double (*down)(double);
  double (*up)(double);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  oracle::active_range active;
  const char* core_math; ///< its name there, without cr_
};
struct binary {
  const char* name;
  double (*down)(double, double);
  double (*up)(double, double);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
};

std::span<const unary> unary_functions();
std::span<const binary> binary_functions();

/// Every hexadecimal floating-point literal of a function's source files in CORE-MATH that is a
/// double: among them the exceptional cases that its fast evaluations do not decide.
std::vector<double> literals_of(const std::string& function);

inline double nearly_a_double(const unary& f, double x) {
  return oracle::nearly_a_double(f.exact, x);
}

} // namespace graze::test
