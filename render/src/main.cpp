// graze-render: a picture of an implicit surface, each ray with its verdict.
#include "request.hpp"
#include "scene_options.hpp"
#include "view_options.hpp"

#include <graze/render/arrays.hpp>
#include <graze/render/picture_texts.hpp>
#include <graze/render/scene_text.hpp>
#include <graze/support/files.hpp>
#include <graze/support/program.hpp>
#include <graze/support/progress.hpp>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>

namespace {
using namespace graze::render;
using namespace graze::support;
using graze::expected, graze::unexpected;
constexpr const char* software = "graze-render " GRAZE_VERSION;
constexpr int not_written = 1; ///< the picture, as --help says

struct request {
  scene_options scene; ///< or the picture to be made again
  std::string again;
  view_options view;
  std::string mode = "cast", method, size = "512", crop;
  picture_settings settings;
  int threads = 0;
  std::string output; ///< or of several pictures their pattern
  bool progress = false;
  bool json = false;
};

int end_with(int code, const std::string& why) {
  complain(why);
  return code;
}

/// The scene and the settings that a picture tells.
expected<scene> scene_of_picture(const std::string& file, picture_settings& settings) {
  const auto texts = texts_of_picture(file);
  if (!texts)
    return unexpected{texts.reason()};
  const auto text_at = [&](const char* key) {
    const auto text = texts->find(key);
    return text != texts->end() ? text->second : std::string();
  };
  if (!texts->contains("graze:scene"))
    return unexpected{in_quotes(file) + " tells of no scene: graze-render has not made it"};
  auto s = scene_from(text_at("graze:scene"));
  auto stored = picture_settings::parse(text_at("graze:settings"));
  if (!s || !stored)
    return unexpected{in_quotes(file) + ": " + (s ? stored.reason() : s.reason())};
  settings = *stored;
  if (const std::string maker = text_at("Software"); maker != software)
    complain(in_quotes(file) + " was made by " + shown(maker, 80) + ": the bytes may differ");
  return s;
}

/// What is to be rendered: a scene, or several, each in its file. Of an orbit what it turns.
struct task {
  std::vector<scene> subjects; ///< of --animate one a picture, else one
  framed_camera from;
  std::vector<std::string> files; ///< one a picture
};

/// The scenes of --animate, or the scene; under one camera.
status read_scenes(const request& r, int pictures, task& t, formula_mark& where) {
  const bool animated = !r.view.animate.empty();
  std::optional<ball> all;
  for (int i = 0; i < (animated ? pictures : 1); ++i) {
    scene_options options = r.scene;
    if (animated)
      options.set.push_back(r.view.value_of(i));
    auto s = options.read(&where);
    if (!s)
      return unexpected{s.reason()};
    t.subjects.push_back(*std::move(s));
    if (const scene& last = t.subjects.back(); animated && last.fitted) {
      const ball own = surface_extent(last);
      all = all ? ball_about(*all, own) : own;
    }
  }
  for (scene& s : t.subjects) {
    const auto from = r.view.apply(s, all);
    if (!from)
      return unexpected{from.reason()};
    t.from = *from;
  }
  return {};
}

/// What is rendered and, in r.settings, how; or the reason why that cannot be done. Asked before any
/// work but that of finding the surface's extent.
expected<task> understand(request& r, formula_mark& where) {
  if (r.scene.count() + int{!r.again.empty()} != 1)
    return unexpected{
        "exactly one of --scene, --formula, --again is needed (--help shows the options)"};
  if (r.threads < 0 || r.threads > static_cast<int>(most_threads))
    return unexpected{fmt::format("--threads must be 0 to {}, not {}", most_threads, r.threads)};
  if (const status may = r.scene.check(); !may)
    return unexpected{may.reason()};
  const auto size = extent_from(r.size);
  if (!size)
    return unexpected{size.reason()};
  r.settings.size = *size;
  r.settings.mode = r.mode == "trace" ? mode::trace : mode::cast;
  if (!r.crop.empty()) {
    const auto crop = window_from(r.crop);
    if (!crop)
      return unexpected{crop.reason()};
    r.settings.crop = *crop;
  }
  if (const status may = r.settings.check(); !may)
    return unexpected{may.reason()};
  const auto format = format_of(r.output);
  if (!format)
    return unexpected{"the output " + format.reason()};
  const auto pictures = r.view.pictures();
  if (!pictures)
    return unexpected{pictures.reason()};
  task t;
  for (int i = 0; i < *pictures; ++i) {
    auto file = *pictures == 1 ? r.output : frame_file(r.output, i);
    if (!file)
      return unexpected{file.reason()};
    if (const status may = check_writable(*file); !may)
      return unexpected{may.reason()};
    t.files.push_back(*std::move(file));
  }
  if (!r.again.empty()) {
    auto s = scene_of_picture(r.again, r.settings);
    if (!s)
      return unexpected{s.reason()};
    t.subjects.push_back(*std::move(s));
  } else if (const status may = read_scenes(r, *pictures, t, where); !may) {
    return unexpected{may.reason()};
  }
  if (const status may = prepare_to_encode(*format); !may)
    return unexpected{may.reason()};
  return t;
}

nlohmann::ordered_json counts_of(const tally& c) {
  return {{"pixels", c.pixels},
          {"hits", c.hits},
          {"misses", c.misses},
          {"undecided", c.undecided},
          {"poles", c.poles},
          {"jumps", c.jumps},
          {"gaps", c.gaps},
          {"rays", c.rays()},
          {"shadow_rays", c.shadow_rays},
          {"reflected_rays", c.reflected_rays},
          {"secondary_undecided", c.secondary_undecided},
          {"longest_shift", c.longest_shift}};
}

/// What a file tells of itself. Nothing of it depends on the time, the machine, or the number of
/// threads.
std::vector<std::pair<std::string, std::string>> description(const request& r, const scene& s,
                                                             const rendering& result) {
  return {{"Software", software},
          {"graze:scene", text_of(s)},
          {"graze:settings", r.settings.text()},
          {"graze:counts", counts_of(result.counts).dump()},
          {"graze:complete", result.complete ? "yes" : "no"}};
}

expected<std::vector<unsigned char>> bytes_of(const request& r, const scene& s,
                                              const rendering& result, file_format format) {
  if (format == file_format::npz)
    return encode_npz(result, description(r, s, result));
  picture image = to_picture(result, s.transparent);
  image.metadata = description(r, s, result);
  return encode(image, format);
}

void print_summary(const request& r, const scene& s, int frame, int frames, const std::string& file,
                   const caster& surface, double octree_seconds, const rendering& result) {
  const tally& c = result.counts;
  const double rate = result.seconds > 0 ? static_cast<double>(c.rays()) / result.seconds : 0;
  const bool descends = r.settings.method == method::descent;
  const char* const by_name = descends ? "descent" : "certified";
  if (r.json) {
    nlohmann::ordered_json line = {{"scene", s.name},
                                   {"mode", r.settings.mode == mode::trace ? "trace" : "cast"},
                                   {"method", by_name},
                                   {"levels", r.settings.levels},
                                   {"octree_level", r.settings.octree_level},
                                   {"size", result.whole.width},
                                   {"width", result.whole.width},
                                   {"height", result.whole.height},
                                   {"threads", r.threads},
                                   {"output", file},
                                   {"complete", result.complete}};
    if (frames > 1)
      line.update({{"frame", frame}, {"frames", frames}});
    line.update(counts_of(c));
    line.update({{"octants_per_ray", c.octants_a_ray()},
                 {"octree_leaves", surface.octree_leaves()},
                 {"octree_seconds", octree_seconds},
                 {"seconds", result.seconds},
                 {"rays_per_second", rate}});
    print("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
    return;
  }
  std::string breaks; // few formulas have any
  for (const auto& [count, name] :
       {std::pair{c.poles, "poles"}, std::pair{c.jumps, "jumps"}, std::pair{c.gaps, "gaps"}})
    if (count != 0)
      breaks += fmt::format("{} {}, ", count, name);
  print("{} {}x{} {}: {} rays in {:.2f} s, {}rays/s, {} hits, {} misses, {}{} undecided, "
        "{:.1f} {} a ray; {}{}\n",
        shown(s.name), result.whole.width, result.whole.height,
        descends ? fmt::format("NL {}", r.settings.levels) : by_name, c.rays(), result.seconds,
        three_digits(rate), c.hits, c.misses, breaks, c.undecided, c.octants_a_ray(),
        descends ? "octants" : "steps",
        descends ? fmt::format("octree of {} leaves in {:.2f} s; ", surface.octree_leaves(),
                               octree_seconds)
                 : "",
        shown(file, 1000));
}

/// The picture into its file.
status write_picture(const request& r, const scene& s, const rendering& result,
                     const std::string& file) {
  const auto bytes = bytes_of(r, s, result, *format_of(file));
  if (!bytes)
    return unexpected{bytes.reason()};
  return write_atomically(file, *bytes);
}

int render_to_files(const request& r, const task& t) {
  const picture_settings& chosen = r.settings;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds_so_far = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  expected<std::unique_ptr<caster>> surface = unexpected{""};
  double octree_seconds = 0;
  progress_line line("pixels", r.progress);
  const settings loop = {
      chosen.size, static_cast<unsigned>(r.threads),         chosen.mode,     side_of(chosen.spp),
      chosen.crop, *format_of(r.output) != file_format::png, chosen.show_gaps};
  const int frames = static_cast<int>(t.files.size());
  for (int i = 0; i < frames; ++i) {
    const std::string& file = t.files[static_cast<std::size_t>(i)];
    const bool is_next = static_cast<std::size_t>(i) < t.subjects.size();
    scene s = is_next ? t.subjects[static_cast<std::size_t>(i)] : t.subjects.back();
    if (is_next) {
      const double before = seconds_so_far();
      surface =
          prepare(s, std::min(chosen.octree_level, chosen.levels), chosen.levels, chosen.method);
      octree_seconds = seconds_so_far() - before;
      if (!surface) {
        line.clear();
        return bad_input(frames == 1
                             ? surface.reason()
                             : fmt::format("picture {} of {}: {}", i, frames, surface.reason()));
      }
    }
    if (r.view.orbit != 0) {
      s.view = turned(t.from, 360.0 * i / frames);
      if (s.lit == scene::lamps::headlight)
        s.lights = headlight(s.view);
    }
    const rendering result =
        render_picture(s, **surface, loop, &stop_wanted,
                       [&](std::uint64_t done_pixels, std::uint64_t pixels, double) {
                         const auto before = static_cast<std::uint64_t>(i) * pixels;
                         line.show({before + done_pixels,
                                    static_cast<std::uint64_t>(frames) * pixels, seconds_so_far()});
                       });
    if (i + 1 == frames || stop_wanted)
      end_is_orderly();
    line.clear();
    if (frames > 1 && !result.complete)
      return end_with(ended_by_signal,
                      fmt::format("interrupted: {} of {} pictures are written", i, frames));
    if (result.counts.pixels == 0)
      return end_with(ended_by_signal, "interrupted before the first tile; nothing written");
    if (const status written = write_picture(r, s, result, file); !written)
      return end_with(not_written, written.reason());
    print_summary(r, s, i, frames, file, **surface, octree_seconds, result);
    if (!result.complete)
      return end_with(ended_by_signal,
                      fmt::format("interrupted: {} is a partial picture, {} of {} pixels",
                                  shown(file), result.counts.pixels, result.pixels.size()));
  }
  return done;
}

void declare(CLI::App& app, request& r) {
  r.scene.declare(app);
  const auto again =
      app.add_option("--again", r.again,
                     "A picture of graze-render: its scene and settings once more, the same bytes");
  app.add_option(
         "-o,--output", r.output,
         "The picture: .png (8-bit sRGB) or .exr (linear floats: R, G, B; Z, the distance\n"
         "from the eye; depth.width, normal.X .Y .Z, object.id, verdict.code, steps.octants,\n"
         "and bounds); or what is proven of each ray, .npz (NumPy: bounds in doubles of depth,\n"
         "point and normal; verdict, object)")
      ->required();
  const auto mode = app.add_option("--mode", r.mode,
                                   "cast: light only; trace: shadows and 5 levels of reflection")
                        ->check(CLI::IsMember({"cast", "trace"}))
                        ->capture_default_str();
  const auto method =
      app.add_option("--method", r.method,
                     "certified: along the ray, to the precision of doubles; descent: to octants\n"
                     "of level NL. certified, unless --levels or --octree-level is given")
          ->check(CLI::IsMember({"certified", "descent"}));
  const auto levels =
      app.add_option("--levels", r.settings.levels, "NL, the levels of the descent, 1 to 53")
          ->capture_default_str();
  const auto octree_level = app.add_option("--octree-level", r.settings.octree_level,
                                           "Depth of the stored octree, at most NL")
                                ->capture_default_str();
  const auto size =
      app.add_option("--size", r.size, "Pixels a side, or WIDTHxHEIGHT")->capture_default_str();
  const auto crop =
      app.add_option("--crop", r.crop, "x,y,width,height: only these pixels of the picture");
  const auto spp = app.add_option("--spp", r.settings.spp,
                                  "Rays a pixel, a square number up to 256; verdicts and layers\n"
                                  "are those of the pixel's centre")
                       ->capture_default_str();
  const auto show_gaps = app.add_flag(
      "--show-gaps", r.settings.show_gaps,
      "Orange where a ray meets no surface, but a pole, a jump or a gap of the formula");
  for (CLI::Option* other : {mode, method, levels, octree_level, size, crop, spp, show_gaps})
    again->excludes(other);
  for (CLI::Option* other : r.view.declare(app))
    again->excludes(other);
  app.add_option("--threads", r.threads, "0: one a core; the picture is the same for any number")
      ->capture_default_str();
  app.add_flag("--progress", r.progress, "Report progress even if stderr is not a terminal");
  app.add_flag("--json", r.json, "The last line as a JSON object");
  app.footer(
      "Undecided pixels are magenta; pixels not reached before an interrupt are black.\n"
      "Exit codes: 0 done, 1 the picture could not be written, 2 bad input or another failure,\n"
      "130 interrupted.\n\n"
      "Examples:\n"
      "  graze-render --scene tanglecube -o tanglecube.png\n"
      "  graze-render --scene spheres --mode trace --size 1024 -o spheres.exr\n"
      "  graze-render --formula \"x^4 + y^4 + z^4 - 1\" --domain=-1.5,1.5 --spp 4 -o cube.png\n"
      "  graze-render --formula \"w = x^2 + y^2; w + z^2 = a*w^2 + 1\" --set a=1/3 -o ring.png\n"
      "  graze-render --formula \"x*y*z + 1/10\" --domain=-1,1 --up z --orbit 36 -o around.png\n"
      "  graze-render --formula \"x^2 + y^2 - z^2 - a\" --animate a=-1..1 --frames 50 -o a.png\n"
      "  graze-render --formula \"x^2 + y^2 - z^2\" --azimuth 30 --size 4096 --spp 16 \\\n"
      "    --background transparent --colour steelblue -o figure.png\n"
      "  graze-render --scene tanglecube -o tanglecube.npz  # depth into NumPy\n"
      "  graze-render --again spheres.exr -o the_same.exr");
}

int start(int argc, char** argv) {
  request r;
  CLI::App app(
      "Pictures of implicit surfaces: each pixel's ray hits, misses, or is undecided, proven by\n"
      "interval arithmetic.",
      "graze-render");
  declare(app, r);
  if (const auto code = parse_arguments(app, argc, argv))
    return *code;
  const bool of_descent = app.count("--levels") + app.count("--octree-level") != 0;
  if (of_descent && r.method == "certified")
    return bad_input("--levels and --octree-level are of --method descent");
  r.settings.method = of_descent || r.method == "descent" ? method::descent : method::certified;
  listen_for_interrupts();
  limit_memory();
  formula_mark where;
  const auto t = understand(r, where);
  if (!t) {
    complain(t.reason());
    print_error(where.lines());
    return refused;
  }
  if (const std::string note = note_on(t->subjects.front()); !note.empty())
    complain(note);
  if (r.threads == 0)
    r.threads = static_cast<int>(default_threads());
  try {
    return render_to_files(r, *t);
  } catch (const std::bad_alloc&) {
    return bad_input(fmt::format("not enough memory for {}x{} pixels", r.settings.size.width,
                                 r.settings.size.height));
  }
}

} // namespace

int main(int argc, char** argv) { return run_program("graze-render", argc, argv, start); }
