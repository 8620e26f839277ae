#pragma once
/// The line on standard error while a program works: how much, how fast, how long still.
#include <cstdint>
#include <optional>
#include <string>

namespace graze::support {

/// How far a work is.
struct progress {
  std::uint64_t done = 0;
  std::uint64_t total = 0;       ///< 0: not known
  double seconds = 0;            ///< that it has taken
  double budget_seconds = 0;     ///< it ends after as many; 0: no limit
  std::uint64_t done_before = 0; ///< before this start, in
  double seconds_before = 0;     ///< so many seconds: no part of the rate
};

/// "987 ", "12.3 k", "1.23 M": three digits, before a unit.
std::string three_digits(double value);

/// "  42 %  1.23 Mpixels/s  0.8 s left"; without a total "12.3 Mrays  1.23 Mrays/s".
std::string progress_text(const progress& p, const char* unit);

/// Rewrites one line on a terminal, ten times a second; elsewhere prints a line a second, and only
/// where it is wanted.
class progress_line {
public:
  progress_line(const char* unit, bool wanted);
  ~progress_line() { clear(); }
  progress_line(const progress_line&) = delete;
  progress_line& operator=(const progress_line&) = delete;

  [[nodiscard]] bool is_shown() const { return terminal_ || wanted_; }
  /// `before` and `after` are put around the text.
  void show(const progress& p, const std::string& before = {}, const std::string& after = {});
  void note(const std::string& text);
  /// Wipes the line.
  void clear();

private:
  const char* unit_;
  bool terminal_, wanted_;
  bool dirty_ = false;
  std::optional<double> last_;
};

} // namespace graze::support
