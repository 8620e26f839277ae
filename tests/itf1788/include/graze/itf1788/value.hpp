#pragma once
/// What a statement of an .itl file talks about: the operands and the results of an operation.
#include <cstdint>
#include <graze/decorated_bounds.hpp>
#include <string>
#include <variant>
#include <vector>

namespace graze::itf1788 {

/// One of the sixteen states of IEEE 1788-2015, Table 10.7, by its name there.
struct overlap_name {
  std::string name;
};

/// A literal of another format than binary64 (suffix f or l), as it was written. Graze has none.
struct other_format {
  std::string written;
};

/// `bounds` are a bare interval.
using value = std::variant<bounds, decorated_bounds, double, std::int64_t, bool, std::string,
                           decoration, overlap_name, std::vector<double>, other_format>;

/// In the notation of .itl files, numbers in hexadecimal.
std::string to_text(const value& v);

/// "interval", "decorated interval", "number", "integer", ...
std::string kind_of(const value& v);

/// Whether `got` is the result that the file states. Intervals: the same set and the same
/// decoration, if any; a bare interval is never the same as a decorated one. Numbers: the same real
/// number or infinity and, for zeros, the same sign (IEEE 1788-2015, 12.12.8: inf gives -0, sup
/// +0); any NaN is the same as any other. A number may be written as an integer.
bool same(const value& stated, const value& got);

/// Whether `got` lies within `outer`, as sets, with a decoration that promises no more. False
/// unless both are bare or both decorated; NaI lies within nothing.
bool within(const value& got, const value& outer);

} // namespace graze::itf1788
