#pragma once
/// graze::policies<Backend>: bounds that hold for boost::numeric::interval<double, ...>.
#include <graze/needs_cxx20.hpp>

#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/rounding.hpp>
#include <concepts>
#include <graze/boost_rounding.hpp>
#include <graze/checking.hpp>

namespace graze {

/// How intervals compare whose policies name it: by what is certain (graze/comparison.hpp).
struct certain_comparison {};

/// Rounding, checking and comparison of ours, for Boost's class:
/// boost::numeric::interval<double, graze::policies<>>. Boost's policies are its base so that Boost's
/// explicit comparisons (cerlt, poslt, ...) are found without their namespace.
template <rounding::Backend B = rounding::nearest>
struct policies : boost::numeric::interval_lib::policies<boost_rounding<B>, checking> {
  using comparison = certain_comparison;
  using backend = B;
};

/// Policies whose intervals are sets of real numbers as `checking` has it: ours, and what Boost's
/// change_rounding and unprotect make of them.
template <class P>
concept Policies = std::same_as<typename P::checking, checking>;

/// What the bounds of intervals may be.
template <class N>
concept Real = std::same_as<N, double> || std::same_as<N, float>;

template <Policies P, Real N = double> using interval_of = boost::numeric::interval<N, P>;

} // namespace graze
