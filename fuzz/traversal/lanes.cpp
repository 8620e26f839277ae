/// voxel_rays.hpp under test: its lanes, on the path that is in use (GRAZE_BATCH_PATH).
#include <graze/octree/voxel_rays.hpp>
#include <traversal/list.hpp>

namespace graze::fuzz {

namespace {

using octree::convention;
using octree::exactness;

/// The block's octants are the set. Levels that a voxel_set has not (0, above 20) are declined.
class lane_traversal final : public traversal {
public:
  lane_traversal(std::string_view name, convention c, exactness e)
      : name_(name), convention_(c), exactness_(e) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override {
    if (exactness_ == exactness::exact)
      return convention_ == convention::owned ? promise::exactly_owned : promise::exactly_touched;
    return convention_ == convention::owned ? promise::owned : promise::touched;
  }

  void visit(const trial& t, visited& out) override {
    const auto root = octree::root_cube::make(t.root, t.level);
    if (!root || t.level > octree::voxel_set::max_set_level)
      return out.decline();
    block_.clear();
    for (std::uint64_t z = 0; z < t.extent[2]; ++z)
      for (std::uint64_t y = 0; y < t.extent[1]; ++y)
        for (std::uint64_t x = 0; x < t.extent[0]; ++x)
          block_.push_back({static_cast<std::uint32_t>(t.base[0] + x),
                            static_cast<std::uint32_t>(t.base[1] + y),
                            static_cast<std::uint32_t>(t.base[2] + z)});
    const auto set = octree::voxel_set::make(*root, block_);
    const auto ray = octree::ray::make(t.origin, t.direction);
    octree::visit_voxels(*set, *ray, convention_, exactness_, {}, [&](const octree::voxel& v) {
      out.push(octant_at(v.index(0) - static_cast<unsigned>(t.base[0]),
                         v.index(1) - static_cast<unsigned>(t.base[1]),
                         v.index(2) - static_cast<unsigned>(t.base[2])));
      return false;
    });
  }

private:
  std::string_view name_;
  convention convention_;
  exactness exactness_;
  std::vector<std::array<std::uint32_t, 3>> block_;
};

template <convention C, exactness E, const char* Name> std::unique_ptr<traversal> made() {
  return std::make_unique<lane_traversal>(Name, C, E);
}
constexpr char sound_owned[] = "lanes-sound", sound_closed[] = "lanes-sound-closed",
               exact_owned[] = "lanes-exact", exact_closed[] = "lanes-exact-closed";

} // namespace

std::vector<traversal_entry> lane_traversals() {
  using enum convention;
  using enum exactness;
  return {
      {sound_owned, "as sound, by lanes (the path that GRAZE_BATCH_PATH names; to level 20)",
       made<owned, conservative, sound_owned>},
      {sound_closed, "as sound-closed, by lanes", made<closed, conservative, sound_closed>},
      {exact_owned, "as exact, by lanes", made<owned, exact, exact_owned>},
      {exact_closed, "as exact-closed, by lanes", made<closed, exact, exact_closed>},
  };
}

} // namespace graze::fuzz
