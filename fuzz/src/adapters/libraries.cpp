#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <graze/fuzz/libraries.hpp>
#include <unistd.h>

namespace graze::fuzz {

namespace {

struct shipped {
  std::string_view name, program, variant, summary;
  promise promised;
};

using enum promise;
constexpr shipped all[] = {
    {"octomap-ray-keys", "octomap", "ray-keys", "OctoMap, computeRayKeys (float)", crossed},
    {"octomap-cast-ray", "octomap", "cast-ray", "OctoMap, castRay again and again (float)",
     crossed},
    {"pcl", "pcl", "", "PCL, getIntersectedVoxelIndices (float)", crossed},
    {"openvdb-dda", "openvdb", "dda", "OpenVDB, DDA", crossed},
    {"openvdb-level-set-hdda", "openvdb", "level-set-hdda", "OpenVDB, LevelSetHDDA", crossed},
    {"openvdb-volume-ray-intersector", "openvdb", "volume-ray-intersector",
     "OpenVDB, VolumeRayIntersector, leaf by leaf", crossed},
    {"nanovdb-first-active", "nanovdb", "first-active",
     "NanoVDB, firstActive again and again (float)", crossed},
    {"nanovdb-hdda", "nanovdb", "hdda", "NanoVDB, HDDA as in ZeroCrossing (float)", crossed},
    {"embree-boxes", "embree", "boxes", "Embree, boxes as user geometry (float)", crossed},
    {"embree-boxes-robust", "embree", "boxes-robust", "the same, RTC_SCENE_FLAG_ROBUST", crossed},
    {"embree-boxes-tested", "embree", "boxes-tested", "the boxes that slabs in the callback find",
     crossed},
    {"embree-triangles", "embree", "triangles", "Embree, 12 triangles a voxel (float)", crossed},
    {"embree-triangles-robust", "embree", "triangles-robust", "the same, RTC_SCENE_FLAG_ROBUST",
     crossed},
    {"cgal-inexact", "cgal", "inexact", "CGAL, ray and box in double", crossed},
    {"cgal-epick", "cgal", "epick", "CGAL, exact predicates; rays that two points hold",
     exactly_touched},
    {"cgal-epeck", "cgal", "epeck", "CGAL, exact constructions too", exactly_touched},
    {"cgal-octree", "cgal", "octree", "CGAL's octree, EPICK; rays that two points hold",
     exactly_touched},
    {"cgal-octree-epeck", "cgal", "octree-epeck", "CGAL's octree asked with EPECK's rays",
     exactly_touched},
};

/// The folder of the adapters' programs: GRAZE_ADAPTERS, or that of this program.
std::filesystem::path folder() {
  if (const char* named = std::getenv("GRAZE_ADAPTERS"); named != nullptr && *named != '\0')
    return named;
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

} // namespace

std::vector<traversal_entry> library_traversals(const external_options& like) {
  std::vector<traversal_entry> found;
  const std::filesystem::path in = folder();
  for (const shipped& s : all) {
    const std::string program = in / ("graze-adapter-" + std::string(s.program));
    if (access(program.c_str(), X_OK) != 0)
      continue;
    external_options options = like;
    options.command = shell_word(program) + " " + std::string(s.variant);
    options.promised = s.promised;
    options.format = line_format::plain;
    options.start_seconds = 1; // they start in some 50 ms
    found.push_back(untried_external_traversal(options, s.name, s.summary));
  }
  return found;
}

expected<traversal_entry> named_traversal(const std::string& name, const external_options& like) {
  if (const traversal_entry* entry = find_traversal(name))
    return *entry;
  for (const traversal_entry& entry : library_traversals(like))
    if (entry.name == name)
      return entry;
  return unexpected{fmt::format("no traversal is called \"{}\" (see graze-fuzz list)", name)};
}

} // namespace graze::fuzz
