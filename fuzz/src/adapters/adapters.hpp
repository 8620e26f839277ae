#pragma once
/// The traversals of others that are written here from their papers, a file each. To add one: a
/// file with its maker, a line here, one in adapters.cpp and one in CMakeLists.txt.
#include <graze/fuzz/traversal.hpp>

namespace graze::fuzz {

std::unique_ptr<traversal> make_amanatides_woo(std::string_view name);
std::unique_ptr<traversal> make_williams(std::string_view name);
std::unique_ptr<traversal> make_ize(std::string_view name);
std::unique_ptr<traversal> make_tavian(std::string_view name);
std::unique_ptr<traversal> make_pbrt(std::string_view name);
/// Not a peer: exact rationals, slow, the reference that nothing may accuse.
std::unique_ptr<traversal> make_rational(std::string_view name);

} // namespace graze::fuzz
