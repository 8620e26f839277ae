#pragma once
/// What a campaign on our own code is about: a subject, its parts, and what can be wrong with an
/// answer. Nothing here knows of processes or budgets.
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::fuzz::self {

/// What can be wrong, most serious first.
enum class flaw : unsigned {
  crash,        ///< a signal, an abort, an exception; for a loader: a byte read beyond its input
  hang,         ///< no answer in the time of the plan
  unsound,      ///< a bound that does not hold
  wrong_empty,  ///< empty where the answer is not, or the other way round
  dropped,      ///< an octant that holds a point of the surface is not kept
  control_word, ///< MXCSR or the x87's control word is not as it was found
  accepted,     ///< damaged input is taken for good
  meaning,      ///< what was read is not what was written
  difference,   ///< two ways that promise the same bits differ
  decoration,   ///< a wrong decoration
  loose,        ///< sound, but wider than the tightest enclosure
  no_reason,    ///< refused without a reason of one line
};
inline constexpr unsigned flaw_kinds = 12;
std::string_view name_of(flaw f);

/// One flaw of one answer: a line, with numbers as hex floats.
struct observation {
  flaw kind;
  std::string what;
};
using observations = std::vector<observation>;

/// Trial `index` of a seed: the same trial on every machine, whatever ran before it. What costs
/// much to make (an octree) may be kept from trial to trial, if it is a function of the seed and
/// the index alone. Runs in a process of its own, in the mode that a program starts in.
using examination = std::function<void(std::uint64_t seed, std::uint64_t index, observations& out)>;

struct part {
  std::string name;
  examination examine;
};

/// Trial k is one of part k mod parts.size().
struct subject {
  std::string name;
  std::string summary;
  std::vector<part> parts;
};

/// The subjects of `graze-fuzz self`.
const std::vector<subject>& subjects();
/// Null when there is none of this name.
const subject* find_subject(std::string_view name);

} // namespace graze::fuzz::self
