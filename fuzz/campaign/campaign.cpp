#include <algorithm>
#include <campaign/campaign.hpp>
#include <generate/tame.hpp>
#include <graze/rounding/environment.hpp>
#include <mutex>

namespace graze::fuzz {

namespace {

std::uint64_t size_of(octant_set set) { return static_cast<std::uint64_t>(std::popcount(set)); }

void keep_lower(std::optional<std::uint64_t>& lowest, std::uint64_t ray) {
  if (!lowest || ray < *lowest)
    lowest = ray;
}

constexpr finding_set misses_and_gaps =
    bit(finding::crossed_miss) | bit(finding::gap) | bit(finding::seam) | bit(finding::miss);

constexpr finding_set faults_of_answers = bit(finding::crash) | bit(finding::hang) |
                                          bit(finding::exception) | bit(finding::not_a_number) |
                                          bit(finding::malformed);

constexpr finding_set wrong_remarks_of_answers =
    bit(finding::distance) | bit(finding::face) | bit(finding::count);

} // namespace

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
  seams += v.seams;
  visited += size_of(v.visited);
  spurious += size_of(v.spurious);
  if ((v.findings & bit(finding::far_spurious)) != 0)
    ++far_spurious;
  if (v.order_error)
    ++order_errors;
  if ((v.findings & (bit(finding::revisit) | bit(finding::outside))) != 0)
    ++revisits;
  if ((v.findings & wrong_remarks_of_answers) != 0)
    ++wrong_remarks;
  if (v.findings == 0)
    return;
  ++findings;
  for (unsigned k = 0; k < finding_kinds; ++k)
    rays_with[k] += v.findings >> k & 1;
}

void counts::add_unsent() {
  ++rays;
  ++unsent;
}

counts& counts::operator+=(const counts& other) {
  auto sum = std::bit_cast<count_row>(*this);
  const auto more = std::bit_cast<count_row>(other);
  std::transform(sum.begin(), sum.end(), more.begin(), sum.begin(), std::plus<>());
  return *this = std::bit_cast<counts>(sum);
}

void campaign_result::add(const campaign_result& other) {
  for (std::size_t g = 0; g < by_generator.size(); ++g) {
    by_generator[g] += other.by_generator[g];
    for (unsigned k = 0; k < finding_kinds; ++k) {
      if (other.first[g][k])
        keep_lower(first[g][k], *other.first[g][k]);
      if (other.first_tame[g][k])
        keep_lower(first_tame[g][k], *other.first_tame[g][k]);
    }
  }
  total += other.total;
  samples.insert(samples.end(), other.samples.begin(), other.samples.end());
  std::sort(samples.begin(), samples.end(),
            [](const sample& a, const sample& b) { return a.ray < b.ray; });
  if (samples.size() > most_samples)
    samples.erase(samples.begin() + most_samples, samples.end());
  if (other.first_miss_seconds)
    first_miss_seconds =
        std::min(first_miss_seconds.value_or(*other.first_miss_seconds), *other.first_miss_seconds);
}

std::vector<finding> campaign_result::kinds_found() const {
  std::vector<finding> kinds;
  for (unsigned k = 0; k < finding_kinds; ++k)
    if (std::any_of(first.begin(), first.end(),
                    [k](const auto& of_generator) { return of_generator[k].has_value(); }))
      kinds.push_back(static_cast<finding>(k));
  std::stable_partition(kinds.begin(), kinds.end(),
                        [this](finding f) { return is_on_tame_ray(f); });
  return kinds;
}

bool campaign_result::seams_lead() const {
  return 2 * total.rays_with[static_cast<unsigned>(finding::seam)] > total.findings;
}

std::optional<finding> campaign_result::foremost() const {
  const std::vector<finding> kinds = kinds_found();
  return kinds.empty() ? std::nullopt : std::optional(kinds.front());
}

bool campaign_result::is_on_tame_ray(finding kind) const {
  return std::any_of(first_tame.begin(), first_tame.end(), [kind](const auto& of_generator) {
    return of_generator[static_cast<unsigned>(kind)].has_value();
  });
}

std::vector<std::optional<std::uint64_t>> campaign_result::first_rays(finding kind) const {
  std::vector<std::optional<std::uint64_t>> rays;
  for (const auto& of_generator : is_on_tame_ray(kind) ? first_tame : first)
    rays.push_back(of_generator[static_cast<unsigned>(kind)]);
  return rays;
}

trial trial_of(const campaign_plan& plan, std::uint64_t index) {
  return trial_source(plan).at(index);
}

std::size_t generator_of(const campaign_plan& plan, std::uint64_t index) {
  return (plan.method == search::climb ? index / climb_length : index) % plan.generators.size();
}

namespace {

trial generated(const campaign_plan& plan, std::uint64_t index) {
  const std::uint64_t kinds = plan.generators.size();
  const auto levels = static_cast<std::uint64_t>(std::max(1, plan.last_level - plan.level + 1));
  const int level = plan.level + static_cast<int>(index / kinds % levels);
  return make_trial(*plan.generators[index % kinds], plan.seed, index, level, plan.scene,
                    plan.tame);
}

} // namespace

