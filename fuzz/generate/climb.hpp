#pragma once
/// Hill climbing towards the smallest margin, from a generator's ray. What it makes depends on the
/// start and the seed alone, not on the traversal: a climb is one more way of making rays.
#include <generate/random.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

/// The rays of a climb, the start included: ray k of a campaign is step k mod climb_length.
inline constexpr unsigned climb_length = 256;

/// One climb.
class climber {
public:
  /// With `tame` it stays among tame rays (generate/tame.hpp), where it starts at one.
  climber(const trial& start, std::uint64_t seed, std::uint64_t number, bool tame = false);

  [[nodiscard]] const trial& at() const { return at_; }
  /// A mutated trial whose margin is not larger; below an ulp all margins are alike, so that it
  /// goes about there. After a few that are larger it stays where it is, and the last of them is
  /// told.
  trial next();

private:
  random_stream random_;
  trial at_;
  double height_;
  bool tame_;
};

} // namespace graze::fuzz
