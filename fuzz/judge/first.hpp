#pragma once
/// Judges of answers that list no cells: the first one, whether there is one, a number of crossings.
#include <judge/judge.hpp>
#include <string>
#include <vector>

namespace graze::fuzz {

/// promise::first and first_touched: one cell or none, and what is said of its entry.
verdict judge_first(const trial& t, const truth& exact, const visited& answer, promise p,
                    const allowance& allowed);
/// The same where the one cell is a voxel of the trial's map outside of the block: right if it is touched, and
/// entered no later than the first crossed one of the block (for first_touched: than the soonest).
verdict judge_elsewhere(const trial& t, const truth& exact, const visited& answer, promise p,
                        const allowance& allowed);
/// promise::any. That there is one is no finding in a map, where it may be outside of the block.
verdict judge_any(const trial& t, const truth& exact, const visited& answer,
                  const allowance& allowed);
/// promise::count.
verdict judge_count(const trial& t, const truth& exact, const visited& answer);

/// What judge() finds right of the entry into a cell.
struct right_entry {
  std::array<double, 2> t, distance; ///< from and to, both right
  std::vector<std::string> faces; ///< "-x", ...; "none" where the origin may be taken to be inside
};
/// Of a cell that the ray touches.
right_entry entry_into(const trial& t, octant_number v, double tolerance);

/// What is known about the crossings of the surface of all cells together.
struct surface_crossings {
  bool odd;
  std::optional<std::uint64_t> number; ///< where each is in the interior of a face
};
/// Nothing for a map, and where the origin (of a segment, or the end) is on a cell's surface, unless it is in the
/// interior of another, and where a cell is flat: it has no inside.
std::optional<surface_crossings> crossings_of(const trial& t);

/// Of these cells those that the ray does not even touch with their faces moved outwards by this share
/// (allowance::reach).
octant_set far_from(const trial& t, octant_set cells, double share);

} // namespace graze::fuzz
