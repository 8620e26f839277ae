#include <campaign/lasting.hpp>
#include <generate/tame.hpp>
#include <mutex>
#include <shrink/shrink.hpp>

namespace graze::fuzz {

using support::status;

namespace {

/// Writes the piece, and tells of it.
status keep(campaign_store& store, const checked_piece& checked,
            const campaign_listener& listener) {
  for (std::size_t i = 0; i < checked.files.size(); ++i) {
    const finding_file& f = checked.files[i];
    if (status kept = store.keep(f); !kept)
      return kept;
    if (listener.new_finding && !store.state().findings.contains(f.hash))
      listener.new_finding(checked.piece.findings[i], f);
  }
  if (status kept = store.append(checked.piece); !kept)
    return kept;
  if (listener.piece)
    listener.piece(checked.piece);
  return {};
}

} // namespace

std::optional<checked_piece> check_piece(const campaign_plan& plan, const stored_plan& stored,
                                         std::uint64_t number, const std::atomic<bool>& stop) {
  campaign_plan rays = plan;
  rays.first = number * stored.piece;
  rays.trials = stored.rays_of(number);
  rays.seconds = 0;
  schedule stretches(rays, rays.trials, stop);
  hang_counts hangs(rays.generators.size()); // of this piece: it depends on the plan alone
  campaign_result result = search_rays(rays, stretches, hangs);
  if (result.total.rays != rays.trials)
    return std::nullopt;
  checked_piece checked;
  checked.piece.number = number;
  checked.piece.by_generator = std::move(result.by_generator);
  const auto under_test = plan.under_test.guarded();
  for (unsigned k = 0; k < finding_kinds; ++k) {
    const auto kind = static_cast<finding>(k);
    std::vector<std::uint64_t> shown;
    for (const auto& ray : result.first_rays(kind))
      if (ray)
        shown.push_back(*ray);
    if (shown.empty())
      continue;
    if (stop.load())
      return std::nullopt;
    const std::uint64_t ray = shown[mix(number) % shown.size()];
    const trial shrunk = shrink(trial_of(plan, ray), *under_test, kind, 30'000, usual_deadline(),
                                &stop, plan.scene.grid != nullptr);
    if (stop.load())
      return std::nullopt;
    // one trial is one finding: what is most serious in it
    const finding_set shows = judge(shrunk, *under_test).findings;
    const finding worst_of_it = shows != 0 ? worst(shows) : kind;
    finding_file f = file_of(worst_of_it, plan.under_test.name, shrunk);
    bool known = false;
    for (const finding_file& other : checked.files)
      known = known || other.hash == f.hash;
    if (known)
      continue;
    checked.piece.findings.push_back({f.hash, worst_of_it, ray, is_tame(shrunk)});
    checked.files.push_back(std::move(f));
  }
  return checked;
}

status run_lasting(campaign_store& store, const campaign_plan& plan, const std::atomic<bool>& stop,
                   const campaign_listener& listener) {
  const stored_plan& stored = store.plan();
  const std::set<std::uint64_t> finished = store.state().finished; // at the start
  const double seconds_before = store.state().elapsed;
  // the k-th piece of this shard is piece k * shards + shard - 1 of all
  schedule pieces({.trials = stored.shard_pieces()}, 1, stop);
  // the recorded time decides, not the clock: a later start then agrees that the budget is used
  const auto is_used = [&] {
    return stored.seconds != 0 && store.state().elapsed >= stored.seconds;
  };
  if (is_used() || (stored.rays != 0 && stored.shard_pieces() == 0))
    pieces.end();
  std::mutex keeping;
  status kept;
  run_on_threads(pieces, plan.workers, [&] {
    while (const auto taken = pieces.take()) {
      const std::uint64_t number = taken->begin * stored.shards + stored.shard - 1;
      if (finished.contains(number))
        continue;
      auto checked = check_piece(plan, stored, number, stop);
      if (!checked)
        return;
      const std::lock_guard lock(keeping);
      if (!kept)
        return;
      checked->piece.elapsed = seconds_before + pieces.seconds();
      kept = keep(store, *checked, listener);
      if (!kept || is_used())
        pieces.end();
    }
  });
  return kept;
}

} // namespace graze::fuzz
