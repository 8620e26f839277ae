#pragma once
/// A traversal in another process, in any language, driven by lines (docs/adapters.md).
#include <external/line_protocol.hpp>
#include <traversal/list.hpp>

namespace graze::fuzz {

struct external_options {
  std::string command;             ///< for sh -c
  std::optional<promise> promised; ///< instead of what it says itself; else `crossed`
  double seconds_a_ray = 2;        ///< a longer silence is a hang
  double start_seconds = 30;       ///< for its first answer of all, beyond that
  line_format format = line_format::json;
  bool as_float = false;    ///< rays are rounded to float before they are sent, and judged so
  bool show_errors = false; ///< its standard error is ours
};

/// The traversal behind a command; each that is made has a process of its own, started when it is
/// first asked, and again after each fault. Several rays are sent at a time. After a fault among
/// several rays, those that have no answer are asked again one at a time, so that the fault is that
/// of the ray which brings it on (output that was not flushed when the process ended, or a slow
/// moment of the machine, must not be blamed on others). A fault that does not come again is booked
/// on the last of them, unless it was a hang.
///
/// The command is tried with one ray first: refused, with the reason, when it gives no answer to
/// it.
expected<traversal_entry> external_traversal(const external_options& options);

/// The same, not tried: for a program that is known to be there. Its promise is given.
traversal_entry untried_external_traversal(const external_options& options, std::string_view name,
                                           std::string_view summary);

/// As one word of a shell's command line.
std::string shell_word(std::string_view text);

/// How a user asks for it: "--command '...' ...".
std::string spelled(const external_options& options);

} // namespace graze::fuzz
