/// graze-adapter-NAME VARIANT: a library asked by graze-fuzz, ray by ray; it is built from the block of
/// each request anew. graze-adapter-NAME --variants tells what there is: name, promise and summary, with
/// tabs between them. graze-adapter-NAME --voxels FILE [--cell-centred] [--voxel-size LENGTH] reads a map
/// through the library (maps/voxel_map.hpp); --extensions tells of which files.
#include <adapters/adapter.hpp>
#include <cstring>
#include <peers/library.hpp>
#include <peers/maps/voxel_map.hpp>
#include <string_view>

// What this program is; CMake says so.
#ifdef GRAZE_MAP_READER
namespace graze::peers {
voxel_map GRAZE_MAP_READER(const std::string& path, const map_options& options);
}
#endif

namespace {

using namespace graze;

constexpr const char* program = GRAZE_PROGRAM;
#ifdef GRAZE_MAP_READER
constexpr bool reads_maps = true;
constexpr peers::map_reader reader = peers::GRAZE_MAP_READER;
constexpr const char* extensions = GRAZE_MAP_EXTENSIONS;
#else
constexpr bool reads_maps = false;
constexpr peers::map_reader reader = nullptr;
constexpr const char* extensions = "";
#endif

void answer_request(const peers::variant& asked, const adapter::request& r, adapter::answer& a) {
  const auto ray = octree::ray::make(r.origin, adapter::scaled(r.direction));
  peers::occupied_octants block{{r.lo, r.size}, r.level, r.base, {}};
  for (const adapter::index3& v : r.voxels())
    block.indices.push_back({static_cast<std::uint32_t>(v[0] - r.base[0]),
                             static_cast<std::uint32_t>(v[1] - r.base[1]),
                             static_cast<std::uint32_t>(v[2] - r.base[2])});
  const auto library = ray ? asked.build(block) : nullptr;
  const auto received = library ? library->received(*ray) : std::nullopt;
  if (!received)
    return a.skip();
  a.received(received->origin(), received->direction());
  std::vector<peers::octant_key> found;
  library->visit(*ray, found);
  for (const peers::octant_key key : found) {
    const peers::octant_index at = peers::index_of(key);
    a.visit({r.base[0] + at[0], r.base[1] + at[1], r.base[2] + at[2]});
  }
}

int usage() {
  std::fprintf(stderr,
               "usage: %s --variants | --extensions | VARIANT |\n"
               "       %s --voxels FILE [--cell-centred] [--voxel-size LENGTH]\n",
               program, program);
  return 2;
}

int voxels(int argc, char** argv) {
  peers::map_options options;
  const char* file = nullptr;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--cell-centred")
      options.cell_centred = true;
    else if (word == "--voxels" && i + 1 < argc)
      file = argv[++i];
    else if (word == "--voxel-size" && i + 1 < argc) {
      char* end = nullptr;
      options.voxel_size = std::strtod(argv[++i], &end);
      if (*end != '\0' || !(options.voxel_size > 0) || !std::isfinite(options.voxel_size))
        return usage();
    } else
      return usage();
  }
  return file == nullptr ? usage() : peers::write_map(program, reader, file, options);
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view asked = argc > 1 ? argv[1] : "";
  if (reads_maps && asked == "--voxels")
    return voxels(argc, argv);
  if (asked == "--extensions") {
    std::puts(extensions);
    return 0;
  }
  for (const peers::library& library : peers::libraries())
    for (const peers::variant& v : library.variants) {
      if (asked == "--variants")
        std::printf("%s\t%s\t%s\n", v.name, v.promise, v.summary);
      if (asked == v.name)
        return adapter::serve(v.promise, [&](const adapter::request& r, adapter::answer& a) {
          answer_request(v, r, a);
        });
    }
  return asked == "--variants" ? 0 : usage();
}
