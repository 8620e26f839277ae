#include <algorithm>
#include <campaign/campaign.hpp>
#include <chrono>
#include <graze/rounding/environment.hpp>
#include <graze/support/threads.hpp>
#include <mutex>

namespace graze::fuzz {

namespace {

using clock = std::chrono::steady_clock;

double since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

std::uint64_t size_of(voxel_set set) { return static_cast<std::uint64_t>(std::popcount(set)); }

void keep_lower(std::optional<std::uint64_t>& lowest, std::uint64_t ray) {
  if (!lowest || ray < *lowest)
    lowest = ray;
}

constexpr finding_set misses_and_gaps =
    bit(finding::crossed_miss) | bit(finding::gap) | bit(finding::miss);

constexpr finding_set faults_of_answers = bit(finding::crash) | bit(finding::hang) |
                                          bit(finding::exception) | bit(finding::not_a_number) |
                                          bit(finding::malformed);

/// Rays are handed out in pieces of this many.
constexpr std::uint64_t piece = 1024;
/// A traversal is asked this many at a time, after fewer: 1, 2, 4 and so on, so that the first
/// answers of a slow one do not wait for the others.
constexpr std::size_t asked_at_once = 64;

/// What the threads share.
struct shared_state {
  shared_state(const campaign_plan& plan_, const std::atomic<bool>& stop_)
      : plan(plan_), stop(stop_) {}
  const campaign_plan& plan;
  const std::atomic<bool>& stop;
  clock::time_point start = clock::now();
  std::atomic<std::uint64_t> next{0}; ///< rays handed out
  std::atomic<std::uint64_t> done{0};
  std::atomic<bool> found{false}; ///< what ends a campaign that runs until a finding
  std::mutex merging;
  campaign_result result;
};

void work(shared_state& shared) {
  const campaign_plan& plan = shared.plan;
  const auto under_test = plan.under_test->guarded();
  const std::size_t kinds = plan.generators.size();
  trial_source source(plan);
  std::vector<counts> by_generator(kinds);
  decltype(campaign_result::first) first(kinds);
  std::optional<double> first_miss;
  std::vector<trial> asked(asked_at_once);
  std::vector<visited> said(asked_at_once);

  const auto one = [&](std::uint64_t ray, const trial& t, const visited& answer) {
    const verdict v = judge_answer(t, answer, under_test->promises());
    const std::size_t of = generator_of(plan, ray);
    by_generator[of].add(v);
    if (v.findings == 0)
      return;
    if (!first_miss && (v.findings & misses_and_gaps) != 0)
      first_miss = since(shared.start);
    for (unsigned k = 0; k < finding_kinds; ++k)
      if ((v.findings >> k & 1) != 0)
        keep_lower(first[of][k], ray);
    if (plan.until_finding)
      shared.found.store(true, std::memory_order_relaxed);
  };

  std::size_t at_once = 1;
  const auto expired = [&] {
    return shared.stop.load(std::memory_order_relaxed) ||
           shared.found.load(std::memory_order_relaxed) ||
           (plan.seconds != 0 && since(shared.start) >= plan.seconds);
  };
  while (!expired()) {
    const std::uint64_t from = shared.next.fetch_add(piece);
    if (plan.rays != 0 && from >= plan.rays)
      break;
    const std::uint64_t to = plan.rays != 0 ? std::min(from + piece, plan.rays) : from + piece;
    // a traversal in another process may be slow: what is left of a piece is dropped in time
    for (std::uint64_t k = from; k < to && (k == from || !expired());) {
      const std::size_t count = std::min<std::uint64_t>(at_once, to - k);
      at_once = std::min(2 * at_once, asked_at_once);
      for (std::size_t i = 0; i < count; ++i)
        asked[i] = source.at(plan.first_ray + k + i);
      std::size_t answered = 0;
      while (answered < count && (answered == 0 || !expired())) {
        const std::size_t some =
            under_test->visit_some(std::span(asked).subspan(answered, count - answered),
                                   std::span(said).subspan(answered));
        rounding::set_default_environment(); // whatever a traversal in this process has left
        for (const std::size_t end = answered + some; answered < end; ++answered)
          one(plan.first_ray + k + answered, asked[answered], said[answered]);
      }
      k += answered;
      shared.done.fetch_add(answered, std::memory_order_relaxed);
    }
  }

  const std::lock_guard lock(shared.merging);
  campaign_result& all = shared.result;
  for (std::size_t g = 0; g < kinds; ++g)
    all.by_generator[g] += by_generator[g];
  for (std::size_t g = 0; g < kinds; ++g)
    for (unsigned k = 0; k < finding_kinds; ++k)
      if (first[g][k])
        keep_lower(all.first[g][k], *first[g][k]);
  if (first_miss && (!all.first_miss_seconds || *first_miss < *all.first_miss_seconds))
    all.first_miss_seconds = first_miss;
}

} // namespace

std::string_view name_of(search s) { return s == search::climb ? "climb" : "generators"; }

std::optional<search> search_of(std::string_view name) {
  for (const search s : {search::generators, search::climb})
    if (name_of(s) == name)
      return s;
  return std::nullopt;
}

void counts::add(const verdict& v) {
  ++rays;
  if (v.declined)
    ++declined;
  if ((v.findings & faults_of_answers) != 0)
    ++faults;
  touched += size_of(v.touched);
  misses += size_of(v.missed);
  rays_with_miss += v.missed != 0 ? 1 : 0;
  crossed_missed += size_of(v.crossed_missed);
  gross_missed += size_of(v.gross_missed);
  touched_missed += size_of(v.touched_missed);
  gaps += v.gaps;
  visited += size_of(v.visited);
  spurious += size_of(v.spurious);
  if ((v.findings & bit(finding::far_spurious)) != 0)
    ++far_spurious;
  if (v.order_error)
    ++order_errors;
  if ((v.findings & (bit(finding::revisit) | bit(finding::outside))) != 0)
    ++revisits;
  if (v.findings != 0)
    ++findings;
}

counts& counts::operator+=(const counts& other) {
  rays += other.rays;
  touched += other.touched;
  misses += other.misses;
  rays_with_miss += other.rays_with_miss;
  crossed_missed += other.crossed_missed;
  gross_missed += other.gross_missed;
  touched_missed += other.touched_missed;
  gaps += other.gaps;
  visited += other.visited;
  spurious += other.spurious;
  far_spurious += other.far_spurious;
  order_errors += other.order_errors;
  revisits += other.revisits;
  findings += other.findings;
  faults += other.faults;
  declined += other.declined;
  return *this;
}

std::optional<finding> campaign_result::worst_finding() const {
  for (unsigned k = 0; k < finding_kinds; ++k)
    for (const auto& of_generator : first)
      if (of_generator[k])
        return static_cast<finding>(k);
  return std::nullopt;
}

trial trial_of(const campaign_plan& plan, std::uint64_t index) {
  return trial_source(plan).at(index);
}

std::size_t generator_of(const campaign_plan& plan, std::uint64_t index) {
  return (plan.by == search::climb ? index / climb_length : index) % plan.generators.size();
}

namespace {

trial generated(const campaign_plan& plan, std::uint64_t index) {
  const std::uint64_t kinds = plan.generators.size();
  const auto levels = static_cast<std::uint64_t>(std::max(1, plan.last_level - plan.level + 1));
  const int level = plan.level + static_cast<int>(index / kinds % levels);
  return make_trial(*plan.generators[index % kinds], plan.seed, index, level);
}

} // namespace

trial trial_source::at(std::uint64_t index) {
  if (plan_.by == search::generators)
    return generated(plan_, index);
  const std::uint64_t number = index / climb_length;
  const std::uint64_t start = number * climb_length;
  if (!climber_ || next_ != index || index == start) {
    climber_.emplace(generated(plan_, number), plan_.seed, number);
    next_ = start + 1;
    if (index == start)
      return climber_->at();
    while (next_ < index) {
      climber_->next();
      ++next_;
    }
  }
  ++next_;
  return climber_->next();
}

campaign_result run_campaign(const campaign_plan& plan, const std::atomic<bool>& stop,
                             const std::function<void(std::uint64_t, double)>& progress) {
  shared_state shared(plan, stop);
  shared.result.by_generator.resize(plan.generators.size());
  shared.result.first.resize(plan.generators.size());
  support::thread_group workers(
      plan.threads, [&shared] { work(shared); }, [&shared] { shared.found = true; });
  while (!workers.wait_for(std::chrono::milliseconds(100)))
    if (progress)
      progress(shared.done.load(), since(shared.start));
  workers.join();
  campaign_result result = std::move(shared.result);
  result.seconds = since(shared.start);
  result.interrupted = stop.load();
  for (const counts& c : result.by_generator)
    result.total += c;
  return result;
}

} // namespace graze::fuzz
