#pragma once
/// The properties of a traversal, written once: pure predicates over what the oracle says about a
/// ray in a block (`truth`) and what was visited. The campaign, the shrinker, replay and the
/// RapidCheck tests all use these.
#include <bit>
#include <graze/oracle/lines.hpp>
#include <optional>
#include <traversal/traversal.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

/// What exact arithmetic says about a trial.
struct truth {
  octant_set touched = 0; ///< closed boxes that the ray meets
  octant_set owned =
      0; ///< half-open boxes that the ray meets (far faces of the root or grid, and flat
         ///< axes, are closed); none of a list of boxes
  octant_set crossed =
      0; ///< open interiors that the ray meets; of a flat cell the interior in its plane
  /// The owning octants in order of t.
  std::array<octant_number, 64> owner_order;
  unsigned owners = 0;
  /// For each positive length of the ray whose surroundings are all in the block or outside the
  /// root: the octants whose closed boxes hold it.
  std::array<octant_set, 40> lengths;
  unsigned length_count = 0;
  /// The cells that are touched at the smallest t at which any is.
  octant_set soonest = 0;
  /// The cells that are touched no later than the first crossed one is; all touched where none is crossed.
  octant_set not_after = 0;
  octant_number first_crossed = 0; ///< the crossed cell that is entered first, if any is crossed
};

/// A trial's ray or segment, as the oracle has it.
oracle::line line_of(const trial& t);
/// Plane k of the block, 0 <= k <= extent, not rounded.
oracle::plane_terms exact_plane(const trial& t, unsigned axis, unsigned k);

/// Exact, for every trial that passes judgeable().
truth truth_of(const trial& t);

/// Touched octants that were not visited: misses of a traversal that promises `touched`.
inline octant_set touched_missed(const truth& exact, const visited& answer) {
  return exact.touched & ~answer.set();
}
/// Owning octants that were not visited: misses of a traversal that promises `owned`.
inline octant_set owned_missed(const truth& exact, const visited& answer) {
  return exact.owned & ~answer.set();
}
/// Crossed octants that were not visited: misses under every convention.
inline octant_set crossed_missed(const truth& exact, const visited& answer) {
  return exact.crossed & ~answer.set();
}

/// The misses by the traversal's own promise.
inline octant_set misses(const truth& exact, const visited& answer, promise p) {
  if (p == promise::crossed)
    return crossed_missed(exact, answer);
  return promises_owned(p) ? owned_missed(exact, answer) : touched_missed(exact, answer);
}

/// The lengths of the ray that no visited octant covers: a bug under every convention.
inline unsigned gaps(const truth& exact, const visited& answer) {
  unsigned count = 0;
  for (unsigned i = 0; i < exact.length_count; ++i)
    count += (exact.lengths[i] & answer.set()) == 0 ? 1 : 0;
  return count;
}

/// Those of them that lie in a common face or edge of octants: the ray runs along the seam, and
/// nobody on either side of it was visited. None of these octants is crossed there.
inline unsigned seams(const truth& exact, const visited& answer) {
  unsigned count = 0;
  for (unsigned i = 0; i < exact.length_count; ++i)
    count += (exact.lengths[i] & answer.set()) == 0 && std::popcount(exact.lengths[i]) > 1 ? 1 : 0;
  return count;
}

/// Visited octants that the ray does not touch; where owning octants and no others are promised,
/// those that do not own. A sound test may report some within its rounding, an exact one may not.
inline octant_set spurious(const truth& exact, const visited& answer,
                           promise p = promise::touched) {
  return answer.set() & ~(p == promise::exactly_owned ? exact.owned : exact.touched);
}

/// The owning octants were visited in an order other than t's.
inline bool out_of_order(const truth& exact, const visited& answer) {
  unsigned at = 0; // the place in owner_order of the last owner seen
  for (unsigned i = 0; i < answer.size(); ++i) {
    if ((exact.owned >> answer[i] & 1) == 0)
      continue;
    unsigned place = at;
    while (place < exact.owners && exact.owner_order[place] != answer[i])
      ++place;
    if (place == exact.owners)
      return true; // it lies before `at`
    at = place;
  }
  return false;
}

