#pragma once
/// A portable seeded generator of random bits: the same numbers on every machine and compiler.
/// xoshiro256++ and splitmix64: Blackman and Vigna, "Scrambled linear pseudorandom number
/// generators", ACM TOMS 47 (2021).
#include <array>
#include <bit>
#include <cstdint>
#include <graze/oracle/random_bits.hpp>

namespace graze::fuzz {

using oracle::mix;

/// The stream `index` of `seed`: ray k of a campaign is stream k, so that it can be made again
/// alone, whichever thread made it first.
class random_stream {
public:
  random_stream(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t x = mix(seed) ^ mix(~index);
    for (auto& word : state_)
      word = mix(x++);
  }

  std::uint64_t bits() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }
  /// The top n bits, 0 <= n <= 64.
  std::uint64_t bits(int n) { return n == 0 ? 0 : bits() >> (64 - n); }
  /// Uniform in 0..n-1, n > 0 (biased by less than n / 2^32: no matter here).
  unsigned below(unsigned n) {
    return static_cast<unsigned>(((bits() >> 32) * std::uint64_t{n}) >> 32);
  }
  /// Uniform in lo..hi.
  int between(int lo, int hi) {
    return lo + static_cast<int>(below(static_cast<unsigned>(hi - lo) + 1));
  }
  /// True once in n times.
  bool one_in(unsigned n) { return below(n) == 0; }
  bool coin() { return (bits() >> 63) != 0; }
  double sign() { return coin() ? 1.0 : -1.0; }

private:
  std::array<std::uint64_t, 4> state_;
};

} // namespace graze::fuzz
