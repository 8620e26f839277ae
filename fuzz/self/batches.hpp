#pragma once
/// Trials of operations over arrays: on every path the sets of the scalar functions, the bits of
/// the baseline, in either layout, and nothing written beside the result.
#include <graze/batch.hpp>
#include <self/subject.hpp>

namespace graze::fuzz::self {

/// An operation over arrays, in both layouts, and the scalar function whose sets it must give.
struct batch_operation {
  std::string name;
  std::function<void(batch::const_intervals x, batch::const_intervals y, batch::const_intervals z,
                     batch::intervals r)>
      arrays;
  std::function<void(std::span<const bounds> x, std::span<const bounds> y,
                     std::span<const bounds> z, std::span<bounds> r)>
      pairs;
  bounds (*scalar)(const bounds& x, const bounds& y, const bounds& z);
};
const std::vector<batch_operation>& batch_operations();

/// Trials of one of the operations on a path that runs here.
part spans_by(batch::path p, std::vector<batch_operation> operations = batch_operations());

subject batches_subject();

} // namespace graze::fuzz::self
