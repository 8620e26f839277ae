#pragma once
/// One rule for SIGINT, SIGTERM and SIGHUP. The first asks for an orderly end: stop_wanted is set,
/// and whoever works for long asks it. What does not end soon enough is ended within a second, and
/// so is all by a second signal; the exit code is then 130.
#include <atomic>

namespace graze::support {

/// Set by the first signal after listen_for_interrupts(), and by request_stop().
extern std::atomic<bool> stop_wanted;

/// A signal came.
[[nodiscard]] bool interrupted();

/// From here on. SIGHUP stays ignored where it was (nohup).
void listen_for_interrupts();

/// An end for another reason: what is printed cannot be written, a thread has no memory.
void request_stop();

/// What has been done is being written: that may take its time.
void end_is_orderly();

/// In a child that has its parent's handlers: the parent says when to end.
void ignore_interrupts();

} // namespace graze::support
