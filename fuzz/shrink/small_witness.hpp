#pragma once
/// Greedy shrinking stops where every simpler trial passes; a small scene made anew often fails.
#include <generate/scenes.hpp>
#include <optional>
#include <shrink/shrink.hpp>

namespace graze::fuzz {

/// The simplest of a few shrunk trials of this kind of finding that were small from the start
/// (levels 1 to 3, unit octants, integers of few bits first); nothing if none fails. Always the
/// same for a deterministic traversal. It need not be the same mistake as another finding of the
/// kind. Of other scenes than rays through octants: from small grids of the rule of the one that is given,
/// or of spacing 1, and from lists of boxes.
std::optional<trial> small_witness(traversal& under_test, finding kind,
                                   unsigned evaluations = 10'000,
                                   shrink_deadline end = usual_deadline(),
                                   const std::atomic<bool>* stop = nullptr,
                                   const scene_choice& scene = {});

} // namespace graze::fuzz
