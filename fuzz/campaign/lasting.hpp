#pragma once
/// Runs a campaign that lasts, and tells what it showed.
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

/// Works on the unfinished pieces, lowest first, until the budget is used up or `stop` is true; an
/// unfinished piece is left for the next start. Refused where the folder cannot be written.
support::status run_lasting(campaign_store& store, const campaign_plan& plan, unsigned threads,
                            const std::atomic<bool>& stop, const campaign_listener& tell);

/// Shards of one campaign together.
struct merged_campaign {
  stored_plan plan; ///< of the first folder
  campaign_state state;
  std::vector<std::string> folders;
  std::map<std::string, std::string> files; ///< of each finding, by hash
  std::size_t lost = 0;                     ///< so many of these are not there
};
/// Each piece counts once, in however many folders it is. The reason says what differs.
expected<merged_campaign> merge_campaigns(const std::vector<std::string>& folders);

/// A table, the findings and how to replay them.
std::string to_text(const merged_campaign& m, const campaign_plan& plan);
/// One object on one line: the members of `graze-fuzz run --json`, pieces, and findings.
std::string to_json(const merged_campaign& m, const campaign_plan& plan);
/// One page, with nothing outside of it but the links to the findings, seen from `page_folder`.
std::string to_html(const merged_campaign& m, const campaign_plan& plan,
                    const std::string& page_folder);

} // namespace graze::fuzz
