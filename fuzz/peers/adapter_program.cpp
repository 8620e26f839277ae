/// graze-adapter-NAME VARIANT: a library asked by graze-fuzz, ray by ray; it is built from the block of
/// each request anew. graze-adapter-NAME --variants tells what there is: name, promise and summary, with
/// tabs between them.
///
/// graze-adapter-NAME --voxels FILE reads a map through the library and writes its voxels
/// (maps/voxel_map.hpp); --extensions tells of which files. graze-adapter-NAME --scene FILE VARIANT builds from
/// the file itself, and is asked ray by ray; --map-variants tells what there is.
#include <adapters/adapter.hpp>
#include <cstring>
#include <peers/library.hpp>
#include <peers/maps/voxel_map.hpp>
#include <string_view>

// What this program is; CMake says so.
#ifdef GRAZE_MAP_READER
namespace graze::peers {
map_library GRAZE_MAP_READER();
}
#endif

namespace {

using namespace graze;

constexpr const char* program = GRAZE_PROGRAM;
#ifdef GRAZE_MAP_READER
constexpr bool reads_maps = true;
peers::map_library maps() { return peers::GRAZE_MAP_READER(); }
constexpr const char* extensions = GRAZE_MAP_EXTENSIONS;
#else
constexpr bool reads_maps = false;
peers::map_library maps() { return {}; }
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
    a.visit(adapter::index3{r.base[0] + at[0], r.base[1] + at[1], r.base[2] + at[2]});
  }
}

int usage() {
  std::fprintf(stderr,
               "usage: %s --variants | --map-variants | --extensions | VARIANT |\n"
               "       %s --voxels FILE [OPTIONS] | %s --scene FILE [OPTIONS] VARIANT\n"
               "options: --cell-centred, --voxel-size LENGTH\n",
               program, program, program);
  return 2;
}

/// A request about voxels of a map, in plain numbers; false where it is none.
bool read_request(const std::string& line, adapter::request& r) {
  const char* at = line.c_str();
  char* end = nullptr;
  r.id = std::strtoull(at, &end, 10);
  if (end == at || std::strncmp(end, " scene ", 7) != 0)
    return false;
  at = end + 7;
  bool good = true;
  for (adapter::index3* v : {&r.base, &r.extent})
    for (std::uint64_t& i : *v) {
      i = std::strtoull(at, &end, 10);
      good = good && end != at;
      at = end;
    }
  for (adapter::vec3* v : {&r.origin, &r.direction})
    for (double& x : *v) {
      x = std::strtod(at, &end);
      good = good && end != at;
      at = end;
    }
  return good;
}

/// Answers rays through a map by its voxels' indices, until the input ends.
int serve_map(const peers::map_variant& v, const std::string& path,
              const peers::map_options& options) {
  std::unique_ptr<peers::structure> library;
  try {
    library = v.build(path, options, maps().read(path, options));
    if (!library)
      throw peers::map_refused("it is none that rays are asked through");
  } catch (...) {
    std::fprintf(stderr, "%s: %s: %s\n", program, path.c_str(), peers::refusal().c_str());
    return 2;
  }
  adapter::hello hello;
  hello.promise = v.promise;
  std::printf("promise %s cells grid\n", v.promise);
  std::fflush(stdout);
  std::string line;
  adapter::request r;
  while (adapter::detail::read_line(line)) {
    if (line.starts_with("scene ") || line.starts_with("grid ")) // the file is this one
      continue;
    if (!read_request(line, r)) {
      std::fprintf(stderr, "no request about a map in plain numbers\n");
      return 2;
    }
    adapter::answer a(hello, r);
    const auto ray = octree::ray::make(r.origin, adapter::scaled(r.direction));
    if (const auto received = ray ? library->received(*ray) : std::nullopt) {
      a.received(received->origin(), received->direction());
      std::vector<peers::octant_key> found;
      library->visit(*ray, found);
      for (const peers::octant_key key : found) {
        const peers::octant_index at = peers::index_of(key);
        a.visit(adapter::index3{at[0], at[1], at[2]});
      }
    } else {
      a.skip();
    }
    std::fputs(a.line().c_str(), stdout);
    std::fflush(stdout);
  }
  return 0;
}

int with_map(int argc, char** argv) {
  const bool scene = std::string_view(argv[1]) == "--scene";
  peers::map_options options;
  const char *file = nullptr, *variant = nullptr;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--cell-centred")
      options.cell_centred = true;
    else if ((word == "--voxels" || word == "--scene") && i + 1 < argc)
      file = argv[++i];
    else if (word == "--voxel-size" && i + 1 < argc) {
      char* end = nullptr;
      options.voxel_size = std::strtod(argv[++i], &end);
      if (*end != '\0' || !(options.voxel_size > 0) || !std::isfinite(options.voxel_size))
        return usage();
    } else if (scene && variant == nullptr)
      variant = argv[i];
    else
      return usage();
  }
  if (file == nullptr)
    return usage();
  if (!scene)
    return peers::write_map(program, maps(), file, options);
  for (const peers::map_variant& v : maps().variants)
    if (variant != nullptr && v.name == std::string_view(variant))
      return serve_map(v, file, options);
  return usage();
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view asked = argc > 1 ? argv[1] : "";
  if (reads_maps && (asked == "--voxels" || asked == "--scene"))
    return with_map(argc, argv);
  if (asked == "--extensions") {
    std::puts(extensions);
    return 0;
  }
  if (asked == "--map-variants") {
    for (const peers::map_variant& v : maps().variants)
      std::printf("%s\t%s\t%s\n", v.name, v.promise, v.summary);
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
