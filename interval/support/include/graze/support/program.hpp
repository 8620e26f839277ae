#pragma once
/// How every program starts, is asked, reports and ends.
///
/// Exit codes: 0 done, nothing found; 1 a finding, or what the program's own help says; 2 bad input,
/// and whatever failed: memory, threads, files, standard output; 130 interrupted.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <graze/support/interrupts.hpp>
#include <graze/support/output.hpp>
#include <graze/support/threads.hpp>
#include <optional>
#include <string>

namespace graze::support {

enum exit_code { done = 0, found = 1, refused = 2, ended_by_signal = 130 };

/// The main() of every program: the exit code of `body`, but 2 with one line where bounds do not hold on
/// this machine (rounding::program_may_start), where `body` throws, and where something that it
/// printed could not be written.
int run_program(const char* name, int argc, char** argv, int (*body)(int argc, char** argv));

/// Ends at once, threads that are still at work included, after what was printed is written.
[[noreturn]] void end_program(int code);

/// Of all programs: "0.1.0".
const char* version();

/// Adds --version, to subcommands too. Then parses; gives an exit code where that is all: help, version, bad input.
std::optional<int> parse_arguments(CLI::App& app, int argc, char** argv);

/// One line on standard error; gives 2.
int bad_input(std::string_view reason);

/// The parser wraps -5 where an unsigned number is wanted, and takes what is too large for the
/// largest; this refuses both.
CLI::Validator whole_number();

/// From here on this process allocates no more than nine tenths of the memory that is free now (of the
/// machine, or of its control group where that has less), so that a scene that asks for more is refused
/// ("not enough memory", exit code 2) and nothing is ended by the system. A lower limit that is set
/// stays. For programs that start no others, which would inherit it. Does nothing where the system does
/// not say what is free, and under sanitizers, which reserve memory that they do not use.
void limit_memory();

/// One a core, at most as many as may be asked for.
unsigned default_threads();

template <class... T> void print(fmt::format_string<T...> format, T&&... values) {
  print_text(fmt::format(format, std::forward<T>(values)...));
}

} // namespace graze::support
