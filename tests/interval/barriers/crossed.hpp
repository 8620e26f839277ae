#pragma once
/// Snippets made of an operation and of a way in which the optimizer gets to know its operands.
#include <cstddef>
#include <tuple>

namespace graze::barriers {

/// What user code does with its own numbers; the optimizer must believe that it is needed.
inline volatile double kept;
inline void keep(double x) { kept = x; }

/// A number that the optimizer does not know.
inline double unknown(double x) {
  volatile double v = x;
  return v;
}

struct sum {
  static constexpr const char* name = "x + y";
  template <class N> N operator()(const N& x, const N& y) const { return x + y; }
};
struct difference {
  static constexpr const char* name = "x - y";
  template <class N> N operator()(const N& x, const N& y) const { return x - y; }
};
struct reverse_difference {
  static constexpr const char* name = "-(y - x)";
  template <class N> N operator()(const N& x, const N& y) const { return -(y - x); }
};
struct product {
  static constexpr const char* name = "x * y";
  template <class N> N operator()(const N& x, const N& y) const { return x * y; }
};
struct quotient {
  static constexpr const char* name = "x / y";
  template <class N> N operator()(const N& x, const N& y) const { return x / y; }
};
struct product_and_sum { // what -ffp-contract=fast would like to fuse
  static constexpr const char* name = "x * y + x";
  template <class N> N operator()(const N& x, const N& y) const { return x * y + x; }
};
struct root {
  static constexpr const char* name = "sqrt(x * x + y)";
  template <class N> N operator()(const N& x, const N& y) const { return sqrt(x * x + y); }
};
struct power {
  static constexpr const char* name = "square(square(x) - y)";
  template <class N> N operator()(const N& x, const N& y) const { return square(square(x) - y); }
};
using operations = std::tuple<sum, difference, reverse_difference, product, quotient,
                              product_and_sum, root, power>;

// The ways. Each calls f with two doubles, in a scope. The numbers are such that every operation
// above rounds; what makes them is exact or done at compile time, the same in every mode.
struct literals {
  static constexpr const char* name = "literals";
  template <class F> static auto with(F f) { return f(0.7, 0.1); }
};
struct folded {
  static constexpr const char* name = "folded expressions";
  template <class F> static auto with(F f) {
    constexpr double x = 1.0 / 3, y = x / 7 + 0.05;
    return f(x, y);
  }
};
struct constants {
  static constexpr const char* name = "constexpr variables";
  static constexpr double table[] = {0.1, 1.0 / 7, 1.9};
  template <class F> static auto with(F f) { return f(table[2], table[1]); }
};
struct template_arguments {
  static constexpr const char* name = "template arguments";
  template <double x, double y, class F> static auto inner(F f) { return f(x, y); }
  template <class F> static auto with(F f) { return inner<1.1, 0.3>(f); }
};
struct one_unknown {
  static constexpr const char* name = "one unknown";
  template <class F> static auto with(F f) { return f(unknown(2.6), 0.3); }
};
struct known_after_a_test {
  static constexpr const char* name = "known after a test";
  template <class F> static auto with(F f) {
    const double x = unknown(1.3), y = unknown(0.9);
    return x == 1.3 && y == 0.9 ? f(x, y) : f(y, x);
  }
};
struct shared_with_user {
  static constexpr const char* name = "shared with plain arithmetic before";
  template <class F> static auto with(F f) {
    const double x = unknown(0.3), y = unknown(0.1);
    keep(x + y), keep(x - y), keep(x * y), keep(x / y), keep(y - x);
    keep(__builtin_sqrt(x * x + y));
    return f(x, y);
  }
};
struct shared_with_user_after {
  static constexpr const char* name = "shared with plain arithmetic before and after, known";
  template <class F> static auto with(F f) {
    const double x = 1.7, y = 0.3;
    double s = x + y, d = x - y, p = x * y, q = x / y;
    const auto r = f(x, y);
    keep(s), keep(d), keep(p), keep(q), keep(__builtin_sqrt(x * x + y)), keep(-(y - x));
    return r;
  }
};
struct hoisted {
  static constexpr const char* name = "the same in every turn of a loop";
  template <class F> static auto with(F f) {
    const double x = unknown(2.3), y = 0.7;
    auto r = f(x, y);
    for (int i = 0, n = static_cast<int>(unknown(5)); i < n; ++i) {
      keep(x * y + kept);
      r = f(x, y);
    }
    return r;
  }
};
struct induction {
  static constexpr const char* name = "from a loop's counter";
  template <class F> static auto with(F f) {
    constexpr double table[] = {0.1, 0.7, 1.0 / 3, 1.9, 0.3};
    auto r = f(0.7, 0.1);
    for (int i = 1; i < 4; ++i)
      r = f(table[i] * 2, table[i + 1] * 0.25);
    return r;
  }
};
struct captured {
  static constexpr const char* name = "captured by a lambda";
  template <class F> static auto with(F f) {
    const double x = 3.3;
    const auto with_half = [=](double y) { return [=] { return f(x / 2, y); }; };
    return with_half(0.1)();
  }
};
struct members {
  static constexpr const char* name = "members of a structure";
  struct point {
    double x = 0.1, y = 0.7;
    template <class F> auto apply(F f) const { return f(y, x); }
  };
  template <class F> static auto with(F f) {
    point p;
    p.x *= 4;
    return p.apply(f);
  }
};
using sources =
    std::tuple<literals, folded, constants, template_arguments, one_unknown, known_after_a_test,
               shared_with_user, shared_with_user_after, hoisted, induction, captured, members>;

inline constexpr std::size_t crossed_count =
    std::tuple_size_v<operations> * std::tuple_size_v<sources>;

/// C is a context (snippets.hpp).
template <class C, class Operation, class Source> typename C::interval crossed() {
  [[maybe_unused]] const typename C::scope scope;
  using I = typename C::interval;
  return Source::with([](double x, double y) { return Operation{}(I(x), I(y)); });
}

} // namespace graze::barriers
