#pragma once
/// The libraries of fuzz/peers, each driven by a program of its own.
#include <external/external.hpp>

namespace graze::fuzz {

/// The folder of the adapters' programs: the environment's GRAZE_ADAPTERS, or that of this program.
std::string folder_of_adapters();

/// A traversal for each variant of each adapter that was built: of the programs graze-adapter-NAME
/// beside this program, or in the folder that the environment's GRAZE_ADAPTERS names, which are
/// asked what they have. Of `like`, the seconds a ray and what becomes of standard error are taken.
std::vector<traversal_entry> library_traversals(const external_options& like = {});

/// The traversal of this name: one of this program's, or a library's; the reason when there is
/// none. With a map in `like` a library's traversal is built from its file.
expected<traversal_entry> named_traversal(const std::string& name,
                                          const external_options& like = {});

} // namespace graze::fuzz
