#include <adapters/adapter.hpp>
#include <campaign/hint.hpp>
#include <cmath>
#include <external/external.hpp>

namespace graze::fuzz {

namespace {

constexpr std::size_t least_samples = 8;
// Of traversals in double that are wrong by rounding alone, 45 % at most become right for another ray; of one in
// float 89 % (slabs.c, which misses some in float too) or all.
constexpr double least_share = 0.8;

/// The ray as a traversal of that kind would have it; nothing where it is the same, or none.
std::optional<received_ray> received_as(const trial& t, other_ray r) {
  received_ray made{t.origin, t.direction, t.end};
  if (r != other_ray::unit_direction)
    made = rounded_to_float(t);
  if (r != other_ray::as_float) {
    if (t.end) // a segment's direction is not given
      return std::nullopt;
    double square = 0;
    for (const double d : made.direction)
      square += d * d;
    const double length = std::sqrt(square);
    for (double& d : made.direction)
      d /= length;
    if (r == other_ray::float_unit_direction)
      made.direction = adapter::to_float(made.direction);
  }
  return made;
}

/// What is said of the entry is, each of it, a float.
bool is_in_float(const remarks& said) {
  const auto is_float = [](const std::optional<double>& x) {
    return !x || adapter::to_float(vec3{*x, 0, 0})[0] == *x;
  };
  return (said.t || said.distance) && is_float(said.t) && is_float(said.distance);
}

/// Wrong in t, distance or face alone.
bool is_wrong_in_remarks(const sample& s, promise p, const allowance& allowed) {
  constexpr finding_set remarks = bit(finding::distance) | bit(finding::face);
  return (judge_answer(s.at, s.answer, p, allowed).findings & ~remarks) == 0;
}

/// Whether the answer is right for that ray; nothing where it is none, or where it tells nothing of float.
std::optional<bool> is_right_for(const sample& s, other_ray r, promise p,
                                 const allowance& allowed) {
  const auto ray = received_as(s.at, r);
  if (!ray)
    return std::nullopt;
  const bool in_float = r != other_ray::unit_direction;
  if (in_float && !is_in_float(s.answer.said()) && is_wrong_in_remarks(s, p, allowed))
    return std::nullopt;
  visited answer = s.answer;
  answer.receive(*ray);
  constexpr double ulp_of_float = 0x1p29; // in those of double
  const verdict v = judge_answer(
      s.at, answer, p,
      in_float ? allowance{allowed.tolerance * ulp_of_float, reach_in_float} : allowed);
  return v.declined ? std::nullopt : std::optional(v.findings == 0);
}

} // namespace

std::string_view name_of(other_ray r) {
  switch (r) {
  case other_ray::as_float:
    return "float";
  case other_ray::unit_direction:
    return "unit-direction";
  default:
    return "float-unit-direction";
  }
}

std::string_view advice_on(other_ray r) {
  switch (r) {
  case other_ray::as_float:
    return "the answers are right for the rays rounded to float: say --float, or answer with what "
           "was "
           "\"received\"";
  case other_ray::unit_direction:
    return "the answers are right for directions of length 1: answer with the direction that was "
           "\"received\"";
  default:
    return "the answers are right for directions of length 1 in float: answer with the ray that "
           "was "
           "\"received\"";
  }
}

std::optional<other_ray> hint_of(std::span<const sample> samples, promise p,
                                 const allowance& allowed) {
  std::optional<other_ray> best;
  double greatest = 0;
  for (const auto r :
       {other_ray::as_float, other_ray::unit_direction, other_ray::float_unit_direction}) {
    std::size_t asked = 0, right = 0;
    for (const sample& s : samples) {
      const auto is_right = s.answer.received() ? std::nullopt : is_right_for(s, r, p, allowed);
      asked += is_right ? 1 : 0;
      right += is_right == true ? 1 : 0;
    }
    const double share = static_cast<double>(right) / static_cast<double>(asked);
    if (asked >= least_samples && share >= least_share && share > greatest) {
      greatest = share;
      best = r;
    }
  }
  return best;
}

std::optional<other_ray> hint_of(const campaign_plan& plan, const campaign_result& result) {
  if (result.samples.size() < least_samples)
    return std::nullopt;
  const auto under_test = plan.under_test.guarded();
  return hint_of(result.samples, under_test->promises(), allowance_of(*under_test));
}

} // namespace graze::fuzz
