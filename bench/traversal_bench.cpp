// graze-traversal-bench surface: what a first hit costs, against NL and against the octree's level,
// on each path and for the scalar code. graze-traversal-bench certified: a certified hit beside the
// descent to level 30. graze-traversal-bench images: every method's seconds, depth error and wrong
// pixels, against NL; graze-traversal-bench table: the paper's Table 1 (traversal_images.cpp).
// One core; medians; the contenders in turn in each repetition, so that what else the machine does
// meets all of them.
#include "traversal_bench.hpp"
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/rounding/environment.hpp>

namespace {
using namespace graze;
using namespace graze::octree;
using namespace graze::bench;

/// One line of the result: a scene, an octree's level, NL, and a contender.
void print(const options& settings, const char* scene, const char* measured, const char* path,
           int stored, int levels, double steps, double rays, const spread& t) {
  const double rate = rays / t.middle, milliseconds = 1e3 * t.middle;
  if (settings.json)
    std::printf("{\"scene\": \"%s\", \"what\": \"%s\", \"path\": \"%s\", \"octree_level\": %d, "
                "\"levels\": %d, \"steps_per_ray\": %.2f, \"rays\": %.0f, "
                "\"rays_per_second\": %.0f, \"milliseconds\": %.4f, \"milliseconds_low\": %.4f, "
                "\"milliseconds_high\": %.4f, \"repetitions\": %d}\n",
                scene, measured, path, stored, levels, steps, rays, rate, milliseconds, 1e3 * t.low,
                1e3 * t.high, settings.repetitions);
  else if (std::strcmp(measured, "voxelize") == 0)
    std::printf("%-10s voxelize  level %2d         %-8s %8.2f ms\n", scene, stored, path,
                milliseconds);
  else
    std::printf("%-10s first hit level %2d NL %2d   %-8s %8.3f M rays/s %6.1f steps/ray %5.1f "
                "ns/step\n",
                scene, stored, levels, path, rate / 1e6, steps, 1e9 / (rate * steps));
  std::fflush(stdout);
}

template <class F>
void first_hits(const options& settings, const char* scene, const box& domain,
                const std::vector<ray>& rays, int stored, int levels, bool scalar_too) {
  const auto octree = voxelize_in_lanes(F{}, domain, stored);
  if (!octree)
    return;
  std::vector<surface_hit> hits(rays.size());
  std::vector<contender> all;
  double steps = 0;
  for (const batch::path p : batch::paths)
    if (const auto t = lane_traversal<F>::make(F{}, domain, *octree, levels, p))
      all.push_back({batch::name(p),
                     [t = *t, &rays, &hits, &steps] {
                       traversal_counts counts;
                       t.first_hits(rays, hits, &counts);
                       steps = static_cast<double>(counts.cells_opened) /
                               static_cast<double>(rays.size());
                     },
                     {}});
  if (scalar_too)
    if (const auto t = surface_traversal<F>::make(F{}, domain, *octree, levels))
      all.push_back({"scalar",
                     [t = *t, &rays, &hits] {
                       for (std::size_t i = 0; i < rays.size(); ++i)
                         hits[i] = t.first_hit(rays[i]);
                     },
                     {}});
  measure(all, settings.repetitions);
  for (const contender& c : all)
    print(settings, scene, "first_hit", c.name.c_str(), stored, levels, steps,
          static_cast<double>(rays.size()), spread_of(c.times));
}

template <class F> void surface(const options& settings, const built_in_surface<F>& row) {
  const char* const scene = row.name;
  const box domain = row.domain();
  const std::vector<ray> rays = camera_rays(row.scale, settings.size);
  {
    std::vector<contender> all;
    for (const batch::path p : batch::paths)
      if (!batch::refusal(p))
        all.push_back({batch::name(p),
                       [&domain, p] {
                         if (!voxelize_in_lanes(F{}, domain, 9, p))
                           std::abort();
                       },
                       {}});
    all.push_back({"scalar",
                   [&domain] {
                     if (!voxelize(F{}, domain, 9))
                       std::abort();
                   },
                   {}});
    measure(all, std::max(9, settings.repetitions));
    for (const contender& c : all)
      print(settings, scene, "voxelize", c.name.c_str(), 9, 9, 0, 0, spread_of(c.times));
  }
  for (const int levels : {10, 15, 20, 25, 30, 35, 40, 45, 50, 53})
    first_hits<F>(settings, scene, domain, rays, 9, levels, true);
  for (const int stored : {5, 6, 7, 8, 10, 11})
    first_hits<F>(settings, scene, domain, rays, stored, 30, true);
}

/// The octree of the descent is made beforehand; certified hits need none.
template <class F> void certified(const options& settings, const built_in_surface<F>& row) {
  const char* const scene = row.name;
  const box domain = row.domain();
  const std::vector<ray> rays = camera_rays(row.scale, settings.size);
  const auto octree = voxelize_in_lanes(F{}, domain, 9);
  if (!octree)
    return;
  std::vector<surface_hit> coarse(rays.size());
  std::vector<certified_hit> hits(rays.size());
  std::uint64_t steps = 0;
  std::vector<contender> all;
  for (const batch::path p : batch::paths) {
    const auto descent = lane_traversal<F>::make(F{}, domain, *octree, 30, p);
    const auto along = lane_certified_traversal<F>::make(F{}, domain, p);
    if (!descent || !along)
      continue;
    all.push_back({"descent", [t = *descent, &rays, &coarse] { t.first_hits(rays, coarse); }, {}});
    all.push_back({batch::name(p),
                   [t = *along, &rays, &hits, &steps] {
                     steps = 0;
                     t.first_hits(rays, hits, &steps);
                   },
                   {}});
  }
  measure(all, settings.repetitions);
  std::vector<double> ulps;
  int undecided = 0;
  for (const certified_hit& h : hits) {
    undecided += h.outcome == verdict::undecided;
    if (h.outcome == verdict::hit)
      ulps.push_back((h.t_far - h.t_near) / (std::nextafter(h.t_near, 2 * h.t_near) - h.t_near));
  }
  const double median_ulps = ulps.empty() ? 0 : median(ulps);
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
    const double slow = median(all[i].times), fast = median(all[i + 1].times);
    const char* const path = all[i + 1].name.c_str();
    if (settings.json)
      std::printf("{\"scene\": \"%s\", \"what\": \"certified\", \"path\": \"%s\", "
                  "\"descent_seconds\": %.5f, \"certified_seconds\": %.5f, "
                  "\"steps_per_ray\": %.2f, \"hits\": %zu, \"undecided\": %d, "
                  "\"median_width_ulps\": %.0f}\n",
                  scene, path, slow, fast,
                  static_cast<double>(steps) / static_cast<double>(rays.size()), ulps.size(),
                  undecided, median_ulps);
    else
      std::printf("%-10s %-8s descent to NL 30 %.4f s, certified %.4f s (%4.1f times), %.2f "
                  "steps/ray, %zu hits, %d undecided, median width %.0f ulps\n",
                  scene, path, slow, fast, slow / fast,
                  static_cast<double>(steps) / static_cast<double>(rays.size()), ulps.size(),
                  undecided, median_ulps);
  }
}

