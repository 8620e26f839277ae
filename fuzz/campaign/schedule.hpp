#pragma once
/// One way for trials to reach workers, for all searches.
#include <atomic>
#include <campaign/plan.hpp>
#include <chrono>
#include <functional>

namespace graze::fuzz {

/// Trials [begin, end) of a plan, counted from its first.
struct stretch {
  std::uint64_t begin, end;
};

/// Hands out a plan's trials in stretches of a size, lowest first, until all are handed out, the time is
/// used up, it is ended, or `stop` becomes true. What workers find is put together by its trials' numbers,
/// so that it does not depend on who had which stretch. It owns nothing and may lie in memory that forked
/// processes share, each of which then asks its own copy of `stop`.
class schedule {
public:
  schedule(const trial_plan& p, std::uint64_t size, const std::atomic<bool>& stop)
      : trials_(p.trials), seconds_(p.seconds), size_(size), stop_(stop) {}

  /// Nothing once it has ended.
  std::optional<stretch> take();
  [[nodiscard]] bool has_ended() const {
    return stop_.load(std::memory_order_relaxed) || ended_.load(std::memory_order_relaxed) ||
           (seconds_ != 0 && seconds() >= seconds_);
  }
  void end() { ended_.store(true, std::memory_order_relaxed); }

  /// So many more trials are answered.
  void count(std::uint64_t trials) { done_.fetch_add(trials, std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t done() const { return done_.load(std::memory_order_relaxed); }
  /// Since it was made.
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::uint64_t trials_;
  double seconds_;
  std::uint64_t size_;
  const std::atomic<bool>& stop_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> next_{0}, done_{0};
  std::atomic<bool> ended_{false};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "shared by processes");
};

/// Trials answered, and seconds: called about ten times a second, from the thread that waits.
using progress_listener = std::function<void(std::uint64_t, double)>;

/// Runs `body`, which takes stretches until there are none, on so many threads and waits for them. When one
/// throws the schedule ends, and so does this, by what was thrown.
void run_on_threads(schedule& stretches, unsigned threads, const std::function<void()>& body,
                    const progress_listener& progress = {});

} // namespace graze::fuzz
