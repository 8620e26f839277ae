#pragma once
/// What graze-fuzz's subcommands share: a complaint, an interrupt, checks of options.
#include <CLI/CLI.hpp>
#include <atomic>
#include <string>

namespace graze::fuzz {

/// Set once SIGINT or SIGTERM has come, after listen_for_interrupts().
extern std::atomic<bool> interrupted;
void listen_for_interrupts();

/// Prints the reason as one line on stderr; gives the exit code of bad input, 2.
int bad_input(std::string why);

/// The parser takes -5 for an unsigned number and wraps it; this refuses it.
CLI::Validator not_negative();

} // namespace graze::fuzz
