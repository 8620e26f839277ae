#include <graze/octree/exact.hpp>
#include <graze/octree/sound.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <traversal/list.hpp>
#include <traversal/method_traversal.hpp>

namespace graze::fuzz {

namespace {

using octree::convention;

template <class Backend, convention C, const char* Name> std::unique_ptr<traversal> sound() {
  return std::make_unique<method_traversal<octree::sound<Backend, C>>>(
      Name, C == convention::owned ? promise::owned : promise::touched);
}
template <class Backend, convention C, const char* Name> std::unique_ptr<traversal> exact() {
  return std::make_unique<method_traversal<octree::exact<Backend, C>>>(
      Name, C == convention::owned ? promise::exactly_owned : promise::exactly_touched);
}
constexpr char exactly[] = "exact", exactly_closed[] = "exact-closed",
               exactly_nearest[] = "exact-nearest";
constexpr char upward[] = "sound", closed[] = "sound-closed", nearest[] = "sound-nearest",
               split[] = "sound-split", switching[] = "sound-switching";

std::vector<traversal_entry>& linked() {
  static std::vector<traversal_entry> list;
  return list;
}

} // namespace

const std::vector<traversal_entry>& linked_traversals() { return linked(); }

void add_traversals(const std::vector<traversal_entry>& more) {
  linked().insert(linked().end(), more.begin(), more.end());
}

const std::vector<traversal_entry>& traversals() {
  static const std::vector<traversal_entry> all = [] {
    std::vector<traversal_entry> list{
        {upward, "bounds that hold, half-open octants, front to back (backend upward)",
         sound<rounding::upward, convention::owned, upward>},
        {closed, "bounds that hold, closed octants (backend upward)",
         sound<rounding::upward, convention::closed, closed>},
        {nearest, "as sound, on the backend that needs no rounding mode",
         sound<rounding::nearest, convention::owned, nearest>},
        {split, "as sound, lower bounds on SSE2 and upper bounds on the x87",
         sound<rounding::split, convention::owned, split>},
        {switching, "as sound, with the mode set around every operation",
         sound<rounding::switching, convention::owned, switching>},
        {exactly, "no octant too few or too many: those that own a point of the ray, front to back",
         exact<rounding::upward, convention::owned, exactly>},
        {exactly_closed, "no octant too few or too many: those that the ray touches",
         exact<rounding::upward, convention::closed, exactly_closed>},
        {exactly_nearest, "as exact, on the backend that needs no rounding mode",
         exact<rounding::nearest, convention::owned, exactly_nearest>},
    };
    for (const auto& more : {grid_traversals(), baselines_of_2005(), lane_traversals()})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

const traversal_entry* find_traversal(std::string_view name) {
  for (const auto* list : {&traversals(), &adapters(), &linked_traversals(), &mutants()})
    for (const traversal_entry& entry : *list)
      if (entry.name == name)
        return &entry;
  return nullptr;
}

} // namespace graze::fuzz
