// graze-voxelize: a scene's surface as an octree in a file, and what such a file holds.
#include "scene_options.hpp"
#include "scene_surface.hpp"

#include <chrono>
#include <graze/octree/parallel_voxelizer.hpp>
#include <graze/octree_file.hpp>
#include <graze/octree_formula/lane_kernels.hpp>
#include <graze/support/files.hpp>
#include <graze/support/program.hpp>
#include <graze/support/progress.hpp>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>

namespace {
using namespace graze;
using namespace graze::render;
using namespace graze::support;

constexpr int not_written = 1; ///< the octree, as --help says

constexpr int deepest = 14;

struct request {
  scene_options scene;
  std::string output, info;
  int level = 9;
  int threads = 0;
  bool json = false, progress = false;
};

int end_with(int code, const std::string& why) {
  complain(why);
  return code;
}

/// The octree, or why it could not be made; or why there is no surface of which to make one.
expected<expected<octree::sparse_octree>> voxelize_scene(const scene& s, int level,
                                                         const octree::parallel_options& options) {
  return with_surface(s, [&](const auto& source) -> expected<expected<octree::sparse_octree>> {
    const auto root = octree::enclosing_root(s.domain, level);
    if (!root)
      return unexpected{root.reason()};
    const auto surface = source.surface();
    return octree::voxelize_parallel(octree::lane_judge(surface, s.domain), *root, options);
  });
}

/// What the file says of itself; cut to what it holds.
std::string description_of(const scene& s) {
  std::string text = s.name + ": " + formula_text(s);
  for (const octree::parameter& p : s.set)
    text += "; " + p.name + " = " + p.value;
  if (text.size() > octree::longest_description)
    text.replace(octree::longest_description - 3, std::string::npos, "...");
  return text;
}

/// Whether this can be done. Asked before any work.
status check(const request& r) {
  if (!r.info.empty())
    return {};
  if (r.scene.count() != 1)
    return unexpected{
        "exactly one of --scene, --formula, --info is needed (--help shows the options)"};
  if (r.output.empty())
    return unexpected{"--out is needed (--help shows the options)"};
  if (const status may = r.scene.check(); !may)
    return may;
  if (r.level < 1 || r.level > deepest)
    return unexpected{fmt::format("--level must be 1 to {}, not {}", deepest, r.level)};
  if (r.threads < 0 || r.threads > static_cast<int>(most_threads))
    return unexpected{fmt::format("--threads must be 0 to {}, not {}", most_threads, r.threads)};
  return check_writable(r.output);
}

void print_octree(const request& r, const octree::sparse_octree& t, const std::string& description,
                  const std::string& file, double seconds) {
  const auto certified = static_cast<std::size_t>(
      std::count(t.leaves().begin(), t.leaves().end(), octree::content::certified));
  if (r.json) {
    nlohmann::ordered_json line = {
        {"file", file},
        {"description", description},
        {"level", t.level()},
        {"root", {t.root_octant().lo[0], t.root_octant().lo[1], t.root_octant().lo[2]}},
        {"root_size", t.root_octant().size},
        {"nodes", t.node_count()},
        {"leaves", t.leaf_count()},
        {"certified", certified},
        {"bytes", t.bytes()},
        {"seconds", seconds}};
    print("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
    return;
  }
  print("{}: level {}, {} nodes, {} leaves, {} of them certified, {} bytes in memory; {:.3f} s; "
        "{}\n",
        shown(description, 1000), t.level(), t.node_count(), t.leaf_count(), certified, t.bytes(),
        seconds, shown(file, 1000));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int show_file(const request& r) {
  const auto start = std::chrono::steady_clock::now();
  const auto loaded = octree::load_octree(r.info);
  if (!loaded)
    return bad_input(loaded.reason());
  print_octree(r, loaded->octree, loaded->description, r.info, seconds_since(start));
  return done;
}

int voxelize_to_file(const request& r) {
  formula_mark where;
  const auto s = r.scene.read(&where);
  if (!s) {
    complain(s.reason());
    print_error(where.lines());
    return refused;
  }
  if (const std::string note = note_on(*s); !note.empty())
    complain(note);
  const auto start = std::chrono::steady_clock::now();
  octree::parallel_options options{r.threads, &stop_wanted, {}};
  progress_line line("parts", r.progress);
  if (line.is_shown())
    options.progress = [&](std::size_t parts_done, std::size_t parts) {
      line.show({parts_done, parts, seconds_since(start)});
    };
  const auto made = voxelize_scene(*s, r.level, options);
  line.clear();
  if (!made)
    return bad_input(made.reason());
  const auto& tree = *made;
  const double seconds = seconds_since(start);
  if (stop_wanted)
    return end_with(ended_by_signal, "interrupted; nothing written");
  end_is_orderly();
  if (!tree)
    return end_with(not_written, tree.reason());
  const std::string description = description_of(*s);
  const auto bytes = octree::encode_octree(*tree, description);
  if (!bytes)
    return end_with(not_written, bytes.reason());
  if (const status written = write_atomically(r.output, *bytes); !written)
    return end_with(not_written, written.reason());
  print_octree(r, *tree, description, r.output, seconds);
  return done;
}

int start(int argc, char** argv) {
  request r;
  CLI::App app("Voxelizes the surface of a scene: every octant of a level that the surface meets,\n"
               "proven by interval arithmetic, in a file with a checksum.",
               "graze-voxelize");
  std::vector<CLI::Option*> others = r.scene.declare(app);
  const auto level =
      app.add_option("--level", r.level, fmt::format("Levels of the octree, 1 to {}", deepest))
          ->capture_default_str();
  const auto out =
      app.add_option("-o,--out", r.output, "The file; an older one is replaced when all is done");
  const auto info = app.add_option("--info", r.info,
                                   "Reads such a file, checks all of it and says what it holds");
  const auto threads =
      app.add_option("--threads", r.threads, "0: one a core; the file is the same for any number")
          ->capture_default_str();
  const auto progress =
      app.add_flag("--progress", r.progress, "Report progress even if stderr is not a terminal");
  app.add_flag("--json", r.json, "The last line as a JSON object");
  others.insert(others.end(), {level, out, threads, progress});
  for (CLI::Option* other : others)
    info->excludes(other);
  app.footer("Exit codes: 0 done, 1 the octree could not be made or written, 2 bad input (also a\n"
             "file that is no octree) or another failure, 130 interrupted, nothing written.\n\n"
             "Examples:\n"
             "  graze-voxelize --scene tanglecube --out tanglecube.octree\n"
             "  graze-voxelize --scene spheres --level 11 --threads 2 --json -o spheres.octree\n"
             "  graze-voxelize --formula \"x^4 + y^4 + z^4 - 1\" --domain=-1.5,1.5 -o cube.octree\n"
             "  graze-voxelize --scene cone_tip.json --level 8 -o cone_tip.octree\n"
             "  graze-voxelize --info spheres.octree");
  if (const auto code = parse_arguments(app, argc, argv))
    return *code;
  if (const status may = check(r); !may)
    return bad_input(may.reason());
  listen_for_interrupts();
  limit_memory();
  return r.info.empty() ? voxelize_to_file(r) : show_file(r);
}

} // namespace

int main(int argc, char** argv) { return run_program("graze-voxelize", argc, argv, start); }
