#pragma once
/// What the rounding headers need of C++20 and have to do without in C++17: they serve
/// graze/boost_rounding.hpp, which is for both.

#if __cplusplus > 201703L
/// How a template names its backend.
#define GRAZE_BACKEND ::graze::rounding::Backend
#else
#define GRAZE_BACKEND class
#endif

namespace graze::rounding {

template <class To, class From> constexpr To bit_cast(const From& x) {
  return __builtin_bit_cast(To, x);
}
constexpr int leading_zeros(unsigned long x) { return __builtin_clzl(x); } ///< for x != 0

} // namespace graze::rounding
