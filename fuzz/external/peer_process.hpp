#pragma once
/// A program at the other end of two pipes. POSIX.
#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <thread>

namespace graze::fuzz {

/// A traversal could not be asked, for want of processes, pipes or descriptors: no fault of its own.
class cannot_ask : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Runs `sh -c COMMAND` in a process group of its own; lines go to its standard input and come from
/// its standard output. Writing never waits for a peer that does not read: both directions move
/// while a line is waited for, so that full pipes cannot lock the two up. The process is killed
/// when the thread that started it ends, and its group by a keeper when this process ends, however
/// that ends: nothing is left of a campaign that was killed.
class peer_process {
public:
  using clock = std::chrono::steady_clock;
  enum class outcome { line, ended, silent, too_long };

  /// Its standard error goes to this descriptor, or nowhere if that is negative. Lines that are longer
  /// than so many bytes are too_long.
  peer_process(std::string command, int errors, std::size_t longest_line)
      : command_(std::move(command)), errors_(errors), longest_line_(longest_line) {}
  ~peer_process() { stop(); }
  peer_process(const peer_process&) = delete;
  peer_process& operator=(const peer_process&) = delete;

  /// Throws cannot_ask when the system has no pipe or process to give.
  void start();
  /// Closes the pipes, waits a moment for the end, and kills what is left of the process group.
  void stop(std::chrono::milliseconds patience = std::chrono::milliseconds(100));
  /// It was started, by this thread, and not stopped.
  [[nodiscard]] bool ours() const { return pid_ > 0 && starter_ == std::this_thread::get_id(); }

  void send(std::string_view text) { pending_ += text; }
  /// The next line without its end.
  outcome read_line(std::string& line, clock::time_point deadline);
  /// There is output that was not read, or the process has closed its output.
  bool unread();
  /// The same, of what has already arrived.
  [[nodiscard]] bool unread_now() const { return read_ < buffer_.size(); }
  /// How the process ended that was stopped last: "exit code 1", "signal 11", or "no exit".
  [[nodiscard]] const std::string& ending() const { return ending_; }
  /// It ended by itself, with exit code 0.
  [[nodiscard]] bool ended_well() const { return ended_well_; }

private:
  bool wait_for_data(clock::time_point deadline);
  void write_some();

  std::string command_;
  int errors_;
  std::size_t longest_line_;
  pid_t pid_ = -1;
  std::thread::id starter_;
  int to_ = -1, from_ = -1;
  bool closed_ = false; ///< the peer has closed its output
  std::string pending_; ///< to be written
  std::string buffer_;  ///< read, from read_ on not yet handed out
  std::size_t read_ = 0;
  std::string ending_ = "no exit";
  bool ended_well_ = false;
};

} // namespace graze::fuzz
