#pragma once
/// The folder of a campaign that lasts. It may be killed at any time: what is in it is whole.
///
///   plan.json             what is searched; never changed
///   progress.jsonl        a line for every finished piece, appended and synced
///   findings/<hash>.json  a shrunk counterexample, which `graze-fuzz replay` takes
///   summary.html          for people
///
/// A piece is a fixed range of ray numbers, and what it counts and finds depends on the plan alone.
/// So a campaign that was killed and went on ends as one that was not.
#include <campaign/campaign.hpp>
#include <graze/support/files.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace graze::fuzz {

/// What plan.json holds: a plan of all shards together (no generators: all; `seconds` of this shard, all its
/// starts together), in pieces.
struct stored_plan : named_plan {
  std::uint64_t piece = 131'072; ///< rays of a piece
  std::uint64_t shard = 1;       ///< this one, of 1..shards: pieces k with k mod shards = shard - 1
  std::uint64_t shards = 1;

  /// The pieces of all shards; 0: no limit.
  [[nodiscard]] std::uint64_t pieces() const { return rays / piece + (rays % piece != 0 ? 1 : 0); }
  /// The rays of a piece (the last may be short).
  [[nodiscard]] std::uint64_t rays_of(std::uint64_t number) const;
  /// The pieces of this shard, and their rays; 0: none, or no limit where `rays` is 0.
  [[nodiscard]] std::uint64_t shard_pieces() const;
  [[nodiscard]] std::uint64_t shard_rays() const;
};

/// As resolve(), and refuses pieces and shards that are none.
expected<campaign_plan> resolve(const stored_plan& stored);

/// One line of findings in a piece.
struct sighting {
  std::string hash;
  finding kind;
  std::uint64_t ray;
  bool tame; ///< the shrunk ray is (generate/tame.hpp)
};

/// What a piece's rays showed.
struct finished_piece {
  std::uint64_t number = 0;
  double elapsed = 0; ///< seconds of the campaign up to its end, all starts together
  std::vector<counts> by_generator;
  std::vector<sighting> findings;
};

/// All finished pieces together; each counts once.
struct campaign_state {
  struct known_finding {
    finding kind;
    std::uint64_t ray;    ///< the lowest
    std::uint64_t pieces; ///< that showed it
    bool tame;
  };
  std::set<std::uint64_t> finished;
  std::vector<counts> by_generator;
  std::map<std::string, known_finding> findings; ///< by hash
  double elapsed = 0;

  [[nodiscard]] counts total() const;
  /// False when the piece was counted before.
  bool add(const finished_piece& p);
};

/// One line, without its end; and back, where any text is refused that is no piece of the plan.
std::string to_json_line(const finished_piece& p);
expected<finished_piece> piece_from(std::string_view line, const stored_plan& plan);

/// The text of plan.json; any text is refused that is none, or of which a part does not exist.
expected<stored_plan> plan_from(std::string_view text);

/// A finding's file: one line, which names the kind, the traversal and the ray; and its hash.
struct finding_file {
  std::string hash, line;
};
finding_file file_of(finding kind, std::string_view traversal, const trial& shrunk);

/// The file of a finding of this hash.
std::string finding_path(const std::string& folder, const std::string& hash);

/// A folder's plan; its finished pieces are added to `state`. Reads only; a last line that was cut
/// off is left out.
expected<stored_plan> read_campaign(const std::string& folder, campaign_state& state);

/// What differs between two plans in the members named: "seed is 1, not 2; ...". Empty: nothing.
std::string difference(const stored_plan& there, const stored_plan& wanted,
                       const std::vector<std::string>& members);
/// All members but shard, shards and seconds: what shards of one campaign have in common.
const std::vector<std::string>& common_members();

/// A campaign's folder, held by this process alone.
class campaign_store {
public:
  /// Makes the folder, or goes on with the one that is there: then the members of `plan` that are
  /// `given` must be those of plan.json, and the others are taken from it. The reason says what
  /// differs, that another process holds the folder, or what cannot be read.
  static expected<campaign_store> open(const std::string& folder, stored_plan plan,
                                       const std::vector<std::string>& given);

  [[nodiscard]] const stored_plan& plan() const { return plan_; }
  [[nodiscard]] const campaign_state& state() const { return state_; }
  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// A folder that was there and had finished pieces.
  [[nodiscard]] bool resumed() const { return resumed_; }

  /// Findings first, then the line: a line's findings are always there.
  support::status keep(const finding_file& f) const;
  support::status append(const finished_piece& p);

private:
  campaign_store() = default;
  std::string folder_;
  stored_plan plan_;
  campaign_state state_;
  support::descriptor lock_;
  std::optional<support::append_file> progress_;
  bool resumed_ = false;
};

} // namespace graze::fuzz
