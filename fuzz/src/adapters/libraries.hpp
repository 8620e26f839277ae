#pragma once
/// Adapters to libraries that are not in bench/peers, a file each.
#include <graze/fuzz/traversal.hpp>

namespace graze::fuzz {

std::unique_ptr<traversal> make_embree();
std::unique_ptr<traversal> make_embree_robust();

} // namespace graze::fuzz
