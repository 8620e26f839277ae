#pragma once
/// Asks a question in each of the four rounding modes.
#include <array>
#include <cfenv>

namespace graze::octree::test {

inline constexpr std::array<int, 4> rounding_modes{FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                                   FE_TOWARDZERO};

/// The common answer of `ask()` in the four modes, or a value that is no answer (~0) where they
/// differ.
template <class Ask> auto in_all_modes(Ask ask) {
  const int found = std::fegetround();
  using answer = decltype(ask());
  answer first{};
  bool same = true;
  for (const int mode : rounding_modes) {
    std::fesetround(mode);
    const answer now = ask();
    if (mode == rounding_modes[0])
      first = now;
    same = same && now == first;
  }
  std::fesetround(found);
  return same ? first : static_cast<answer>(~answer{});
}

} // namespace graze::octree::test
