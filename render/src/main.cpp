// graze-render: a picture of an implicit surface, one ray a pixel through the sound traversal.
#include "program.hpp"
#include "progress.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <graze/render/atomic_file.hpp>
#include <graze/render/render.hpp>
#include <new>
#include <nlohmann/json.hpp>
#include <thread>

namespace {
using namespace graze::render;

struct request {
  std::string scene_name;
  std::string mode = "cast";
  int levels = 30;
  int octree_level = 9;
  int size = 512;
  int threads = 0;
  std::string output;
  bool progress = false;
  bool json = false;
};

int complain(exit_code code, const std::string& why) {
  fmt::print(stderr, "graze-render: {}\n", why);
  return code;
}

/// The reason why this cannot be done, or nothing. Asked before any work.
std::string objection(const request& r) {
  const auto outside = [](const char* name, int value, int least, int most) {
    return fmt::format("{} must be {} to {}, not {}", name, least, most, value);
  };
  if (find_scene(r.scene_name) == nullptr)
    return fmt::format("unknown scene '{}'; there are {}", r.scene_name, scene_names());
  constexpr int deepest = graze::octree::max_level;
  if (r.levels < 1 || r.levels > deepest)
    return outside("--levels", r.levels, 1, deepest);
  if (r.octree_level < 1 || r.octree_level > 12)
    return outside("--octree-level", r.octree_level, 1, 12);
  if (r.size < 1 || r.size > largest_size)
    return outside("--size", r.size, 1, largest_size);
  if (r.threads < 0 || r.threads > 1024)
    return outside("--threads", r.threads, 0, 1024);
  if (const auto format = format_of(r.output); !format)
    return "the output " + format.reason();
  return why_not_writable(r.output);
}

void describe(picture& image, const request& r, const scene& s, const rendering& result) {
  image.metadata = {{"Software", "graze-render " GRAZE_VERSION},
                    {"graze:scene", s.name},
                    {"graze:formula", s.formula},
                    {"graze:levels", std::to_string(r.levels)},
                    {"graze:octree_level", std::to_string(r.octree_level)},
                    {"graze:hits", std::to_string(result.counts.hits)},
                    {"graze:undecided", std::to_string(result.counts.undecided)},
                    {"graze:complete", result.complete ? "yes" : "no"}};
}

void print_summary(const request& r, const caster& work, double octree_seconds,
                   const rendering& result) {
  const tally& c = result.counts;
  const double rate = result.seconds > 0 ? static_cast<double>(c.rays()) / result.seconds : 0;
  if (r.json) {
    const nlohmann::ordered_json line = {{"scene", r.scene_name},
                                         {"levels", r.levels},
                                         {"octree_level", r.octree_level},
                                         {"size", r.size},
                                         {"threads", r.threads},
                                         {"output", r.output},
                                         {"complete", result.complete},
                                         {"mode", r.mode},
                                         {"pixels", c.pixels},
                                         {"rays", c.rays()},
                                         {"shadow_rays", c.shadow_rays},
                                         {"reflected_rays", c.reflected_rays},
                                         {"secondary_undecided", c.secondary_undecided},
                                         {"longest_shift", c.longest_shift},
                                         {"hits", c.hits},
                                         {"misses", c.misses},
                                         {"undecided", c.undecided},
                                         {"octants_per_ray", c.octants_a_ray()},
                                         {"octree_leaves", work.octree_leaves()},
                                         {"octree_seconds", octree_seconds},
                                         {"seconds", result.seconds},
                                         {"rays_per_second", rate}};
    fmt::print("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
    return;
  }
  fmt::print("{} {}x{} NL {}: {} rays in {:.2f} s, {}rays/s, {} hits, {} misses, {} undecided, "
             "{:.1f} octants a ray; octree of {} leaves in {:.2f} s; {}\n",
             r.scene_name, r.size, r.size, r.levels, c.rays(), result.seconds, three_digits(rate),
             c.hits, c.misses, c.undecided, c.octants_a_ray(), work.octree_leaves(), octree_seconds,
             r.output);
}

int render_to_file(const request& r) {
  const scene& s = *find_scene(r.scene_name);
  const auto start = std::chrono::steady_clock::now();
  auto work = s.prepare(s, std::min(r.octree_level, r.levels), r.levels);
  if (!work)
    return complain(bad_input, work.reason());
  const double octree_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  progress_line line(r.progress ? progress_line::mode::always : progress_line::mode::automatic);
  const settings how = {r.size, static_cast<unsigned>(r.threads),
                        r.mode == "trace" ? mode::trace : mode::cast};
  const rendering result =
      render_picture(s, **work, how, &stop_wanted,
                     [&](std::uint64_t done_pixels, std::uint64_t pixels, double seconds) {
                       line.show(done_pixels, pixels, seconds);
                     });
  line.clear();
  if (result.counts.pixels == 0)
    return complain(interrupted, "interrupted before the first tile; nothing written");

  picture image = to_picture(result);
  describe(image, r, s, result);
  const auto bytes = encode(image, *format_of(r.output));
  if (!bytes)
    return complain(failed, bytes.reason());
  const auto written = write_atomically(r.output, *bytes);
  if (!written)
    return complain(failed, written.reason());
  print_summary(r, **work, octree_seconds, result);
  if (result.complete)
    return done;
  return complain(interrupted, fmt::format("interrupted: {} is a partial picture, {} of {} pixels",
                                           r.output, result.counts.pixels, result.pixels.size()));
}

} // namespace

int main(int argc, char** argv) {
  request r;
  CLI::App app(
      "Pictures of implicit surfaces: each pixel's ray hits, misses, or is undecided, proven by\n"
      "interval arithmetic on an octree.",
      "graze-render");
  app.add_option("--scene", r.scene_name, "One of " + scene_names())->required();
  app.add_option("--levels", r.levels, "NL, the levels of the descent, 1 to 53")
      ->capture_default_str();
  app.add_option(
         "-o,--output", r.output,
         "The picture: .png (8-bit sRGB) or .exr (linear float R, G, B and Z, the distance\n"
         "from the eye)")
      ->required();
  app.add_option("--mode", r.mode,
                 "cast: light only; trace: shadows and 5 levels of reflection too")
      ->check(CLI::IsMember({"cast", "trace"}))
      ->capture_default_str();
  app.add_option("--size", r.size, "Pixels a side")->capture_default_str();
  app.add_option("--octree-level", r.octree_level, "Depth of the stored octree, at most NL")
      ->capture_default_str();
  app.add_option("--threads", r.threads, "0: one a core; the picture is the same for any number")
      ->capture_default_str();
  app.add_flag("--progress", r.progress, "Report progress even if stderr is not a terminal");
  app.add_flag("--json", r.json, "The last line as a JSON object");
  app.set_version_flag("--version", "graze-render " GRAZE_VERSION);
  app.footer(
      "Undecided pixels are magenta; pixels not reached before an interrupt are black.\n"
      "Exit codes: 0 done, 1 the picture could not be written, 2 bad input, 130 interrupted.\n\n"
      "Examples:\n"
      "  graze-render --scene tanglecube -o tanglecube.png\n"
      "  graze-render --scene spheres --levels 50 --size 1024 -o spheres.exr\n"
      "  graze-render --scene holesrot --levels 30 --threads 2 --json -o holesrot.png");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0)
      return app.exit(e);
    return complain(bad_input, std::string(e.what()) + " (--help shows the options)");
  }
  if (const std::string why = objection(r); !why.empty())
    return complain(bad_input, why);
  if (r.threads == 0)
    r.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  listen_for_interrupts();
  try {
    return render_to_file(r);
  } catch (const std::bad_alloc&) {
    return complain(failed, fmt::format("not enough memory for {}x{} pixels", r.size, r.size));
  } catch (const std::exception& e) { // threads that cannot be started
    return complain(failed, e.what());
  }
}
