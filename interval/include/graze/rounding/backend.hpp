#pragma once
/// What a backend of directed rounding is.
#include <graze/rounding/standard.hpp>
#if __cplusplus > 201703L
#include <concepts>
#endif

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "graze: -ffast-math (or a part of it) breaks every bound; compile without it"
#endif

namespace graze::rounding {

/// A set of directed operations. Each returns the correctly rounded result of the exact operation
/// on every input, bit for bit the same in every backend, signed zeros included (a NaN is a NaN,
/// its payload is not specified). `number` is double for every shipped backend; the exhaustive
/// tests use a tiny float. `scope` sets the modes that the operations need and restores, at its
/// end, exactly what it found; the operations may be called only while a scope of the same backend
/// lives.
#if __cplusplus > 201703L
template <class B>
concept Backend = requires(typename B::number x) {
  typename B::scope;
  { B::name } -> std::convertible_to<const char*>;
  { B::add_down(x, x) } -> std::same_as<typename B::number>;
  { B::add_up(x, x) } -> std::same_as<typename B::number>;
  { B::sub_down(x, x) } -> std::same_as<typename B::number>;
  { B::sub_up(x, x) } -> std::same_as<typename B::number>;
  { B::mul_down(x, x) } -> std::same_as<typename B::number>;
  { B::mul_up(x, x) } -> std::same_as<typename B::number>;
  { B::div_down(x, x) } -> std::same_as<typename B::number>;
  { B::div_up(x, x) } -> std::same_as<typename B::number>;
  { B::sqrt_down(x) } -> std::same_as<typename B::number>;
  { B::sqrt_up(x) } -> std::same_as<typename B::number>;
};
#endif

} // namespace graze::rounding
