#pragma once
/// A finding as a test in the language of whoever is to mend it: the ray by the bits of its doubles, the voxel,
/// and what must be visited; a function that asks the adapter, or is to be filled in. It needs nothing but
/// the language's own library.
#include <optional>
#include <report/reproducer/reproducer.hpp>

namespace graze::fuzz {

/// By the names of name_of().
std::optional<language> language_of(std::string_view name);
std::string_view name_of(language l);
/// What the words of a command look like; C++ where they say nothing.
language language_of_command(std::string_view command);

/// The test's file name, and its text.
std::string test_file_name(const reproduction& r, language l);
std::string test_file(const reproduction& r, language l);

} // namespace graze::fuzz
