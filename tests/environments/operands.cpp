#include "rows.hpp"
#include <graze/rounding/exact.hpp>

namespace graze::environments {

namespace {
bool is_nan(std::uint64_t bits) { return bits << 1 > std::uint64_t{0x7ff} << 53; }
std::int64_t rank_of(std::uint64_t bits) {
  return rounding::exact::rank(std::bit_cast<double>(bits));
}
bool same(std::uint64_t x, std::uint64_t y) {
  return is_nan(x) || is_nan(y) ? is_nan(x) && is_nan(y) : rank_of(x) == rank_of(y);
}
} // namespace

answers::differences answers::from(const answers& right) const {
  differences d{0, 0};
  if (all_.size() != right.all_.size())
    return {all_.size() + 1, all_.size() + 1};
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const answer &got = all_[i], &tightest = right.all_[i];
    if (same(got.lo, tightest.lo) && same(got.hi, tightest.hi))
      continue;
    ++d.different;
    const bool holds = got.is_bounds && !is_nan(got.lo) && !is_nan(got.hi) &&
                       (is_nan(tightest.lo) || (rank_of(got.lo) <= rank_of(tightest.lo) &&
                                                rank_of(tightest.hi) <= rank_of(got.hi)));
    d.unsound += holds ? 0 : 1;
  }
  return d;
}

const std::vector<double>& edge_numbers() {
  static const std::vector<double> all = [] {
    const std::uint64_t magnitudes[] = {
        0,                  // 0
        1,                  // 2^-1074
        3,                  // 3 2^-1074
        0x0004000000000000, // 2^-1024
        0x0008000000000001, // 2^-1023 and the last bit
        0x0010000000000000, // 2^-1022
        0x0018000000000000, // 1.5 2^-1022
        0x0360000000000001, // 2^-969 and its last bit
        0x1eb0000000000000, // 2^-532
        0x1f10000000000001,
        0x3fe0000000000000, // 1/2
        0x3ff0000000000000, // 1
        0x3ff8000000000000, // 1.5
        0x400921fb54442d18, // pi
        0x4340000000000001,
        0x5f30000000000000, // 2^500
        0x7fe0000000000000, // 2^1023
        0x7fefffffffffffff, // the greatest
        0x7ff0000000000000, // infinity
    };
    std::vector<double> r;
    for (const std::uint64_t m : magnitudes) {
      r.push_back(std::bit_cast<double>(m));
      if (m != 0)
        r.push_back(std::bit_cast<double>(m | std::uint64_t{1} << 63));
    }
    return r;
  }();
  return all;
}

const std::vector<bounds>& edge_intervals() {
  static const std::vector<bounds> all = [] {
    std::vector<bounds> r{bounds::empty()};
    const std::int64_t infinite = rounding::exact::rank(checking::infinity);
    for (const double lo : edge_numbers())
      for (const double hi : edge_numbers()) {
        const std::int64_t a = rounding::exact::rank(lo), b = rounding::exact::rank(hi);
        if (a <= b && a != infinite && b != -infinite)
          r.push_back({lo, hi});
      }
    return r;
  }();
  return all;
}

} // namespace graze::environments
