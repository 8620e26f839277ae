#pragma once
/// A campaign: many trials on all threads, counted, until a budget is used up.
#include <atomic>
#include <campaign/schedule.hpp>
#include <judge/judge.hpp>
#include <optional>
#include <vector>

namespace graze::fuzz {

/// What a generator's rays showed.
struct counts {
  std::uint64_t rays = 0;
  std::uint64_t touched = 0;        ///< octants that the rays touch
  std::uint64_t misses = 0;         ///< octants missed by the traversal's own promise
  std::uint64_t rays_with_miss = 0; ///< rays with such an octant
  std::uint64_t crossed_missed = 0; ///< crossed octants missed
  std::uint64_t gross_missed = 0;   ///< those of them with a chord of more than 1e-3 of their edge
  std::uint64_t touched_missed =
      0;                   ///< touched octants missed: a convention, not a bug, if only touched
  std::uint64_t gaps = 0;  ///< lengths of rays that no visited octant covers, but for
  std::uint64_t seams = 0; ///< those in a face or an edge that octants have in common
  std::uint64_t visited = 0;
  std::uint64_t spurious =
      0; ///< visited octants that are not touched (not owned, if exactly owned)
  std::uint64_t far_spurious = 0; ///< rays with a spurious octant that rounding does not explain
  std::uint64_t order_errors = 0; ///< rays whose owning octants were visited out of order
  std::uint64_t revisits = 0;     ///< rays with an octant reported twice, or one not of the block
  std::uint64_t wrong_remarks =
      0; ///< rays whose first cell's t, distance or face is wrong, or whose count
  std::uint64_t findings = 0; ///< rays with a finding of any kind
  std::uint64_t faults = 0; ///< rays that were not answered: crash, hang, exception, NaN, malformed
  std::uint64_t declined = 0; ///< rays that the traversal does not take: nothing was judged
  std::uint64_t unsent =
      0; ///< rays that it was not asked about any more: its generator's made it hang
  std::array<std::uint64_t, finding_kinds> rays_with{}; ///< by kind of finding: rays that show it

  void add(const verdict& v);
  /// A ray that was not asked about.
  void add_unsent();
  /// Rays whose answer was judged: all but those that were declined, or not sent.
  [[nodiscard]] std::uint64_t judged() const { return rays - declined - unsent; }
  /// The share of the visits that is spurious.
  [[nodiscard]] double spurious_rate() const {
    return visited != 0 ? static_cast<double>(spurious) / static_cast<double>(visited) : 0;
  }
  counts& operator+=(const counts& other);
  friend bool operator==(const counts&, const counts&) = default;
};

/// The counts as they stand in the struct, so that a new one is nowhere forgotten.
using count_row = std::array<std::uint64_t, sizeof(counts) / sizeof(std::uint64_t)>;

/// A ray with a finding that is no fault, and what was answered.
struct sample {
  std::uint64_t ray;
  trial at;
  visited answer;
};
inline constexpr std::size_t most_samples = 64;

struct campaign_result {
  explicit campaign_result(std::size_t generators = 0)
      : by_generator(generators), first(generators), first_tame(generators) {}

  std::vector<counts> by_generator; ///< as in the plan
  counts total;
  double seconds = 0;
  std::optional<double> first_miss_seconds; ///< until the first miss or gap
  /// For each generator and each kind of finding the first ray (lowest number) that showed it.
  std::vector<std::array<std::optional<std::uint64_t>, finding_kinds>> first;
  /// The same of tame rays (generate/tame.hpp).
  std::vector<std::array<std::optional<std::uint64_t>, finding_kinds>> first_tame;
  std::vector<sample> samples; ///< the first most_samples of them, by their numbers
  bool interrupted = false;

  /// Adds what another worker's rays of the same plan showed.
  void add(const campaign_result& other);
  /// The kinds found, in the order in which an owner wants to know of them: what tame rays show, then what
  /// only others show, each from the most serious on.
  [[nodiscard]] std::vector<finding> kinds_found() const;
  /// Most rays with a finding show a seam: a convention, perhaps, rather than an error.
  [[nodiscard]] bool seams_lead() const;
  /// The first of them, if any.
  [[nodiscard]] std::optional<finding> foremost() const;
  /// A tame ray shows it.
  [[nodiscard]] bool is_on_tame_ray(finding kind) const;
  /// For each generator the first ray that shows it: tame ones, if there are any at all.
  [[nodiscard]] std::vector<std::optional<std::uint64_t>> first_rays(finding kind) const;
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

/// How often each generator's rays have made the traversal hang, for all workers together.
using hang_counts = std::vector<std::atomic<std::uint64_t>>;

/// One worker's part of a campaign: asks and judges the stretches that it takes.
campaign_result search_rays(const campaign_plan& plan, schedule& stretches, hang_counts& hangs);

/// All of them, on the plan's threads; `stop` ends it early when it becomes true.
campaign_result run_campaign(const campaign_plan& plan, const std::atomic<bool>& stop,
                             const progress_listener& progress = {});

} // namespace graze::fuzz