/// Ulps by which the entry into a first cell may be off where nobody says otherwise.
inline constexpr double usual_tolerance = 16;

/// What is put down to rounding.
struct allowance {
  double tolerance = usual_tolerance; ///< of t, distance and face, in ulps of double
  /// By so much of |origin| and of the greater of |lo| and |hi|, on each axis, a cell's faces are moved
  /// outwards before one that is reported and not touched counts as far: 64 roundings of either.
  double reach = 0x1p-47;
};
inline constexpr double reach_in_float = 0x1p-18;
/// As the traversal says: of one in float 64 roundings are those of float.
allowance allowance_of(const traversal& under_test);

/// Spurious octants that rounding does not explain: the ray does not even touch the octant with its
/// faces moved outwards, as allowance says. Empty where products of the ray's components may leave the
/// range of double, since there nothing can be told from rounding.
octant_set far_spurious(const trial& t, const truth& exact, const visited& answer,
                        const allowance& allowed = {});

/// Of the missed octants those with a chord (the length of the ray in the closed octant) of more
/// than 1e-3 of their greatest edge: they are seen in a picture of the octant. Exact, by rationals.
octant_set gross(const trial& t, octant_set missed);

/// The kinds of finding, most serious first; a set of them is a finding_set. A gross miss is a
/// crossed miss too; a `seam` is a gap
/// in a face or an edge that octants have in common, a `gap` any other. `spurious` is one for an exact
/// promise only; `distance` and `face` are of what is said of a first cell's entry, `count` of a number of
/// crossings; the first five are those of `fault`, and leave nothing else to judge.
enum class finding : unsigned {
  crash,
  hang,
  exception,
  not_a_number,
  malformed,
  gross_miss,
  crossed_miss,
  gap,
  seam,
  miss,
  order,
  revisit,
  far_spurious,
  spurious,
  outside,
  distance,
  face,
  count
};
inline constexpr unsigned finding_kinds = 18;
std::string_view name_of(finding f);
/// What happened, as a clause: "the ray runs in the face of two voxels, and neither was reported".
std::string_view sentence_of(finding f);
/// By the names of name_of().
std::optional<finding> finding_of(std::string_view name);

using finding_set = unsigned;
constexpr finding_set bit(finding f) { return 1u << static_cast<unsigned>(f); }
/// The most serious of a set that is not empty.
inline finding worst(finding_set set) { return static_cast<finding>(std::countr_zero(set)); }

/// Everything that is told about one trial and one answer.
struct verdict {
  octant_set touched = 0, visited = 0, missed = 0, crossed_missed = 0, gross_missed = 0,
             touched_missed = 0, spurious = 0;
  unsigned gaps = 0;  ///< but for
  unsigned seams = 0; ///< these
  bool order_error = false;
  bool declined = false; ///< nothing was judged
  finding_set findings = 0;
};

/// The trial that an answer is for: t, with the ray that was received. Nothing when that is not a
/// ray, or when the trial was declined.
std::optional<trial> trial_answered(const trial& t, const visited& answer);

/// Judges an answer by its promise. Order is judged where owning octants are promised. `t` is the
/// trial that the answer is for.
///
/// A first cell's t is off by the tolerance at most, in ulps (2^-52) of the largest of |t|,
/// (|o| + |p|) / |d| on each axis of which a plane is met at the entry p, and the same of the largest
/// components; a distance in those times |d|. A face is right if its plane is met at the entry within this
/// tolerance; that none is entered, if the entry is as close to t = 0.
verdict judge(const trial& t, const truth& exact, const visited& answer, promise p,
              const allowance& allowed = {});

/// Judges an answer to t on the ray that was received.
verdict judge_answer(const trial& t, const visited& answer, promise p,
                     const allowance& allowed = {});

/// Whether the promise says something of these cells, or why not.
support::status judgeable(promise p, cell_kind cells);

/// Asks the traversal and judges the answer.
verdict judge(const trial& t, traversal& under_test);

} // namespace graze::fuzz
