#pragma once
/// What was answered, and what would have been right, as a clause for people.
#include <judge/judge.hpp>
#include <string>

namespace graze::fuzz {

/// "3" of a list's boxes, "[8,0,28]" of voxels and octants.
std::string cell_name(const trial& t, octant_number v);

/// Each first cell that judge() finds nothing in, and whether none is right too. Of promise::first and
/// first_touched.
struct right_first {
  octant_set cells = 0;
  bool none = false;
};
right_first right_first_of(const trial& t, const truth& exact, promise p, const allowance& allowed);

/// "answered first 0, t 1.4, face +z; right: -x or -y", "answered 3 boxes; missed: 12". Of the trial that the
/// answer is for. Empty where there is no answer.
std::string answer_text(const trial& t, const truth& exact, const visited& answer, promise p,
                        const allowance& allowed);

} // namespace graze::fuzz
