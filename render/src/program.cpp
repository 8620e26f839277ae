#include "program.hpp"
#include <csignal>

namespace graze::render {

std::atomic<bool> stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free); // it is set in a signal handler

void listen_for_interrupts() {
  struct sigaction action{};
  action.sa_handler = [](int) { stop_wanted.store(true, std::memory_order_relaxed); };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  signal(SIGXFSZ, SIG_IGN); // a limit on file sizes is an error of write(), with its own message
}

} // namespace graze::render
