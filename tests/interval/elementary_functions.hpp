#pragma once
/// The directed point functions, with MPFR's of the same value and where they are of interest.
#include "elementary_arguments.hpp"
#include <mpfr.h>
#include <span>

namespace graze::test {

struct unary {
  const char* name;
  double (*down)(double);
  double (*up)(double);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  active_range active;
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

} // namespace graze::test
