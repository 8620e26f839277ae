// graze-voxelize: a scene's surface as an octree in a file, and what such a file holds.
#include "program.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/parallel_voxelizer.hpp>
#include <graze/octree_file.hpp>
#include <graze/render/atomic_file.hpp>
#include <graze/render/scene.hpp>
#include <graze/rounding/environment.hpp>
#include <new>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {
using namespace graze;
using namespace graze::render;

constexpr int deepest = 14;

struct request {
  std::string scene_name, output, info;
  int level = 9;
  int threads = 0;
  bool json = false, progress = false;
};

int complain(exit_code code, const std::string& why) {
  fmt::print(stderr, "graze-voxelize: {}\n", why);
  return code;
}

template <class F>
expected<octree::sparse_octree> voxelize_scene(const octree::box& domain, int level,
                                               const octree::parallel_options& options) {
  const auto root = octree::enclosing_root(domain, level);
  if (!root)
    return unexpected{root.reason()};
  const F surface;
  return octree::voxelize_parallel(octree::lane_judge<F>(surface, domain), *root, options);
}

struct voxelizer {
  const char* scene;
  expected<octree::sparse_octree> (*run)(const octree::box&, int, const octree::parallel_options&);
};
constexpr voxelizer voxelizers[] = {{"spheres", voxelize_scene<octree::spheres>},
                                    {"quartdef", voxelize_scene<octree::quartdef>},
                                    {"tanglecube", voxelize_scene<octree::tanglecube>},
                                    {"holesrot", voxelize_scene<octree::holesrot>}};

std::string voxelizer_names() {
  std::string names;
  for (const voxelizer& v : voxelizers)
    names += (names.empty() ? "" : ", ") + std::string(v.scene);
  return names;
}
const voxelizer* find_voxelizer(const std::string& name) {
  for (const voxelizer& v : voxelizers)
    if (v.scene == name && find_scene(name) != nullptr)
      return &v;
  return nullptr;
}

/// The reason why this cannot be done, or nothing. Asked before any work.
std::string objection(const request& r) {
  if (!r.info.empty())
    return {};
  if (r.scene_name.empty())
    return "--scene and --out, or --info, are needed (--help shows the options)";
  if (r.output.empty())
    return "--out is needed (--help shows the options)";
  if (find_voxelizer(r.scene_name) == nullptr)
    return fmt::format("unknown scene '{}'; there are {}", r.scene_name, voxelizer_names());
  if (r.level < 1 || r.level > deepest)
    return fmt::format("--level must be 1 to {}, not {}", deepest, r.level);
  if (r.threads < 0 || r.threads > 1024)
    return fmt::format("--threads must be 0 to 1024, not {}", r.threads);
  return why_not_writable(r.output);
}

void print_octree(const request& r, const octree::sparse_octree& t, const std::string& description,
                  const std::string& file, double seconds) {
  const auto certified = static_cast<std::size_t>(
      std::count(t.leaves().begin(), t.leaves().end(), octree::content::certified));
  if (r.json) {
    nlohmann::ordered_json line = {{"file", file},
                                   {"description", description},
                                   {"level", t.level()},
                                   {"root", {t.box().lo[0], t.box().lo[1], t.box().lo[2]}},
                                   {"root_size", t.box().size},
                                   {"nodes", t.node_count()},
                                   {"leaves", t.leaf_count()},
                                   {"certified", certified},
                                   {"bytes", t.bytes()},
                                   {"seconds", seconds}};
    fmt::print("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
    return;
  }
  fmt::print(
      "{}: level {}, {} nodes, {} leaves, {} of them certified, {} bytes in memory; {:.3f} s; "
      "{}\n",
      description, t.level(), t.node_count(), t.leaf_count(), certified, t.bytes(), seconds, file);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int show_file(const request& r) {
  const auto start = std::chrono::steady_clock::now();
  const auto loaded = octree::load_octree(r.info);
  if (!loaded)
    return complain(bad_input, loaded.reason());
  print_octree(r, loaded->octree, loaded->description, r.info, seconds_since(start));
  return done;
}

int voxelize_to_file(const request& r) {
  const scene& s = *find_scene(r.scene_name);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const auto start = std::chrono::steady_clock::now();
  octree::parallel_options options{r.threads, &stop_wanted, {}};
  double told = 0.5; // short work says nothing
  if (terminal || r.progress)
    options.progress = [&](std::size_t parts_done, std::size_t parts) {
      if (const double now = seconds_since(start); now > told || (r.progress && parts_done == 1)) {
        told = now + (terminal ? 0.1 : 1);
        fmt::print(stderr, "{}{:3} %  {:.1f} s{}", terminal ? "\r" : "", 100 * parts_done / parts,
                   now, terminal ? "" : "\n");
      }
    };
  const auto tree = find_voxelizer(r.scene_name)->run(s.domain, r.level, options);
  if (terminal)
    fmt::print(stderr, "\r\033[K");
  const double seconds = seconds_since(start);
  if (stop_wanted)
    return complain(interrupted, "interrupted; nothing written");
  if (!tree)
    return complain(failed, tree.reason());
  const std::string description = fmt::format("{}: {}", s.name, formula_of(s));
  const auto bytes = octree::encode_octree(*tree, description);
  if (!bytes)
    return complain(failed, bytes.reason());
  if (const auto written = write_atomically(r.output, *bytes); !written)
    return complain(failed, written.reason());
  print_octree(r, *tree, description, r.output, seconds);
  return done;
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-voxelize"))
    return 2;
  request r;
  CLI::App app("Voxelizes the surface of a scene: every octant of a level that the surface meets,\n"
               "proven by interval arithmetic, in a file with a checksum.",
               "graze-voxelize");
  app.add_option("--scene", r.scene_name, "One of " + voxelizer_names());
  app.add_option("--level", r.level, fmt::format("Levels of the octree, 1 to {}", deepest))
      ->capture_default_str();
  app.add_option("-o,--out", r.output, "The file; an older one is replaced when all is done");
  app.add_option("--info", r.info, "Reads such a file, checks all of it and says what it holds");
  app.add_option("--threads", r.threads, "0: one a core; the file is the same for any number")
      ->capture_default_str();
  app.add_flag("--progress", r.progress, "Report progress even if stderr is not a terminal");
  app.add_flag("--json", r.json, "The last line as a JSON object");
  app.set_version_flag("--version", "graze-voxelize " GRAZE_VERSION);
  app.footer("Exit codes: 0 done, 1 the octree could not be made or written, 2 bad input (also a\n"
             "file that is no octree), 130 interrupted, nothing written.\n\n"
             "Examples:\n"
             "  graze-voxelize --scene tanglecube --out tanglecube.octree\n"
             "  graze-voxelize --scene spheres --level 11 --threads 2 --json -o spheres.octree\n"
             "  graze-voxelize --info spheres.octree");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0)
      return app.exit(e);
    return complain(bad_input, std::string(e.what()) + " (--help shows the options)");
  }
  if (const std::string why = objection(r); !why.empty())
    return complain(bad_input, why);
  listen_for_interrupts();
  try {
    return r.info.empty() ? voxelize_to_file(r) : show_file(r);
  } catch (const std::bad_alloc&) {
    return complain(failed, "not enough memory for this octree");
  } catch (const std::exception& e) { // threads that cannot be started
    return complain(failed, e.what());
  }
}
