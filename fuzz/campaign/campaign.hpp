#pragma once
/// A campaign: many trials on all threads, counted, until a budget is used up.
#include <atomic>
#include <functional>
#include <generate/climb.hpp>
#include <generate/generators.hpp>
#include <judge/judge.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace graze::fuzz {

/// How rays are looked for: `generators` are asked for each; `climb` starts at a generator's ray
/// and goes on towards the smallest margin (fuzz/generate/climb.hpp).
enum class search : std::uint8_t { generators, climb };
std::string_view name_of(search s);
/// By the names of name_of().
std::optional<search> search_of(std::string_view name);

/// What to run. Ray k of a campaign is trial k of the seed, by generator k mod the number of
/// generators; in a climb, step k mod climb_length of climb k / climb_length, which starts at the
/// trial of that number. So a campaign of a given number of rays counts and finds the same on any
/// number of threads.
struct campaign_plan {
  const traversal_entry* under_test = nullptr;
  std::shared_ptr<const traversal_entry> owned{}; ///< under_test, where no table holds it
  std::vector<const generator*> generators;
  int level = 50;      ///< 1..53
  int last_level = 50; ///< rays take the levels from `level` to this one in turn
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double seconds = 0;     ///< 0: no limit of time
  std::uint64_t rays = 0; ///< 0: no limit of rays
  std::uint64_t first_ray = 0;
  search by = search::generators;
  bool until_finding = false; ///< ends soon after the first one
};

/// What a generator's rays showed.
struct counts {
  std::uint64_t rays = 0;
  std::uint64_t touched = 0;        ///< octants that the rays touch
  std::uint64_t misses = 0;         ///< octants missed by the traversal's own promise
  std::uint64_t rays_with_miss = 0; ///< rays with such an octant
  std::uint64_t crossed_missed = 0; ///< crossed octants missed
  std::uint64_t gross_missed = 0;   ///< those of them with a chord of more than 1e-3 of their edge
  std::uint64_t touched_missed =
      0;                  ///< touched octants missed: a convention, not a bug, if only touched
  std::uint64_t gaps = 0; ///< lengths of rays that no visited octant covers
  std::uint64_t visited = 0;
  std::uint64_t spurious =
      0; ///< visited octants that are not touched (not owned, if exactly owned)
  std::uint64_t far_spurious = 0; ///< rays with a spurious octant that rounding does not explain
  std::uint64_t order_errors = 0; ///< rays whose owning octants were visited out of order
  std::uint64_t revisits = 0;     ///< rays with an octant reported twice, or one not of the block
  std::uint64_t findings = 0;     ///< rays with a finding of any kind
  std::uint64_t faults = 0; ///< rays that were not answered: crash, hang, exception, NaN, malformed
  std::uint64_t declined = 0; ///< rays that the traversal does not take: nothing was judged

  void add(const verdict& v);
  /// The share of the visits that is spurious.
  [[nodiscard]] double spurious_rate() const {
    return visited != 0 ? static_cast<double>(spurious) / static_cast<double>(visited) : 0;
  }
  counts& operator+=(const counts& other);
  friend bool operator==(const counts&, const counts&) = default;
};

struct campaign_result {
  std::vector<counts> by_generator; ///< as in the plan
  counts total;
  double seconds = 0;
  std::optional<double> first_miss_seconds; ///< until the first miss or gap
  /// For each generator and each kind of finding the first ray (lowest number) that showed it.
  std::vector<std::array<std::optional<std::uint64_t>, finding_kinds>> first;
  bool interrupted = false;

  /// The most serious kind found, if any.
  [[nodiscard]] std::optional<finding> worst_finding() const;
};

/// The trial of ray `index` of the plan; within a climb, after all that come before it.
trial trial_of(const campaign_plan& plan, std::uint64_t index);
/// The generator, by its place in the plan, that made the ray or the start of its climb.
std::size_t generator_of(const campaign_plan& plan, std::uint64_t index);

/// The trials of a plan; cheap for one after the other, in a climb too.
class trial_source {
public:
  explicit trial_source(const campaign_plan& plan) : plan_(plan) {}
  trial at(std::uint64_t index);

private:
  const campaign_plan& plan_;
  std::optional<climber> climber_;
  std::uint64_t next_ = 0; ///< the ray that climber_ makes next
};

/// `progress(rays, seconds)` is called about ten times a second, from this thread; `stop` ends the
/// campaign early when it becomes true.
campaign_result run_campaign(const campaign_plan& plan, const std::atomic<bool>& stop,
                             const std::function<void(std::uint64_t, double)>& progress = {});

} // namespace graze::fuzz
