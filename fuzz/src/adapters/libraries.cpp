/// The libraries of bench/peers as traversals under test: linked into graze-fuzz-libraries, which
/// is graze-fuzz and these.
#include "libraries.hpp"
#include "../../../bench/peers/peers.hpp"

namespace graze::fuzz {

namespace {

/// The deepest level whose voxels the library has: 16 bits an axis in OctoMap, of which the root
/// uses the upper half; single precision in PCL; a tree that is rebuilt for each ray in all.
template <class Library> constexpr int last_level = 16;
template <> constexpr int last_level<bench::octomap> = 14;

/// CGAL decides exactly which closed boxes a ray meets; the others promise nothing about touching.
template <class Library> constexpr promise promised_by = promise::crossed;
template <> constexpr promise promised_by<bench::cgal> = promise::exactly_touched;

/// The library's structure is built of the trial's block, in the whole root. It is judged on the
/// ray that it gets: see peers.hpp for what that is.
template <class Library> class library_traversal final : public traversal {
public:
  explicit library_traversal(std::string_view name) : name_(name) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promised_by<Library>; }

  void visit(const trial& t, visited& out) override {
    const auto root = octree::root_cube::make(t.root, std::max(1, t.level));
    const auto ray = octree::ray::make(t.origin, t.direction);
    if (t.level < 1 || t.level > last_level<Library> || !fits(t) || !root || !ray)
      return out.decline();
    bench::voxel_grid grid{*root, {}};
    for (voxel_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<unsigned>(std::countr_zero(left));
      grid.voxels.push_back({static_cast<std::uint32_t>(t.base[0] + (v & 3u)),
                             static_cast<std::uint32_t>(t.base[1] + (v >> 2 & 3u)),
                             static_cast<std::uint32_t>(t.base[2] + (v >> 4))});
    }
    bench::peer<Library> library(grid);
    const auto got = library.received(*ray);
    if (!got)
      return out.decline();
    out.receive({got->origin(), got->direction()});
    found_.clear();
    library.occupied(*ray, found_);
    for (const bench::voxel_key key : found_) {
      const bench::voxel_index at = bench::index_of(key);
      std::array<std::uint64_t, 3> in{};
      for (unsigned a = 0; a < 3; ++a)
        in[a] = at[a] - t.base[a]; // wraps below the block
      if (in[0] < t.extent[0] && in[1] < t.extent[1] && in[2] < t.extent[2])
        out.push(voxel_at(static_cast<unsigned>(in[0]), static_cast<unsigned>(in[1]),
                          static_cast<unsigned>(in[2])));
      else
        out.push_outside();
    }
  }

private:
  /// What a voxel_grid asks of its root.
  static bool fits(const trial& t) {
    int exponent = 0;
    if (std::frexp(t.root.size, &exponent) != 0.5)
      return false;
    for (const double lo : t.root.lo)
      if (const double cells = lo / t.size();
          std::fabs(cells) > 0x1p15 || cells != std::floor(cells))
        return false;
    return true;
  }

  std::string_view name_;
  std::vector<bench::voxel_key> found_;
};

template <class Library, const char* Name> std::unique_ptr<traversal> make() {
  return std::make_unique<library_traversal<Library>>(Name);
}
[[maybe_unused]] constexpr char pcl[] = "pcl", cgal[] = "cgal", octomap[] = "octomap",
                                openvdb[] = "openvdb";

std::vector<traversal_entry> libraries() {
  std::vector<traversal_entry> all;
#ifdef GRAZE_PEER_PCL
  all.push_back({pcl, "PCL: getIntersectedVoxelIndices (float)", make<bench::pcl, pcl>});
#endif
#ifdef GRAZE_PEER_CGAL
  all.push_back({cgal, "CGAL: Octree::intersected_nodes (exact, ray by two points)",
                 make<bench::cgal, cgal>});
#endif
#ifdef GRAZE_PEER_OCTOMAP
  all.push_back({octomap, "OctoMap: computeRayKeys, search (float, ray by two points)",
                 make<bench::octomap, octomap>});
#endif
#ifdef GRAZE_PEER_OPENVDB
  all.push_back({openvdb, "OpenVDB: LevelSetHDDA (double)", make<bench::openvdb, openvdb>});
#endif
#ifdef GRAZE_FUZZ_EMBREE
  all.push_back({"embree", "Embree: boxes as user geometry (float)", make_embree});
  all.push_back({"embree-robust", "the same with RTC_SCENE_FLAG_ROBUST", make_embree_robust});
#endif
  return all;
}

const bool added = (add_traversals(libraries()), true);

} // namespace

} // namespace graze::fuzz
