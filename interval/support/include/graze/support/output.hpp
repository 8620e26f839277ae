#pragma once
/// Standard output that is checked at every size, and the one line on standard error.
#include <graze/support/status.hpp>
#include <string>
#include <string_view>

namespace graze::support {

/// Of this process, for its messages; set by start_output().
const char* program_name();

/// Before anything else in main(): what main() was started without (0, 1, 2 closed) is taken up, so
/// that no file gets the number of standard output, and a pipe without a reader and a limit on file
/// sizes are errors of write() rather than signals.
void start_output(const char* name);

/// To standard output. After a failure nothing more is written, and stop_wanted is set.
void print_text(std::string_view text);
/// Gives to the system what was printed.
void flush_output();
/// The same, at the end; the reason if anything that was printed could not be written.
status finish_output();

/// "NAME: text" as one line on standard error, controls removed; failures are of no consequence.
void complain(std::string_view text);
/// To standard error as it is.
void print_error(std::string_view text);

} // namespace graze::support
