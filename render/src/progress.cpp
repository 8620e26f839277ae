#include "progress.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace graze::render {

std::string three_digits(double value) {
  if (value >= 1e6)
    return fmt::format("{:.3g} M", value / 1e6);
  if (value >= 1e3)
    return fmt::format("{:.3g} k", value / 1e3);
  return fmt::format("{:.3g} ", value);
}

std::string progress_text(std::uint64_t done, std::uint64_t total, double seconds) {
  const double part = total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total);
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  const std::string left =
      rate > 0 ? fmt::format("{:.1f} s left", static_cast<double>(total - done) / rate) : "";
  return fmt::format("{:3.0f} %  {}pixels/s  {}", 100 * part, three_digits(rate), left);
}

progress_line::progress_line(mode wanted)
    : terminal_(isatty(STDERR_FILENO) == 1), silent_(wanted == mode::automatic && !terminal_) {}

progress_line::~progress_line() { clear(); }

void progress_line::show(std::uint64_t done, std::uint64_t total, double seconds) {
  if (silent_)
    return;
  const std::string text = progress_text(done, total, seconds);
  if (terminal_) {
    fmt::print(stderr, "\r\x1b[K{}", text);
    std::fflush(stderr);
    dirty_ = true;
  } else if (last_ < 0 || seconds - last_ >= 1) {
    fmt::print(stderr, "{}\n", text);
    last_ = seconds;
  }
}

void progress_line::clear() {
  if (!dirty_)
    return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  dirty_ = false;
}

} // namespace graze::render
