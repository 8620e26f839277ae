#include <algorithm>
#include <graze/support/output.hpp>
#include <graze/support/threads.hpp>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace graze::support {

thread_group::thread_group(unsigned wanted, std::function<void()> body,
                           std::function<void()> on_failure)
    : body_(std::move(body)), on_failure_(std::move(on_failure)) {
  wanted = std::max(1u, wanted);
  threads_.reserve(wanted);
  const auto run = [this] {
    std::exception_ptr failure;
    try {
      body_();
    } catch (...) {
      failure = std::current_exception();
      if (on_failure_)
        on_failure_();
    }
    const std::lock_guard lock(state_);
    if (!failure_)
      failure_ = failure;
    --running_;
    ended_.notify_all();
  };
  const auto count = [this](int more) {
    const std::lock_guard lock(state_);
    running_ += static_cast<unsigned>(more);
  };
  for (unsigned i = 0; i < wanted; ++i) {
    count(1);
    try {
      threads_.emplace_back(run);
    } catch (const std::exception& e) { // no thread, or no memory for one
      count(-1);
      const auto* const refusal = dynamic_cast<const std::system_error*>(&e);
      const std::string why = refusal != nullptr ? refusal->code().message() : "not enough memory";
      if (i == 0)
        throw std::runtime_error("cannot start a thread: " + why);
      complain("only " + std::to_string(i) + " of " + std::to_string(wanted) +
               " threads could be started: " + why);
      return;
    }
  }
}

bool thread_group::wait_for(std::chrono::milliseconds time) {
  std::unique_lock lock(state_);
  return ended_.wait_for(lock, time, [this] { return running_ == 0; });
}

void thread_group::join() {
  threads_.clear();
  if (failure_)
    std::rethrow_exception(std::exchange(failure_, {}));
}

} // namespace graze::support