trial trial_source::at(std::uint64_t index) {
  if (plan_.method == search::generators)
    return generated(plan_, index);
  const std::uint64_t number = index / climb_length;
  const std::uint64_t start = number * climb_length;
  if (!climber_ || next_ != index || index == start) {
    climber_.emplace(generated(plan_, number), plan_.seed, number, plan_.tame);
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

campaign_result search_rays(const campaign_plan& plan, schedule& stretches, hang_counts& hangs) {
  const auto under_test = plan.under_test.guarded();
  const promise promised = under_test->promises();
  const allowance allowed = allowance_of(*under_test);
  trial_source source(plan);
  campaign_result result(plan.generators.size());
  // a traversal is asked as many at a time as suits it, after fewer: 1, 2, 4 and so on, so that the first
  // answers of a slow one do not wait for the others
  const std::size_t most_asked = std::max<std::size_t>(1, under_test->at_once());
  std::vector<trial> asked(most_asked);
  std::vector<std::uint64_t> numbers(most_asked);
  std::vector<visited> answers(most_asked);
  const auto is_sent = [&](std::uint64_t ray) {
    return plan.hangs == 0 || hangs[generator_of(plan, ray)] < plan.hangs;
  };
  const auto leave_out = [&](std::uint64_t ray) {
    result.by_generator[generator_of(plan, ray)].add_unsent();
  };

  const auto judge_one = [&](std::uint64_t ray, const trial& t, const visited& answer) {
    const verdict v = judge_answer(t, answer, promised, allowed);
    const std::size_t g = generator_of(plan, ray);
    result.by_generator[g].add(v);
    if (v.findings == 0)
      return;
    if (!result.first_miss_seconds && (v.findings & misses_and_gaps) != 0)
      result.first_miss_seconds = stretches.seconds();
    const bool tame = is_tame(t);
    for (unsigned k = 0; k < finding_kinds; ++k)
      if ((v.findings >> k & 1) != 0) {
        keep_lower(result.first[g][k], ray);
        if (tame)
          keep_lower(result.first_tame[g][k], ray);
      }
    if ((v.findings & bit(finding::hang)) != 0)
      ++hangs[g];
    if (result.samples.size() < most_samples && (v.findings & faults_of_answers) == 0)
      result.samples.push_back({ray, t, answer});
    if (plan.until_finding)
      stretches.end();
  };

  std::size_t at_once = 1;
  while (const auto taken = stretches.take()) {
    // a traversal in another process may be slow: what is left of a stretch is dropped in time
    for (std::uint64_t k = taken->begin;
         k < taken->end && (k == taken->begin || !stretches.has_ended());) {
      const std::size_t taken_now = std::min<std::uint64_t>(at_once, taken->end - k);
      at_once = std::min(2 * at_once, most_asked);
      std::size_t count = 0; // of those that are sent
      std::size_t unsent = 0;
      for (std::size_t i = 0; i < taken_now; ++i) {
        const std::uint64_t ray = plan.first + k + i;
        if (!is_sent(ray)) {
          leave_out(ray);
          ++unsent;
          continue;
        }
        numbers[count] = ray;
        asked[count++] = source.at(ray);
      }
      std::size_t answered = 0;
      while (answered < count && (answered == 0 || !stretches.has_ended())) {
        const std::size_t some =
            under_test->visit_some(std::span(asked).subspan(answered, count - answered),
                                   std::span(answers).subspan(answered));
        rounding::set_default_environment(); // whatever a traversal in this process has left
        bool hung = false;
        for (const std::size_t end = answered + some; answered < end; ++answered) {
          judge_one(numbers[answered], asked[answered], answers[answered]);
          hung = hung || answers[answered].failed() == fault::hang;
        }
        if (!hung)
          continue;
        std::size_t left = answered; // what is still sent of the others
        for (std::size_t i = answered; i < count; ++i) {
          if (!is_sent(numbers[i])) {
            leave_out(numbers[i]);
            ++unsent;
            continue;
          }
          numbers[left] = numbers[i];
          asked[left++] = asked[i];
        }
        count = left;
      }
      k += answered + unsent;
      stretches.count(answered + unsent);
    }
  }
  for (const counts& c : result.by_generator)
    result.total += c;
  return result;
}

campaign_result run_campaign(const campaign_plan& plan, const std::atomic<bool>& stop,
                             const progress_listener& progress) {
  schedule stretches(plan, 1024, stop);
  campaign_result result(plan.generators.size());
  hang_counts hangs(plan.generators.size());
  std::mutex adding;
  run_on_threads(
      stretches, plan.workers,
      [&] {
        const campaign_result part = search_rays(plan, stretches, hangs);
        const std::lock_guard lock(adding);
        result.add(part);
      },
      progress);
  result.seconds = stretches.seconds();
  result.interrupted = stop.load();
  return result;
}

} // namespace graze::fuzz
