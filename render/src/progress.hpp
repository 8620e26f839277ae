#pragma once
/// The line on stderr while a picture is made.
#include <cstdint>
#include <string>

namespace graze::render {

/// "  42 %  1.23 M pixels/s  0.8 s left"
std::string progress_text(std::uint64_t done, std::uint64_t total, double seconds);
/// "987", "12.3 k", "1.23 M": three digits.
std::string three_digits(double value);

/// Rewrites one line on a terminal; elsewhere prints a line a second. Silent if not wanted.
class progress_line {
public:
  enum class mode { automatic, always };
  /// `automatic` is silent unless stderr is a terminal.
  explicit progress_line(mode wanted);
  ~progress_line();
  progress_line(const progress_line&) = delete;
  progress_line& operator=(const progress_line&) = delete;
  void show(std::uint64_t done, std::uint64_t total, double seconds);
  /// Wipes the line.
  void clear();

private:
  bool terminal_;
  bool silent_;
  bool dirty_ = false;
  double last_ = -1;
};

} // namespace graze::render
