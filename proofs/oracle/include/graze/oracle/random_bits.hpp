#pragma once
/// Random bits from a seed: the same on every machine, and made at no cost, so that each trial of a
/// campaign can have a sequence of its own. Source: splitmix64, Steele, Lea and Flood, "Fast
/// splittable pseudorandom number generators", OOPSLA 2014.
#include <cstdint>

namespace graze::oracle {

/// A step of splitmix64: a bijection of 64 bits that mixes well.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

class random_bits {
public:
  explicit random_bits(std::uint64_t seed) : state_(mix(seed)) {}
  std::uint64_t operator()() {
    const std::uint64_t result = mix(state_);
    state_ += 0x9e3779b97f4a7c15u;
    return result;
  }

private:
  std::uint64_t state_;
};

} // namespace graze::oracle
