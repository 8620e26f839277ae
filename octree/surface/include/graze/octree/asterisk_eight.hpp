#pragma once
/// The asterisks over eight boxes at once: the operations of asterisk.hpp, so the same bounds.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/asterisk.hpp>
#include <graze/octree/eight.hpp>

namespace graze::octree {

template <class Path>
struct angular<interval8<Path>> : detail::angular_intervals<interval8<Path>> {};

} // namespace graze::octree
