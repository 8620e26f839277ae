#include <campaign/lasting.hpp>
#include <chrono>
#include <graze/support/threads.hpp>
#include <mutex>
#include <shrink/shrink.hpp>
#include <utility>

namespace graze::fuzz {

using support::status;

namespace {

using clock = std::chrono::steady_clock;

/// The pieces of a shard that are not finished, lowest first.
class open_pieces {
public:
  explicit open_pieces(const campaign_store& store)
      : plan_(store.plan()), finished_(store.state().finished), next_(plan_.shard - 1) {}
  std::optional<std::uint64_t> take() {
    while (finished_.contains(next_))
      next_ += plan_.shards;
    if (plan_.rays != 0 && next_ >= plan_.pieces())
      return std::nullopt;
    return std::exchange(next_, next_ + plan_.shards);
  }

private:
  const stored_plan& plan_;
  std::set<std::uint64_t> finished_; // at the start; those of this start lie before next_
  std::uint64_t next_;
};

/// What the threads share.
struct shared_work {
  campaign_store& store;
  const campaign_plan& plan;
  const std::atomic<bool>& stop;
  const campaign_listener& tell;
  open_pieces open;
  double elapsed_before;
  clock::time_point start = clock::now();
  std::mutex one_at_a_time{};
  status ran{};
  std::atomic<bool> failed{false}; ///< a thread has thrown

  [[nodiscard]] double elapsed() const {
    return elapsed_before + std::chrono::duration<double>(clock::now() - start).count();
  }
};

/// Writes the piece, and tells; under the lock.
status keep(shared_work& work, checked_piece& checked) {
  for (std::size_t i = 0; i < checked.files.size(); ++i) {
    const finding_file& f = checked.files[i];
    if (status kept = work.store.keep(f); !kept)
      return kept;
    if (work.tell.new_finding && !work.store.state().findings.contains(f.hash))
      work.tell.new_finding(checked.piece.findings[i], f);
  }
  checked.piece.elapsed = work.elapsed();
  if (status kept = work.store.append(checked.piece); !kept)
    return kept;
  if (work.tell.piece)
    work.tell.piece(checked.piece);
  return {};
}

void work_on_pieces(shared_work& work) {
  const stored_plan& stored = work.store.plan();
  for (;;) {
    std::optional<std::uint64_t> number;
    {
      const std::lock_guard lock(work.one_at_a_time);
      // the recorded time decides, not the clock: a later start then agrees that the budget is used
      if (work.stop.load() || work.failed.load() || !work.ran ||
          (stored.seconds != 0 && work.store.state().elapsed >= stored.seconds))
        return;
      number = work.open.take();
    }
    if (!number)
      return;
    auto checked = check_piece(work.plan, stored, *number, work.stop);
    if (!checked)
      return;
    const std::lock_guard lock(work.one_at_a_time);
    if (work.ran)
      work.ran = keep(work, *checked);
  }
}

} // namespace

std::optional<checked_piece> check_piece(const campaign_plan& plan, const stored_plan& stored,
                                         std::uint64_t number, const std::atomic<bool>& stop) {
  campaign_plan of = plan;
  of.first_ray = number * stored.piece;
  of.rays = stored.rays_of(number);
  of.threads = 1;
  of.seconds = 0;
  campaign_result result = run_campaign(of, stop);
  if (result.total.rays != of.rays)
    return std::nullopt;
  checked_piece checked;
  checked.piece.number = number;
  checked.piece.by_generator = std::move(result.by_generator);
  const auto under_test = plan.under_test->guarded();
  for (unsigned k = 0; k < finding_kinds; ++k) {
    std::vector<std::uint64_t> rays;
    for (const auto& of_generator : result.first)
      if (of_generator[k])
        rays.push_back(*of_generator[k]);
    if (rays.empty())
      continue;
    if (stop.load())
      return std::nullopt;
    const auto kind = static_cast<finding>(k);
    const std::uint64_t ray = rays[mix(number) % rays.size()];
    const trial shrunk =
        shrink(trial_of(plan, ray), *under_test, kind, 30'000, usual_deadline(), &stop);
    if (stop.load())
      return std::nullopt;
    // one trial is one finding: what is most serious in it
    const finding_set shows = judge(shrunk, *under_test).findings;
    const finding worst_of_it = shows != 0 ? worst(shows) : kind;
    finding_file f = file_of(worst_of_it, plan.under_test->name, shrunk);
    bool known = false;
    for (const finding_file& other : checked.files)
      known = known || other.hash == f.hash;
    if (known)
      continue;
    checked.piece.findings.push_back({f.hash, worst_of_it, ray});
    checked.files.push_back(std::move(f));
  }
  return checked;
}

status run_lasting(campaign_store& store, const campaign_plan& plan, unsigned threads,
                   const std::atomic<bool>& stop, const campaign_listener& tell) {
  shared_work work{store, plan, stop, tell, open_pieces(store), store.state().elapsed};
  support::thread_group workers(
      threads, [&work] { work_on_pieces(work); }, [&work] { work.failed = true; });
  workers.join();
  return work.ran;
}

} // namespace graze::fuzz
