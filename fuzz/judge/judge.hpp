#pragma once
/// The properties of a traversal, written once: pure predicates over what the oracle says about a
/// ray in a block (`truth`) and what was visited. The campaign, the shrinker, replay and the
/// RapidCheck tests all use these.
#include <bit>
#include <optional>
#include <traversal/traversal.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

/// What exact arithmetic says about a trial.
struct truth {
  voxel_set touched = 0; ///< closed boxes that the ray meets
  voxel_set owned = 0;   ///< half-open boxes that the ray meets (the root's far faces are closed)
  voxel_set crossed = 0; ///< open interiors that the ray meets
  /// The owning octants in order of t.
  std::array<voxel, 64> owner_order;
  unsigned owners = 0;
  /// For each positive length of the ray whose surroundings are all in the block or outside the
  /// root: the octants whose closed boxes hold it.
  std::array<voxel_set, 40> lengths;
  unsigned length_count = 0;
};

/// Exact, for every trial that passes refusal().
truth truth_of(const trial& t);

/// Touched octants that were not visited: misses of a traversal that promises `touched`.
inline voxel_set touched_missed(const truth& is, const visited& said) {
  return is.touched & ~said.set();
}
/// Owning octants that were not visited: misses of a traversal that promises `owned`.
inline voxel_set owned_missed(const truth& is, const visited& said) {
  return is.owned & ~said.set();
}
/// Crossed octants that were not visited: misses under every convention.
inline voxel_set crossed_missed(const truth& is, const visited& said) {
  return is.crossed & ~said.set();
}

/// The misses by the traversal's own promise.
inline voxel_set misses(const truth& is, const visited& said, promise p) {
  if (p == promise::crossed)
    return crossed_missed(is, said);
  return promises_owned(p) ? owned_missed(is, said) : touched_missed(is, said);
}

/// The lengths of the ray that no visited octant covers: a bug under every convention.
inline unsigned gaps(const truth& is, const visited& said) {
  unsigned count = 0;
  for (unsigned i = 0; i < is.length_count; ++i)
    count += (is.lengths[i] & said.set()) == 0 ? 1 : 0;
  return count;
}

/// Visited octants that the ray does not touch; where owning octants and no others are promised,
/// those that do not own. A sound test may report some within its rounding, an exact one may not.
inline voxel_set spurious(const truth& is, const visited& said, promise p = promise::touched) {
  return said.set() & ~(p == promise::exactly_owned ? is.owned : is.touched);
}

/// The owning octants were visited in an order other than t's.
inline bool out_of_order(const truth& is, const visited& said) {
  unsigned at = 0; // the place in owner_order of the last owner seen
  for (unsigned i = 0; i < said.size(); ++i) {
    if ((is.owned >> said[i] & 1) == 0)
      continue;
    unsigned place = at;
    while (place < is.owners && is.owner_order[place] != said[i])
      ++place;
    if (place == is.owners)
      return true; // it lies before `at`
    at = place;
  }
  return false;
}

/// Spurious octants that rounding does not explain: the ray does not even touch the octant with its
/// faces moved outwards by 2^-47 of their distances from the ray's origin and from 0 (64 roundings
/// of either). Empty where products of the ray's components may leave the range of double, since
/// there nothing can be told from rounding.
voxel_set far_spurious(const trial& t, const truth& is, const visited& said);

/// Of the missed octants those with a chord (the length of the ray in the closed octant) of more
/// than 1e-3 of their edge: rounding in double does not explain them. Exact, by rationals.
voxel_set gross(const trial& t, voxel_set missed);

/// The kinds of finding, most serious first; a set of them is a finding_set. A gross miss is a
/// crossed miss too. `spurious` is one for
/// an exact promise only; the first five are those of `fault`, and leave nothing else to judge.
enum class finding : unsigned {
  crash,
  hang,
  exception,
  not_a_number,
  malformed,
  gross_miss,
  crossed_miss,
  gap,
  miss,
  order,
  revisit,
  far_spurious,
  spurious,
  outside
};
inline constexpr unsigned finding_kinds = 14;
std::string_view name_of(finding f);
/// By the names of name_of().
std::optional<finding> finding_of(std::string_view name);

using finding_set = unsigned;
constexpr finding_set bit(finding f) { return 1u << static_cast<unsigned>(f); }
/// The most serious of a set that is not empty.
inline finding worst(finding_set set) { return static_cast<finding>(std::countr_zero(set)); }

/// Everything that is told about one trial and one answer.
struct verdict {
  voxel_set touched = 0, visited = 0, missed = 0, crossed_missed = 0, gross_missed = 0,
            touched_missed = 0, spurious = 0;
  unsigned gaps = 0;
  bool order_error = false;
  bool declined = false; ///< nothing was judged
  finding_set findings = 0;
};

/// The trial that an answer is for: t, with the ray that was received. Nothing when that is not a
/// ray, or when the trial was declined.
std::optional<trial> trial_answered(const trial& t, const visited& said);

/// Judges an answer by its promise. Order is judged where owning octants are promised. `t` is the
/// trial that the answer is for.
verdict judge(const trial& t, const truth& is, const visited& said, promise p);

/// Judges an answer to t on the ray that was received.
verdict judge_answer(const trial& t, const visited& said, promise p);

/// Asks the traversal and judges the answer.
verdict judge(const trial& t, traversal& under_test);

} // namespace graze::fuzz
