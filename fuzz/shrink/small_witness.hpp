#pragma once
/// Greedy shrinking stops where every simpler trial passes; a small scene made anew often fails.
#include <optional>
#include <shrink/shrink.hpp>

namespace graze::fuzz {

/// The simplest of a few shrunk trials of this kind of finding that were small from the start
/// (levels 1 to 3, unit octants, integers of few bits first); nothing if none fails. Always the
/// same for a deterministic traversal. It need not be the same mistake as another finding of the
/// kind.
std::optional<trial> small_witness(traversal& under_test, finding kind,
                                   unsigned evaluations = 10'000,
                                   shrink_deadline end = usual_deadline(),
                                   const std::atomic<bool>* stop = nullptr);

} // namespace graze::fuzz
