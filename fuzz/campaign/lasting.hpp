#pragma once
/// Runs a campaign that lasts.
#include <campaign/store.hpp>

namespace graze::fuzz {

/// A piece and its counterexamples: for each kind of finding that it showed, one generator's first
/// ray, shrunk; the generator is chosen by the piece's number, so that over many pieces all have
/// their turn. Nothing when `stop` ended it early.
struct checked_piece {
  finished_piece piece;
  std::vector<finding_file> files;
};
std::optional<checked_piece> check_piece(const campaign_plan& plan, const stored_plan& stored,
                                         std::uint64_t number, const std::atomic<bool>& stop);

/// What is told while a campaign runs; each from one thread at a time.
struct campaign_listener {
  std::function<void(const finished_piece&)> piece;
  std::function<void(const sighting&, const finding_file&)> new_finding;
};

/// Works on the unfinished pieces, lowest first, on the plan's threads, until the budget is used up or
/// `stop` is true; an unfinished piece is left for the next start. Refused where the folder cannot be
/// written.
support::status run_lasting(campaign_store& store, const campaign_plan& plan,
                            const std::atomic<bool>& stop, const campaign_listener& listener);

} // namespace graze::fuzz
