#pragma once
/// Constructors of IEEE 1788.1. Nothing throws: the standard's exceptions are told with the value.
#include <graze/needs_cxx20.hpp>

#include <graze/decorated_bounds.hpp>

namespace graze {

/// The exceptions of IEEE 1788.1, 12.12 and 11.3.
enum class exception {
  none,
  undefined_operation,          ///< no interval is described: the value is empty, or NaI
  possibly_undefined_operation, ///< see text_to_interval
  interval_part_of_nai,         ///< the value is empty
};

/// The standard's name: "UndefinedOperation", "PossiblyUndefinedOperation", "IntvlPartOfNaI"; ""
/// for none.
const char* name_of(exception e);

/// A value, and what was signalled beside it.
template <class T> struct signalling {
  T value;
  exception signal = exception::none;
};

/// [lower, upper], which need -inf <= lower <= upper <= inf, lower < inf and -inf < upper; else
/// empty and undefined_operation. Exact.
signalling<bounds> nums_to_interval(double lower, double upper);

/// The same with its best decoration; NaI and undefined_operation where there is none.
signalling<decorated_bounds> nums_to_decorated(double lower, double upper);

/// x with the best decoration that it can have: com if it is bounded, dac if it is not, trv if it
/// is empty.
decorated_bounds new_dec(const bounds& x);

/// x decorated with d, or with the best below d that it can have; NaI and undefined_operation for
/// d = ill.
signalling<decorated_bounds> set_dec(const bounds& x, decoration d);

/// The set alone; empty and interval_part_of_nai for NaI.
signalling<bounds> interval_part(const decorated_bounds& x);

constexpr decoration decoration_part(const decorated_bounds& x) { return x.label; }

} // namespace graze
