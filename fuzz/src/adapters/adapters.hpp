#pragma once
/// The traversals of others that are written here from their papers. To add a ray/box test: a class
/// in slab_tests.hpp and a line in adapters.cpp. Another: a file with its maker, a line here, one
/// in adapters.cpp and one in CMakeLists.txt.
#include <graze/fuzz/traversal.hpp>

namespace graze::fuzz {

std::unique_ptr<traversal> make_amanatides_woo(std::string_view name);
/// Not a peer: exact rationals, slow, the reference that nothing may accuse.
std::unique_ptr<traversal> make_rational(std::string_view name);

} // namespace graze::fuzz
