#include "program.hpp"
#include <algorithm>
#include <csignal>
#include <fmt/format.h>

namespace graze::fuzz {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free); // it is set in a signal handler

void listen_for_interrupts() {
  const auto on_signal = [](int) { interrupted.store(true); };
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

int bad_input(std::string why) {
  std::replace(why.begin(), why.end(), '\n', ' ');
  fmt::print(stderr, "graze-fuzz: {}\n", why);
  return 2;
}

CLI::Validator not_negative() {
  return {[](std::string& text) {
            return text.starts_with('-') ? text + " is negative" : std::string();
          },
          "", "not negative"};
}

} // namespace graze::fuzz
