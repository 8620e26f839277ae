#include <algorithm>
#include <generate/climb.hpp>
#include <generate/margin.hpp>
#include <generate/mutate.hpp>
#include <generate/tame.hpp>

namespace graze::fuzz {

namespace {
/// Margins below this are alike (ulps).
constexpr double level_ground = 0x1p-4;
constexpr int attempts = 4;

double height_of(const trial& t) { return std::max(margin(t), level_ground); }
} // namespace

climber::climber(const trial& start, std::uint64_t seed, std::uint64_t number, bool tame)
    : random_(~seed, number), at_(start), height_(height_of(start)), tame_(tame) {}

trial climber::next() {
  trial candidate;
  for (int i = 0; i < attempts; ++i) {
    candidate = mutated(random_, at_);
    if (tame_ && !is_tame(candidate)) {
      candidate = at_;
      continue;
    }
    if (const double height = height_of(candidate); height <= height_) {
      height_ = height;
      at_ = candidate;
      break;
    }
  }
  return candidate;
}

} // namespace graze::fuzz
