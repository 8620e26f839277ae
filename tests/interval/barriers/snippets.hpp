#pragma once
/// Snippets of user code around intervals in which an optimizer could break a bound. Each is a
/// template over a context C, which has `interval` and a `scope` that its operations need, and
/// returns an interval; the judge's context says which. Each appears with its name in `written`.
#include "crossed.hpp"
#include <array>
#include <iterator>

namespace graze::barriers {

double far_literal();               // far.cpp: known to an optimizer that sees the whole program
double far_product(double, double); // plain arithmetic there

template <class C> struct written {
  using I = typename C::interval;
  using scope = typename C::scope;

  static I loop_sum() {
    const scope s;
    I r = 0.0;
    for (int i = 0; i < 10; ++i)
      r = r + I(0.1);
    return r;
  }
  static I loop_sum_of_invariant_product() {
    const scope s;
    const double x = unknown(0.1), y = unknown(0.7);
    I r = 0.0;
    for (int i = 0, n = static_cast<int>(unknown(9)); i < n; ++i)
      r = r + I(x) * I(y);
    return r;
  }
  static I multiple_of_counter() { // strength reduction
    const scope s;
    I r = 0.0;
    for (int i = 0; i < 9; ++i)
      r = I(static_cast<double>(i)) * I(0.1) + r / I(3.0);
    return r;
  }
  static I array_kernel() { // a loop that would be vectorised
    std::array<double, 16> x{}, y{};
    for (std::size_t i = 0; i < 16; ++i)
      x[i] = 0.1 * static_cast<double>(i), y[i] = 1 / (1 + x[i]);
    const scope s;
    std::array<I, 16> z{};
    for (std::size_t i = 0; i < 16; ++i)
      z[i] = I(x[i]) * I(y[i]) + I(x[i]);
    I r = 0.0;
    for (const I& t : z)
      r = r + t;
    return r;
  }
  static I plain_array_beside() { // the same, with the user's own kernel on the same operands
    std::array<double, 16> x{}, y{}, own{};
    for (std::size_t i = 0; i < 16; ++i)
      x[i] = 0.1 * static_cast<double>(i), y[i] = 1 / (1 + x[i]);
    for (std::size_t i = 0; i < 16; ++i)
      own[i] = x[i] * y[i] + x[i];
    for (const double t : own)
      keep(t);
    const scope s;
    I r = 0.0;
    for (std::size_t i = 0; i < 16; ++i)
      r = r + (I(x[i]) * I(y[i]) + I(x[i]));
    return r;
  }
  static I horner() {
    const scope s;
    constexpr double coefficients[] = {0.1, -0.7, 1.3, 0.9, -2.1};
    const I x = 0.3;
    I r = 0.0;
    for (const double c : coefficients)
      r = r * x + I(c);
    return r;
  }
  static I multiply_by_two() {
    const scope s;
    return I(0.1) * I(2.0) + I(0.1) * I(3.0);
  }
  static I neutral_elements() {
    const scope s;
    const I x = I(1.0) / I(3.0);
    return (x + I(0.0)) * I(1.0) / I(1.0) - I(0.0) + I(-0.0);
  }
  static I divide_by_power_of_two() {
    const scope s;
    return I(0x1.0000000000001p-1022) / I(4.0) + I(0x1p-1074) / I(2.0);
  }
  static I divide_by_constant() { // as a product with the reciprocal
    const scope s;
    return I(unknown(7.0)) / I(10.0) + I(unknown(5.0)) / I(3.0);
  }
  static I cancel() { // (x + y) - x is not y
    const scope s;
    const I x = 0x1p60, y = 0.1;
    return (x + y) - x;
  }
  static I minus_itself() {
    const scope s;
    const I x = I(1.0) / I(3.0);
    return x - x;
  }
  static I over_itself() {
    const scope s;
    const I x = I(1.0) / I(3.0);
    return x / x;
  }
  static I both_differences() {
    const scope s;
    const I x = 0.3, y = 1e17;
    const I a = x - y, b = y - x;
    return a * b;
  }
  static I third_twice() {
    const double third = 1.0 / 3;
    keep(third);
    const scope s;
    const I r = I(1.0) / I(3.0);
    keep(1.0 / 3);
    return r - I(third);
  }
  static I fused() { // (1 + 2^-52)^2 - (1 + 2^-51) is 2^-104; each operation rounded: [0, 2^-52]
    const scope s;
    const double x = unknown(0x1.0000000000001p+0);
    return I(x) * I(x) - I(0x1.0000000000002p+0);
  }
  static I fused_with_user() {
    const double x = unknown(0x1.0000000000001p+0), z = unknown(0.1);
    keep(x * x + z);
    const scope s;
    const I r = I(x) * I(x);
    return r + I(z);
  }
  static I dot_product() {
    const scope s;
    const std::array<double, 5> x{0.1, 1e16, -0.7, 1e-300, 3.3}, y{0.9, 0.3, 1e16, 1e-20, -1.1};
    I r = 0.0;
    for (std::size_t i = 0; i < 5; ++i)
      r = r + I(x[i]) * I(y[i]);
    return r;
  }
  static I compound_assignment() {
    const scope s;
    I r = 0.1;
    r += I(0.7);
    r *= I(0.3);
    r -= I(1.1);
    r /= I(0.9);
    return r;
  }
  static I onto_itself() {
    const scope s;
    I r = I(1.0) / I(3.0);
    r += r;
    r *= r;
    r -= I(0.1) * r;
    return r;
  }
  static I mixed_with_numbers() {
    const scope s;
    return (0.1 * I(0.7) + 0.3) / 1.1 - 2.3 * (I(0.9) - 0.1);
  }
  static I wide() {
    const scope s;
    const I x(-0.1, 0.7), y(0.3, 1.1);
    return x * y - y / (y + x * x);
  }
  static I wide_mixed_signs() {
    const scope s;
    const I x(-0.1, 0.7), y(-1.3, 0.9);
    return (x * y) * (x - y);
  }
  static I wide_square() {
    const scope s;
    return square(I(-0.1, 0.7)) + square(I(-0.9, -0.3)) + square(I(0.1, 1.3));
  }
  static I wide_root() {
    const scope s;
    return sqrt(I(0.1, 0.7)) * sqrt(I(-1.0, 2.0));
  }
  static I unbounded() {
    const scope s;
    return I(1.0) / (I(0.1) * I(1.0) + I(0x1p1023, 0x1.8p1023) * I(0.1, 4.0));
  }
  static I overflow() {
    const scope s;
    return I(0x1.fffffffffffffp1023) + I(0x1p969);
  }
  static I underflow() {
    const scope s;
    return I(0x1p-600) * I(0x1.8p-500) * I(-0.1);
  }
  static I subnormal_then_large() { // an x87 register would keep bits that a double drops
    const scope s;
    return I(0x1p-600) * I(1.5) * I(0x1p-500) * I(0x1p80);
  }
  static I selected() {
    const scope s;
    const double x = unknown(0.1);
    return x < 0.5 ? I(x) + I(0.7) : I(x) - I(0.7);
  }
  static I both_branches_alike() {
    const scope s;
    const double x = unknown(0.1);
    I r = 0.0;
    if (unknown(1) > 0) {
      r = I(x) * I(0.7);
      keep(x * 0.7);
    } else {
      r = I(x) * I(0.7);
    }
    return r;
  }
  static I switched() {
    const scope s;
    I r = 0.0;
    for (int i = 0; i < 4; ++i)
      switch (i) {
      case 0:
        r = I(0.1) + I(0.2);
        break;
      case 1:
        r = r - I(0.3);
        break;
      default:
        r = r * I(0.1) + I(0.1);
      }
    return r;
  }
  static I early_exit() {
    const scope s;
    I r = 1.0;
    for (int i = 1; i < 50; ++i) {
      r = r / I(3.0);
      if (r.upper() < 0x1p-20)
        break;
    }
    return r;
  }
  [[gnu::noinline]] static I out_of_line_product(const I& x, const I& y) { return x * y; }
  static I out_of_line() {
    const scope s;
    return out_of_line_product(0.1, 0.7) + out_of_line_product(0.3, 0.9);
  }
  static I recursive_sum(int n) { return n == 0 ? I(0.1) : recursive_sum(n - 1) / I(3.0) + I(0.7); }
  static I recursion() {
    const scope s;
    return recursive_sum(6);
  }
  static I pointer_to_function() {
    const scope s;
    I (*volatile f)(const I&, const I&) = &out_of_line_product;
    return f(1.1, 0.7) - f(1.1, 0.3);
  }
  static I far_operands() { // a whole program's optimizer sees the literal
    const scope s;
    return I(far_literal()) + I(0.7);
  }
  static I far_common_subexpression() {
    const double x = far_literal(), y = 0.7;
    keep(far_product(x, y));
    const scope s;
    return I(x) * I(y);
  }
  static I function_static() {
    const scope s;
    static const I tenth = I(1.0) / I(10.0);
    return tenth * I(3.0);
  }
  static I static_table() {
    const scope s;
    static const std::array<I, 3> table{I(0.1) + I(0.2), I(0.1) - I(0.7), I(1.0) / I(7.0)};
    return table[0] * table[1] + table[2];
  }
  static I copied_bytes() {
    const scope s;
    I a = I(0.1) + I(0.2), b = 0.0;
    const double lower = a.lower(), upper = a.upper();
    b = I(lower, upper);
    return b + a;
  }
  static I ends_recombined() { // bounds that the optimizer has in its hands
    const scope s;
    const I a = I(0.1) * I(0.7), b = I(0.3) * I(0.9);
    return I(a.lower(), b.upper()) * I(-b.upper(), a.upper());
  }

  // changes of mode

  static I scope_in_a_loop() {
    const double x = unknown(0.1), y = unknown(0.7);
    I r = 0.0;
    for (int i = 0; i < 3; ++i) {
      keep(x * y + kept);
      const scope s;
      r = I(x) * I(y); // the same in each turn
    }
    keep(x * y);
    return r;
  }
  static I scope_in_a_branch() {
    const double x = unknown(0.1), y = unknown(0.7);
    I r = 0.0;
    if (unknown(2) > 1) {
      const scope s;
      r = I(x) / I(y);
    } else {
      keep(x / y);
    }
    keep(x / y);
    return r;
  }
  static I two_scopes_alike() { // the plain sum between them is in round to nearest
    const double x = unknown(0.1), y = unknown(0.7);
    I a = 0.0, b = 0.0;
    {
      const scope s;
      a = I(x) + I(y);
    }
    keep(x + y);
    {
      const scope s;
      b = I(x) + I(y);
      b = b - a;
    }
    return b;
  }
  static I nested_scopes() {
    const scope outer;
    const I a = I(0.1) * I(0.7);
    I b = 0.0;
    {
      const scope inner;
      b = I(0.1) * I(0.7);
    }
    return a - b + I(0.1) / I(0.7);
  }
  static I down_and_up_by_hand() { // one instruction, one pair of operands, two modes
    const double x = unknown(0.1), y = unknown(0.7);
    const double down = C::sum_in_mode_down(x, y), up = C::sum_in_mode_up(x, y);
    return I(down, up);
  }
  static I down_and_up_of_constants() {
    const double down = C::sum_in_mode_down(0.1, 0.7), up = C::sum_in_mode_up(0.1, 0.7);
    keep(0.1 + 0.7);
    return I(down, up);
  }
  static I other_backend_between() {
    const double x = unknown(0.1), y = unknown(0.7);
    const scope s;
    const I a = I(x) * I(y);
    keep(C::other_product(x, y));
    const I b = I(x) * I(y);
    return a + b;
  }
  static I user_changes_mode_before() { // and puts it back, by the C library
    const double x = unknown(0.1), y = unknown(0.7);
    keep(C::user_sum_rounded_up(x, y));
    const scope s;
    return I(x) + I(y);
  }
  static I constant_expression() { // rounded by the compiler
    constexpr double down = C::constant_down(), up = C::constant_up();
    const scope s;
    return I(down, up) * I(0.3);
  }
  static I result_used_by_plain_code() {
    I r = 0.0;
    {
      const scope s;
      r = I(0.1) * I(0.7);
    }
    keep(r.lower() * 3 + r.upper());
    keep(r.lower() + 0.1);
    return r;
  }

  struct named {
    const char* name;
    I (*run)();
  };
#define GRAZE_SNIPPET(function)                                                                    \
  named { #function, &written::function }
  static constexpr named all[] = {
      GRAZE_SNIPPET(loop_sum),
      GRAZE_SNIPPET(loop_sum_of_invariant_product),
      GRAZE_SNIPPET(multiple_of_counter),
      GRAZE_SNIPPET(array_kernel),
      GRAZE_SNIPPET(plain_array_beside),
      GRAZE_SNIPPET(horner),
      GRAZE_SNIPPET(multiply_by_two),
      GRAZE_SNIPPET(neutral_elements),
      GRAZE_SNIPPET(divide_by_power_of_two),
      GRAZE_SNIPPET(divide_by_constant),
      GRAZE_SNIPPET(cancel),
      GRAZE_SNIPPET(minus_itself),
      GRAZE_SNIPPET(over_itself),
      GRAZE_SNIPPET(both_differences),
      GRAZE_SNIPPET(third_twice),
      GRAZE_SNIPPET(fused),
      GRAZE_SNIPPET(fused_with_user),
      GRAZE_SNIPPET(dot_product),
      GRAZE_SNIPPET(compound_assignment),
      GRAZE_SNIPPET(onto_itself),
      GRAZE_SNIPPET(mixed_with_numbers),
      GRAZE_SNIPPET(wide),
      GRAZE_SNIPPET(wide_mixed_signs),
      GRAZE_SNIPPET(wide_square),
      GRAZE_SNIPPET(wide_root),
      GRAZE_SNIPPET(unbounded),
      GRAZE_SNIPPET(overflow),
      GRAZE_SNIPPET(underflow),
      GRAZE_SNIPPET(subnormal_then_large),
      GRAZE_SNIPPET(selected),
      GRAZE_SNIPPET(both_branches_alike),
      GRAZE_SNIPPET(switched),
      GRAZE_SNIPPET(early_exit),
      GRAZE_SNIPPET(out_of_line),
      GRAZE_SNIPPET(recursion),
      GRAZE_SNIPPET(pointer_to_function),
      GRAZE_SNIPPET(far_operands),
      GRAZE_SNIPPET(far_common_subexpression),
      GRAZE_SNIPPET(function_static),
      GRAZE_SNIPPET(static_table),
      GRAZE_SNIPPET(copied_bytes),
      GRAZE_SNIPPET(ends_recombined),
      GRAZE_SNIPPET(scope_in_a_loop),
      GRAZE_SNIPPET(scope_in_a_branch),
      GRAZE_SNIPPET(two_scopes_alike),
      GRAZE_SNIPPET(nested_scopes),
      GRAZE_SNIPPET(down_and_up_by_hand),
      GRAZE_SNIPPET(down_and_up_of_constants),
      GRAZE_SNIPPET(other_backend_between),
      GRAZE_SNIPPET(user_changes_mode_before),
      GRAZE_SNIPPET(constant_expression),
      GRAZE_SNIPPET(result_used_by_plain_code),
  };
#undef GRAZE_SNIPPET
};

/// Calls f(index, name, source, function) for the snippets above in the context C.
template <class C, class F> void for_each_written(F f) {
  std::size_t index = 0;
  for (const auto& s : written<C>::all)
    f(index++, s.name, "", s.run);
}
/// The same for the crossed ones, which follow.
template <class C, class F> void for_each_crossed(F f) {
  std::size_t index = std::size(written<C>::all);
  const auto of_source = [&]<class Source>(Source) {
    const auto of_operation = [&]<class... Operation>(std::tuple<Operation...>) {
      (f(index++, Operation::name, Source::name, &crossed<C, Operation, Source>), ...);
    };
    of_operation(operations{});
  };
  const auto of_sources = [&]<class... Source>(std::tuple<Source...>) {
    (of_source(Source{}), ...);
  };
  of_sources(sources{});
}

} // namespace graze::barriers
