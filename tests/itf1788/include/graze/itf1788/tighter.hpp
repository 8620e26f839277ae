#pragma once
/// The proof that a tighter result than the stated one is right.
///
/// Statements about reverse operations come from libraries whose results are enclosures, now and
/// then one ulp wider than the tightest. Where Graze's result lies strictly within the stated one,
/// MPFR shows that what it leaves out holds no solution.
#include <graze/itf1788/syntax.hpp>

namespace graze::itf1788 {

/// Whether `got` lies within `stated`, has the same decoration, and no point of `stated` outside of
/// `got` solves the statement: no t with f(t) in c (operand 0), for pown_rev, sin_rev, cos_rev,
/// tan_rev; no t with u^t in c (operand 1) for a u in b (operand 0), b within (0, 1], for pow_rev2.
/// False where that cannot be shown, and for every other operation. Of each piece left out, f is
/// known to be strictly monotone on it and its values at both ends, computed with 300 bits and
/// rounded towards c, to be on the same side of c; the end that `got` holds may meet the bound of
/// c.
bool proved_tighter(const statement& s, const value& stated, const value& got);

} // namespace graze::itf1788
