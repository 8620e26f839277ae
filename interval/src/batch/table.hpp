#pragma once
/// What the dispatcher and the paths' files have in common. No code: this file is compiled with the
/// flags of each.
#include <cstddef>
#include <cstdint>
#include <graze/batch/per_path.hpp>

namespace graze::batch::detail {

/// Arrays of ends, or, with hi unused, one array of pairs.
struct source {
  const double *lo, *hi;
};
struct target {
  double *lo, *hi;
};
struct pair {
  double lo, hi;
};

enum unary { op_neg, op_sqr, op_sqrt, op_abs, unary_count };
enum binary {
  op_add,
  op_sub,
  op_mul,
  op_div,
  op_min,
  op_max,
  op_intersection,
  op_hull,
  binary_count
};
enum unary_predicate { op_contains_zero, op_is_empty, unary_predicate_count };
enum binary_predicate {
  op_certainly_less,
  op_certainly_less_equal,
  op_equal,
  op_subset,
  op_overlaps,
  binary_predicate_count
};

using unary_kernel = void (*)(std::size_t n, target r, source x);
using binary_kernel = void (*)(std::size_t n, target r, source x, source y);
using ternary_kernel = void (*)(std::size_t n, target r, source x, source y, source z);

/// The kernels of a path.
struct table {
  unary_kernel arrays_unary[unary_count], pairs_unary[unary_count];
  binary_kernel arrays_binary[binary_count], pairs_binary[binary_count];
  ternary_kernel arrays_fma, pairs_fma;
  void (*unary_predicates[unary_predicate_count])(std::size_t n, std::uint8_t* r, source x);
  void (*binary_predicates[binary_predicate_count])(std::size_t n, std::uint8_t* r, source x,
                                                    source y);
  void (*biquadratic)(std::size_t n, target r, source x, source y, source z, pair s, pair c);
  void (*horner)(std::size_t n, target r, source x, const pair* coefficients, std::size_t count);
};

GRAZE_DECLARE_ON_PATHS(table, kernels);

} // namespace graze::batch::detail
