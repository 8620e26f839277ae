#pragma once
/// Hard operands for the trials of one operation.
#include <generate/random.hpp>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <graze/oracle/reverse_operands.hpp>
#include <self/interval_operations.hpp>

namespace graze::fuzz::self {

/// The seed of a trial's own sequences.
inline std::uint64_t seed_of_trial(std::uint64_t seed, std::uint64_t index) {
  return mix(mix(seed) ^ mix(~index));
}

/// Boxes alone, or made for each other.
inline interval_operands hard_operands_of(unsigned count, std::uint64_t s) {
  interval_operands o;
  o.count = count;
  if ((s & 1) != 0) {
    oracle::hard_intervals(s).next(o.boxes[0], o.boxes[1], o.boxes[2]);
  } else {
    oracle::hard_boxes boxes(s);
    for (bounds& x : o.boxes)
      x = boxes.next();
  }
  return o;
}

} // namespace graze::fuzz::self
