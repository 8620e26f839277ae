#pragma once
/// What is asked of the library in every environment: rows of operations, each with its answers to
/// the same operands as integers, so that nothing here depends on the environment itself.
#include <bit>
#include <cstdint>
#include <functional>
#include <graze/bounds.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace graze::environments {

/// The answers of a row: bounds, and whatever else is said.
class answers {
public:
  void bounds_are(double lo, double hi) { record(true, lo, hi); }
  void bounds_are(const bounds& x) { record(true, x.lo, x.hi); }
  void value_is(double x) { record(false, x, x); }
  void says(std::uint64_t n) { all_.push_back({false, n, n}); }
  void says(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text)
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    says(hash);
  }
  [[nodiscard]] std::size_t size() const { return all_.size(); }

  struct differences {
    std::size_t different, unsound;
  };
  /// Beside the answers at a program's start, which are tightest: unsound are bounds that do not
  /// hold those, and any other answer that differs. Zeros of either sign are one.
  [[nodiscard]] differences from(const answers& right) const;

private:
  struct answer {
    bool is_bounds;
    std::uint64_t lo, hi;
  };
  void record(bool is_bounds, double lo, double hi) {
    all_.push_back({is_bounds, std::bit_cast<std::uint64_t>(lo), std::bit_cast<std::uint64_t>(hi)});
  }
  std::vector<answer> all_;
};

/// What holds for a row where the environment is not that of a program's start.
enum class promise {
  immune,             ///< the same answers everywhere
  immune_to_flushing, ///< where the mode is to-nearest; rounding::refusal_for_nearest() tells
};

struct row {
  std::string name;
  promise promised;
  std::function<void(answers&)> ask;
};

/// Every `thinning`-th tuple of operands.
std::vector<row> rows_of_functions(unsigned thinning);
std::vector<row> rows_of_types(unsigned thinning);
std::vector<row> rows_of_octrees();

/// Doubles at which environments differ, as bits: subnormal ones, those whose errors are, and
/// ordinary ones.
const std::vector<double>& edge_numbers();
/// All intervals between two of them.
const std::vector<bounds>& edge_intervals();

} // namespace graze::environments
