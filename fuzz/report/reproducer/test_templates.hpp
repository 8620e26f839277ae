#pragma once
/// The tests of test_file.hpp with "@NAME@" where a finding's numbers go, one a language.
#include <report/reproducer/reproducer.hpp>

namespace graze::fuzz {

std::string_view test_template(language l);

} // namespace graze::fuzz
