#pragma once
/// Text formulas for tests.
#include <catch2/catch.hpp>
#include <graze/octree_formula.hpp>
#include <span>
#include <string>

namespace support {

/// The formula; the test fails where it is refused.
inline graze::octree::formula parsed(const std::string& text,
                                     std::span<const graze::octree::parameter> set = {}) {
  const auto f = graze::octree::formula::parse(text, nullptr, set);
  INFO(text << ": " << f.reason());
  REQUIRE(f);
  return *f;
}

/// [-reach, reach]^3
inline graze::octree::box cube_of(double reach) {
  return {{-reach, -reach, -reach}, {reach, reach, reach}};
}

} // namespace support
