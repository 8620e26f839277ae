#include <algorithm>
#include <fmt/format.h>
#include <graze/support/output.hpp>
#include <graze/support/progress.hpp>
#include <unistd.h>

namespace graze::support {

std::string three_digits(double value) {
  if (value >= 1e6)
    return fmt::format("{:.3g} M", value / 1e6);
  if (value >= 1e3)
    return fmt::format("{:.3g} k", value / 1e3);
  return fmt::format("{:.3g} ", value);
}

std::string progress_text(const progress& p, const char* unit) {
  const double rate = p.seconds > p.seconds_before ? static_cast<double>(p.done - p.done_before) /
                                                         (p.seconds - p.seconds_before)
                                                   : 0;
  std::optional<double> left;
  if (p.total != 0 && rate > 0)
    left = static_cast<double>(p.total - std::min(p.done, p.total)) / rate;
  if (p.budget_seconds != 0)
    left = std::min(left.value_or(p.budget_seconds), std::max(p.budget_seconds - p.seconds, 0.0));
  return fmt::format("{}  {}{}/s{}",
                     p.total != 0 ? fmt::format("{:3.0f} %", 100 * static_cast<double>(p.done) /
                                                                 static_cast<double>(p.total))
                                  : three_digits(static_cast<double>(p.done)) + unit,
                     three_digits(rate), unit, left ? fmt::format("  {:.1f} s left", *left) : "");
}

progress_line::progress_line(const char* unit, bool wanted)
    : unit_(unit), terminal_(isatty(STDERR_FILENO) == 1), wanted_(wanted) {}

void progress_line::show(const progress& p, const std::string& before, const std::string& after) {
  if (!is_shown() || (last_ && p.seconds - *last_ < (terminal_ ? 0.1 : 1)))
    return;
  last_ = p.seconds;
  note(before + progress_text(p, unit_) + after);
}

void progress_line::note(const std::string& text) {
  if (!is_shown())
    return;
  print_error(terminal_ ? "\r\x1b[K" + text : text + '\n');
  dirty_ = terminal_;
}

void progress_line::clear() {
  if (dirty_)
    print_error("\r\x1b[K");
  dirty_ = false;
}

} // namespace graze::support
