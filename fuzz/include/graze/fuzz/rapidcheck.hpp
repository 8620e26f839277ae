#pragma once
/// The generators for RapidCheck, with the same shrinking and hex floats. Only for programs that
/// link to it: nothing else in graze needs RapidCheck. RapidCheck's own doubles never are
/// subnormal, shrink by truncation and print six digits.
#include <graze/fuzz/generators.hpp>
#include <graze/fuzz/replay.hpp>
#include <graze/fuzz/shrink.hpp>
#include <ostream>
#include <rapidcheck.h>

namespace graze::fuzz {

/// What RapidCheck prints: the replay line, exact.
inline void showValue(const trial& t, std::ostream& out) { out << to_json_line(t); }

/// Trials of one generator at a level.
inline rc::Gen<trial> trials_of(const generator& g, int level) {
  return [&g, level](const rc::Random& random, int) {
    const std::uint64_t seed = rc::Random(random).next();
    return rc::shrinkable::shrinkRecur(make_trial(g, seed, 0, level), [](const trial& t) {
      return rc::seq::fromContainer(simpler(t));
    });
  };
}

/// Trials of all generators at levels 1 to 53.
inline rc::Gen<trial> any_trial() {
  return rc::gen::mapcat(rc::gen::inRange(1, octree::max_level + 1), [](int level) {
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, generators().size()),
                           [level](std::size_t g) { return trials_of(generators()[g], level); });
  });
}

} // namespace graze::fuzz
