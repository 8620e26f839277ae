#pragma once
/// The planes of a grid's axis, by each rule that libraries have: plane k from an origin o, a spacing
/// s >= 0 and k. RN rounds to the nearest double, ties to even; RN32 to the nearest float.
///
/// By the machine's operations in its default mode, whatever the caller's; tests hold them against
/// MPFR. Finite o and s; a plane that is out of range is infinite or NaN.
#include <array>
#include <cstdint>

namespace graze::oracle {

/// A number as the sum of three doubles, not rounded.
using plane_terms = std::array<double, 3>;

/// o + k s, the real number.
plane_terms plane_exactly(double origin, double spacing, std::uint32_t k);
/// RN(o + k s).
double plane_rounded(double origin, double spacing, std::uint32_t k);
/// RN(o + RN(k s)).
double plane_multiplied(double origin, double spacing, std::uint32_t k);
/// The k-th of o, RN(o + s), RN(RN(o + s) + s), ... . Not step by step: within a binade all steps have
/// one length, once two after each other have.
double plane_added(double origin, double spacing, std::uint32_t k);
/// RN32(RN32(o) + RN32(RN32(k) RN32(s))).
double plane_binary32(double origin, double spacing, std::uint32_t k);

} // namespace graze::oracle
