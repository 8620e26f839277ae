#pragma once
/// The options of graze-fuzz that choose a traversal in another process.
#include <CLI/CLI.hpp>
#include <external/external.hpp>

namespace graze::fuzz {

struct command_options {
  external_options external;
  std::string promised;
  bool plain = false;
};

/// Adds --command and what goes with it; `other` is the option that it excludes.
void add_command_options(CLI::App& app, CLI::Option& other, command_options& options);

/// What they ask for, checked; no command is started.
expected<external_options> external_of(const command_options& options);

/// The traversal of these options, or else that of the name; the reason when there is none.
expected<traversal_entry> chosen_traversal(const std::string& name, const command_options& options,
                                           bool show_errors);

} // namespace graze::fuzz