/// "a,b,c"
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

int complain(const char* why) {
  std::fprintf(
      stderr,
      "graze-traversal-bench: %s\n"
      "usage: graze-traversal-bench surface|certified|images|table [--repetitions N] "
      "[--size PIXELS] [--json] [--scene NAME]\n"
      "images: [--levels NL,NL,..] [--methods NAME,NAME,..] [--seconds S] [--truth FILE]\n",
      why);
  return 2;
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-traversal-bench"))
    return 2;
  options settings;
  const std::string mode = argc < 2 ? "" : argv[1];
  if (mode != "surface" && mode != "certified" && mode != "images" && mode != "table")
    return complain("the mode must be surface, certified, images or table");
  for (int i = 2; i < argc; ++i) {
    const std::string a = argv[i];
    const auto number = [&](int& to, int most) {
      to = i + 1 < argc ? std::atoi(argv[++i]) : 0;
      return to >= 1 && to <= most;
    };
    if (a == "--json")
      settings.json = true;
    else if (a == "--scene" && i + 1 < argc)
      settings.scene = argv[++i];
    else if (a == "--methods" && i + 1 < argc)
      settings.methods = parts_of(argv[++i]);
    else if (a == "--truth" && i + 1 < argc)
      settings.truth = argv[++i];
    else if (a == "--seconds" && i + 1 < argc)
      settings.seconds = std::atof(argv[++i]);
    else if (a == "--levels" && i + 1 < argc) {
      settings.levels.clear();
      for (const std::string& level : parts_of(argv[++i])) {
        settings.levels.push_back(std::atoi(level.c_str()));
        if (level.empty() || settings.levels.back() < 0 || settings.levels.back() > 53)
          return complain("a level must be 1 to 53, or 0 for certified hits alone");
      }
    } else if (a == "--repetitions" && number(settings.repetitions, 1000))
      continue;
    else if (a == "--size" && number(settings.size, 4096))
      continue;
    else
      return complain(("bad option " + a).c_str());
  }
  if (mode == "images")
    return images(settings);
  if (mode == "table")
    return table(settings);
  for_each_built_in([&]<class F>(const built_in_surface<F>& row) {
    if constexpr (is_algebraic<F>()) // others take minutes
      if (settings.wants(row.name))
        mode == "certified" ? certified(settings, row) : surface(settings, row);
  });
  return 0;
}
