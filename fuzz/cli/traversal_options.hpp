#pragma once
/// The options of graze-fuzz that choose a traversal.
#include <CLI/CLI.hpp>
#include <external/external.hpp>
#include <report/reproducer/reproducer.hpp>

namespace graze::fuzz {

struct traversal_options {
  external_options external;
  std::string promised;
  bool plain = false, bits = false;
};

/// Adds --command and what goes with it; `other` is the option that it excludes.
void add_traversal_options(CLI::App& app, CLI::Option& other, traversal_options& options);

/// What they ask for, checked; no command is started.
expected<external_options> external_of(const traversal_options& options);

/// external_traversal(), whose notices are told on standard error.
expected<traversal_entry> tried_traversal(const external_options& options);

/// The traversal of these options, or else that of the name; the reason when there is none.
expected<traversal_entry> chosen_traversal(const std::string& name,
                                           const traversal_options& options, bool show_errors);

/// What --tame, --except and --hangs do: of rays, for those who search.
inline constexpr const char* tame_option = "Tame rays only, as an owner has them: the origin at "
                                           "most 16 root sizes outside the root, its components 0 "
                                           "or normal and at least 2^-80 root sizes, those of the "
                                           "direction 0 or normal and within 2^40 of each other, "
                                           "the largest between 2^-40 and 2^40; other rays are "
                                           "replaced by such that are hard in the same respect. "
                                           "Ray k of a seed is always the same tame ray";
inline constexpr const char* except_option = "Names of generators that are left out";
inline constexpr const char* hangs_option = "After so many hangs of a generator its rays are sent "
                                            "no more (each costs --timeout seconds; of each "
                                            "piece in a campaign); 0: no limit";

/// What --reproducer does.
inline constexpr const char* reproducer_option =
    "Write the shrunk counterexample to this folder: replay line, text, and a test in the language "
    "of "
    "--language; of a ray through octants a C++ snippet and a picture too";

/// Says on standard error that there is no test, where there is none.
void tell_of_test(const written_reproducer& written);

/// Adds --language; gives for whom reproducers are written, once options were parsed.
void add_language_option(CLI::App& app, std::string& language);
reader_of_test reader_of(const std::string& language, const traversal_options& options,
                         const traversal_entry& chosen);

} // namespace graze::fuzz
