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

/// Beside x, on a step of doubles where f is nearly linear, the argument whose value is nearest to
/// a double but not equal: 2^-14 of an ulp off, or less. There the first, fast evaluation of a
/// correctly rounded function cannot decide.
double nearly_a_double(const unary& f, double x);

} // namespace graze::test
