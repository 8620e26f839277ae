#pragma once
/// Trials of text formulas: damaged texts are refused where they go wrong, and the enclosure of a
/// formula over a box holds MPFR's values at points of the box.
#include <graze/bounds.hpp>
#include <self/subject.hpp>

namespace graze::fuzz::self {

/// A change of an enclosure before it is judged: for tests of the campaign itself.
using changed_enclosure = std::function<bounds(const bounds&)>;

subject formula_subject(const changed_enclosure& changed = {});

} // namespace graze::fuzz::self
