#pragma once
/// What the folders of a campaign hold together, as text, JSON and a page.
#include <campaign/store.hpp>

namespace graze::fuzz {

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
