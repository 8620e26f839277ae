#pragma once
/// Baseline `plain`: the sound formulas computed in round to nearest, so with no bound at all. It
/// stays in the code to be measured against; it misses octants.
#include <graze/octree/sound.hpp>

namespace graze::peers {

/// Ordinary arithmetic behind a backend's names. Not a backend of directed rounding: its results
/// bound nothing.
struct undirected {
  using number = double;
  static constexpr const char* name = "undirected";
  struct scope {};
  static double add_down(double x, double y) { return x + y; }
  static double add_up(double x, double y) { return x + y; }
  static double sub_down(double x, double y) { return x - y; }
  static double sub_up(double x, double y) { return x - y; }
  static double mul_down(double x, double y) { return x * y; }
  static double mul_up(double x, double y) { return x * y; }
  static double div_down(double x, double y) { return x / y; }
  static double div_up(double x, double y) { return x / y; }
  static double sqrt_down(double x) { return std::sqrt(x); }
  static double sqrt_up(double x) { return std::sqrt(x); }
};

class plain : public octree::sound<undirected, octree::convention::owned> {
public:
  static constexpr char name[] = "plain", title[] = "plain";
  static constexpr char summary[] = "the sound formulas in round to nearest";
  using sound::sound;
};

} // namespace graze::peers
