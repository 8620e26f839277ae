#include <graze/fuzz/method_traversal.hpp>
#include <graze/octree/gargantini.hpp>
#include <graze/octree/plain.hpp>
#include <graze/octree/published.hpp>
#include <graze/octree/sound.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::fuzz {

namespace {

using octree::convention;

std::unique_ptr<traversal> sound() {
  return std::make_unique<method_traversal<octree::sound<rounding::upward, convention::owned>>>(
      "sound", promise::owned);
}
std::unique_ptr<traversal> sound_closed() {
  return std::make_unique<method_traversal<octree::sound<rounding::upward, convention::closed>>>(
      "sound-closed", promise::touched);
}
std::unique_ptr<traversal> sound_nearest() {
  return std::make_unique<method_traversal<octree::sound<rounding::nearest, convention::owned>>>(
      "sound-nearest", promise::owned);
}
// The baselines leave octants out on purpose that they only touch (the paper's strict overlap), so
// a miss of theirs is a crossed octant.
std::unique_ptr<traversal> published() {
  return std::make_unique<method_traversal<octree::published>>("published", promise::crossed);
}
std::unique_ptr<traversal> plain() {
  return std::make_unique<method_traversal<octree::plain>>("plain", promise::crossed);
}
std::unique_ptr<traversal> gargantini() {
  return std::make_unique<method_traversal<octree::gargantini>>("gargantini", promise::crossed);
}

} // namespace

const std::vector<traversal_entry>& traversals() {
  static const std::vector<traversal_entry> all{
      {"sound", "bounds that hold, half-open octants, front to back (backend upward)", sound},
      {"sound-closed", "bounds that hold, closed octants (backend upward)", sound_closed},
      {"sound-nearest", "as sound, on the backend that needs no rounding mode", sound_nearest},
      {"published", "the paper's ray voxelization to the letter", published},
      {"plain", "the sound formulas in round to nearest", plain},
      {"gargantini", "mid-plane intersections sorted in t (Gargantini and Atkinson 1993)",
       gargantini},
  };
  return all;
}

const traversal_entry* find_traversal(std::string_view name) {
  for (const auto* list : {&traversals(), &mutants()})
    for (const traversal_entry& entry : *list)
      if (entry.name == name)
        return &entry;
  return nullptr;
}

} // namespace graze::fuzz
