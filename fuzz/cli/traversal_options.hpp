#pragma once
/// The options of graze-fuzz that choose a traversal.
#include <CLI/CLI.hpp>
#include <external/external.hpp>

namespace graze::fuzz {

struct traversal_options {
  external_options external;
  std::string promised;
  bool plain = false, bits = false;
};

/// A map in place of random cells.
struct map_choice {
  std::string path;
  double voxel_size = 0;
  bool cell_centred = false;
};
/// Adds --scene and what goes with it.
void add_map_options(CLI::App& app, map_choice& choice);
/// What they ask for, if anything.
expected<std::optional<map_file>> map_of(const map_choice& choice);

/// Adds --command and what goes with it; `other` is the option that it excludes.
void add_traversal_options(CLI::App& app, CLI::Option& other, traversal_options& options);

/// What they ask for, checked; no command is started.
expected<external_options> external_of(const traversal_options& options);

/// external_traversal(), whose notices are told on standard error.
expected<traversal_entry> tried_traversal(const external_options& options);

/// The traversal of these options, or else that of the name; the reason when there is none.
expected<traversal_entry> chosen_traversal(const std::string& name,
                                           const traversal_options& options, bool show_errors);

/// What --reproducer does.
inline constexpr const char* reproducer_option =
    "Write the shrunk counterexample to this folder: replay line, text, C++ snippet, picture";

} // namespace graze::fuzz
