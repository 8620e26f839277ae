#pragma once
/// Threads that the system may not give, and exceptions that end none of them.
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace graze::support {

/// At most as many may be asked for.
inline constexpr unsigned most_threads = 1024;

/// Runs `body` on several threads at the same time.
class thread_group {
public:
  /// Starts up to `wanted` threads, at least one. Where the system gives fewer, so many do the
  /// work, and one line on standard error says so; where it gives none, throws what says why.
  /// Once a body throws, `on_failure` is called: it asks the others to end.
  thread_group(unsigned wanted, std::function<void()> body, std::function<void()> on_failure = {});
  ~thread_group() = default; // joins
  thread_group(const thread_group&) = delete;
  thread_group& operator=(const thread_group&) = delete;

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(threads_.size()); }
  /// Waits so long, or until all have ended; whether they have.
  bool wait_for(std::chrono::milliseconds time);
  /// Waits for all; throws what the first body that failed has thrown.
  void join();

private:
  std::function<void()> body_, on_failure_;
  std::mutex state_; ///< of the next three
  std::condition_variable ended_;
  unsigned running_ = 0;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_; // the last: its end waits for the others' use
};

} // namespace graze::support
