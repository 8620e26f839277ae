#pragma once
/// The generators for RapidCheck, with the same shrinking and hex floats. Only for programs that
/// link to it: nothing else in graze needs RapidCheck. RapidCheck's own doubles never are
/// subnormal, shrink by truncation and print six digits.
#include <generate/generators.hpp>
#include <generate/mutate.hpp>
#include <ostream>
#include <rapidcheck.h>
#include <shrink/shrink.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

/// What RapidCheck prints: the replay line, exact.
inline void showValue(const trial& t, std::ostream& out) { out << to_json_line(t); }

/// A trial that shrinks as the campaign's do.
inline rc::Shrinkable<trial> shrinkable(const trial& t) {
  return rc::shrinkable::shrinkRecur(
      t, [](const trial& larger) { return rc::seq::fromContainer(simpler(larger)); });
}

/// Trials of one generator at a level.
inline rc::Gen<trial> trials_of(const generator& g, int level) {
  return [&g, level](const rc::Random& random, int) {
    return shrinkable(make_trial(g, rc::Random(random).next(), 0, level));
  };
}

/// Trials of all generators at levels 1 to 53.
inline rc::Gen<trial> any_trial() {
  return rc::gen::mapcat(rc::gen::inRange(1, octree::max_level + 1), [](int level) {
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, generators().size()),
                           [level](std::size_t g) { return trials_of(generators()[g], level); });
  });
}

/// Trials of all generators at levels 1 to 53, after up to 16 moves of the hill climb: other roots,
/// level 0 and blocks of all shapes among them.
inline rc::Gen<trial> any_mutated_trial() {
  return [](const rc::Random& random, int) {
    random_stream stream(rc::Random(random).next(), 0);
    const auto& kinds = generators();
    trial t = make_trial(kinds[stream.below(static_cast<unsigned>(kinds.size()))], stream.bits(), 0,
                         stream.between(1, octree::max_level));
    for (unsigned moves = stream.below(17); moves > 0; --moves)
      t = mutated(stream, t);
    return shrinkable(t);
  };
}

} // namespace graze::fuzz
