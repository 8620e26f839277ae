// graze-traversal-bench surface: what a first hit costs, against NL and against the octree's level,
// on each path and for the scalar code. graze-traversal-bench certified: a certified hit beside the
// descent to level 30. graze-traversal-bench table: the paper's Table 1, ray casting.
// graze-traversal-bench error: how far the descent's hits are from the certified ones, against NL.
// One core; medians; the contenders in turn in each repetition, so that what else the machine does
// meets all of them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <graze/octree/exact.hpp>
#include <graze/octree/gargantini.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/plain.hpp>
#include <graze/octree/published.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/rounding/split.hpp>
#include <string>
#include <time.h>
#include <vector>

namespace {
using namespace graze;
using namespace graze::octree;

struct options {
  int repetitions = 5;
  int size = 512;
  bool json = false;
  std::string scene; ///< of `surface`, `table` and `error`: only this one

  [[nodiscard]] bool wants(const char* name) const { return scene.empty() || scene == name; }
};

/// Of this thread's own time on the processor: on a quiet machine that is the wall clock's.
double seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

/// Seconds: median and quartiles.
struct spread {
  double low, middle, high;
};

spread spread_of(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return {x[x.size() / 4], x[x.size() / 2], x[x.size() - 1 - x.size() / 4]};
}

/// DESIGN's camera, without its framing: size x size rays.
std::vector<ray> camera_rays(double scale, int size) {
  std::vector<ray> rays;
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const double u = (i + 0.5) / size - 0.5, v = 0.5 - (j + 0.5) / size;
      rays.push_back(*ray::make({3 * scale, 2 * scale, 6 * scale},
                                {-3 + u * 3.578125 + v * -0.51171875, -2 + v * 3.8330078125,
                                 -6 + u * -1.7890625 + v * -1.0224609375}));
    }
  return rays;
}

/// One line of the result: a scene, an octree's level, NL, and a contender.
void print(const options& how, const char* scene, const char* what, const char* path, int stored,
           int levels, double steps, double rays, const spread& t) {
  const double rate = rays / t.middle, milliseconds = 1e3 * t.middle;
  if (how.json)
    std::printf("{\"scene\": \"%s\", \"what\": \"%s\", \"path\": \"%s\", \"octree_level\": %d, "
                "\"levels\": %d, \"steps_per_ray\": %.2f, \"rays\": %.0f, "
                "\"rays_per_second\": %.0f, \"milliseconds\": %.4f, \"milliseconds_low\": %.4f, "
                "\"milliseconds_high\": %.4f, \"repetitions\": %d}\n",
                scene, what, path, stored, levels, steps, rays, rate, milliseconds, 1e3 * t.low,
                1e3 * t.high, how.repetitions);
  else if (std::strcmp(what, "voxelize") == 0)
    std::printf("%-10s voxelize  level %2d         %-8s %8.2f ms\n", scene, stored, path,
                milliseconds);
  else
    std::printf("%-10s first hit level %2d NL %2d   %-8s %8.3f M rays/s %6.1f steps/ray %5.1f "
                "ns/step\n",
                scene, stored, levels, path, rate / 1e6, steps, 1e9 / (rate * steps));
  std::fflush(stdout);
}

struct contender {
  std::string name;
  std::function<void()> run;
  std::vector<double> times;
};

void measure(std::vector<contender>& all, int repetitions) {
  for (contender& c : all)
    c.run(); // warm
  for (int r = 0; r < repetitions; ++r)
    for (contender& c : all) {
      const double start = seconds();
      c.run();
      c.times.push_back(seconds() - start);
    }
}

template <class F>
void first_hits(const options& how, const char* scene, const box& domain,
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
  measure(all, how.repetitions);
  for (const contender& c : all)
    print(how, scene, "first_hit", c.name.c_str(), stored, levels, steps,
          static_cast<double>(rays.size()), spread_of(c.times));
}

template <class F> void surface(const options& how, const char* scene, double scale, double reach) {
  if (!how.wants(scene))
    return;
  const box domain{{-reach, -reach, -reach}, {reach, reach, reach}};
  const std::vector<ray> rays = camera_rays(scale, how.size);
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
    measure(all, std::max(9, how.repetitions));
    for (const contender& c : all)
      print(how, scene, "voxelize", c.name.c_str(), 9, 9, 0, 0, spread_of(c.times));
  }
  for (const int levels : {10, 15, 20, 25, 30, 35, 40, 45, 50, 53})
    first_hits<F>(how, scene, domain, rays, 9, levels, true);
  for (const int stored : {5, 6, 7, 8, 10, 11})
    first_hits<F>(how, scene, domain, rays, stored, 30, true);
}

/// The octree of the descent is made beforehand; certified hits need none.
template <class F>
void certified(const options& how, const char* scene, double scale, double reach) {
  const box domain{{-reach, -reach, -reach}, {reach, reach, reach}};
  const std::vector<ray> rays = camera_rays(scale, how.size);
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
  measure(all, how.repetitions);
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
    if (how.json)
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

/// What the paper's Table 1 has of ray casting, seconds on a Pentium 4 of 2.4 GHz; 0: the cell is
/// lost.
struct paper_row {
  double gargantini, ours, with_sse2;
};

/// A column of Table 1: its rays' first hits.
struct column {
  const char* name;
  double paper;
  std::function<void(std::vector<surface_hit>&)> run; ///< empty where it cannot be run here
  std::vector<double> times;
  std::vector<surface_hit> hits;
};

/// By the traversal M, the surface evaluated by B, scalar code.
template <class F, class M, rounding::Backend B>
column scalar_column(const char* name, double paper, const box& domain, const sparse_octree& octree,
                     const std::vector<ray>& rays) {
  const auto made = surface_traversal<F, M, B>::make(F{}, domain, octree, 30);
  if (!made)
    std::abort();
  return {name,
          paper,
          [t = *made, &rays](std::vector<surface_hit>& hits) {
            for (std::size_t i = 0; i < rays.size(); ++i)
              hits[i] = t.first_hit(rays[i]);
          },
          {},
          {}};
}

bool same_leaf(const surface_hit& a, const surface_hit& b) {
  return a.leaf.size == b.leaf.size && (a.leaf.size == 0 || a.leaf.lo == b.leaf.lo);
}

/// One row for each column of the scene. A repetition takes all columns in turn; what takes more
/// than 3 s is run once.
template <class F>
void paper_table(const options& how, const char* scene, double scale, double reach,
                 const paper_row& paper) {
  if (!how.wants(scene))
    return;
  const box domain{{-reach, -reach, -reach}, {reach, reach, reach}};
  const std::vector<ray> rays = camera_rays(scale, how.size);
  const auto octree = voxelize_in_lanes(F{}, domain, 9);
  if (!octree)
    std::abort();
  using rounding::nearest, rounding::split, rounding::upward;
  constexpr convention owned = convention::owned;
  std::vector<column> all;
  all.push_back(scalar_column<F, gargantini, undirected>("gargantini", paper.gargantini, domain,
                                                         *octree, rays));
  all.push_back(scalar_column<F, plain, undirected>("plain", paper.ours, domain, *octree, rays));
  all.push_back(
      scalar_column<F, published, nearest>("published", paper.with_sse2, domain, *octree, rays));
  all.push_back(scalar_column<F, sound<split, owned>, split>("split", paper.with_sse2, domain,
                                                             *octree, rays));
  all.push_back(scalar_column<F, sound<upward, owned>, upward>("upward", 0, domain, *octree, rays));
  all.push_back({"avx512", 0, {}, {}, {}});
  if (const auto t = lane_traversal<F>::make(F{}, domain, *octree, 30, batch::path::avx512))
    all.back().run = [t = *t, &rays](std::vector<surface_hit>& hits) { t.first_hits(rays, hits); };
  all.push_back(scalar_column<F, exact<upward, owned>, upward>("exact", 0, domain, *octree, rays));
  for (int r = 0; r < how.repetitions; ++r)
    for (column& c : all) {
      if (!c.run || (!c.times.empty() && c.times[0] > 3))
        continue;
      c.hits.resize(rays.size());
      const double start = seconds();
      c.run(c.hits);
      c.times.push_back(seconds() - start);
    }
  for (const column& c : all) {
    if (!c.run) {
      std::printf("| %s | %s | not on this processor | | | | | |\n", scene, c.name);
      continue;
    }
    int hits = 0, undecided = 0, other = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits += c.hits[i].outcome == verdict::hit;
      undecided += c.hits[i].outcome == verdict::undecided;
      other += !same_leaf(c.hits[i], all.back().hits[i]);
    }
    const double t = median(c.times), count = static_cast<double>(rays.size());
    char then[64] = "- | -";
    const bool of_paper = &c - all.data() < 4;
    if (c.paper > 0)
      std::snprintf(then, sizeof then, "%.3f | %.0f", c.paper, 512 * 512 / c.paper);
    else if (of_paper)
      std::snprintf(then, sizeof then, "lost | lost");
    std::printf("| %s | %s | %.3f | %.0f | %s | %d | %d | %d |\n", scene, c.name, t, count / t,
                then, hits, undecided, other);
  }
  std::fflush(stdout);
}

/// Distances from the first root, along the ray, of the middle of what the descent to NL levels
/// finds, and of the middle of its first octant in space; beside half an octant's diagonal. Of the
/// pixels that both methods hit.
template <class F> void errors(const options& how, const char* scene, double scale, double reach) {
  if (!how.wants(scene))
    return;
  const box domain{{-reach, -reach, -reach}, {reach, reach, reach}};
  const std::vector<ray> rays = camera_rays(scale, how.size);
  const auto octree = voxelize_in_lanes(F{}, domain, 9);
  const auto along = lane_certified_traversal<F>::make(F{}, domain);
  if (!octree || !along)
    std::abort();
  std::vector<certified_hit> truth(rays.size());
  along->first_hits(rays, truth);
  std::vector<surface_hit> hits(rays.size());
  for (const int levels : {10, 20, 30, 40, 50}) {
    const auto descent = lane_traversal<F>::make(F{}, domain, *octree, levels);
    if (!descent)
      std::abort();
    descent->first_hits(rays, hits);
    std::vector<double> depths, distances;
    double widest = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].outcome != verdict::hit || truth[i].outcome != verdict::hit)
        continue;
      const vec3 &o = rays[i].origin(), &d = rays[i].direction();
      const double length = std::hypot(d[0], d[1], d[2]);
      const long double t = (static_cast<long double>(truth[i].t_near) + truth[i].t_far) / 2;
      const long double middle = (static_cast<long double>(hits[i].t_near) + hits[i].t_far) / 2;
      depths.push_back(static_cast<double>(std::fabs(middle - t)) * length);
      widest = std::max(widest, (truth[i].t_far - truth[i].t_near) / 2 * length);
      long double squares = 0;
      for (int a = 0; a < 3; ++a) {
        const long double apart = o[a] + t * d[a] - hits[i].leaf.mid(a);
        squares += apart * apart;
      }
      distances.push_back(static_cast<double>(std::sqrt(squares)));
    }
    if (depths.empty())
      continue;
    const double size = octree->box().size, bound = std::sqrt(3.0) * std::ldexp(size, -levels - 1);
    const auto beyond = [bound](const std::vector<double>& x) {
      return std::count_if(x.begin(), x.end(), [bound](double e) { return e > bound; });
    };
    std::printf("| %s | %d | %.2e | %.2e | %.2e | %td | %.2e | %.2e | %td | %zu | %.1e |\n", scene,
                levels, bound, median(depths), *std::max_element(depths.begin(), depths.end()),
                beyond(depths), median(distances),
                *std::max_element(distances.begin(), distances.end()), beyond(distances),
                depths.size(), widest);
  }
}

int complain(const char* why) {
  std::fprintf(stderr,
               "graze-traversal-bench: %s\n"
               "usage: graze-traversal-bench surface|certified|table|error [--repetitions N] "
               "[--size PIXELS] "
               "[--json] [--scene NAME]\n",
               why);
  return 2;
}

} // namespace

int main(int argc, char** argv) {
  options how;
  const std::string mode = argc < 2 ? "" : argv[1];
  if (mode != "surface" && mode != "certified" && mode != "table" && mode != "error")
    return complain("the mode must be surface, certified, table or error");
  for (int i = 2; i < argc; ++i) {
    const std::string a = argv[i];
    const auto number = [&](int& to, int most) {
      to = i + 1 < argc ? std::atoi(argv[++i]) : 0;
      return to >= 1 && to <= most;
    };
    if (a == "--json")
      how.json = true;
    else if (a == "--scene" && i + 1 < argc)
      how.scene = argv[++i];
    else if (a == "--repetitions" && number(how.repetitions, 1000))
      continue;
    else if (a == "--size" && number(how.size, 4096))
      continue;
    else
      return complain(("bad option " + a).c_str());
  }
  if (mode == "certified") {
    certified<tanglecube>(how, "tanglecube", 2, 2.5);
    certified<quartdef>(how, "quartdef", 1.125, 1.5);
    certified<holesrot>(how, "holesrot", 2, 2);
    certified<spheres>(how, "spheres", 1.5, 2.5);
    return 0;
  }
  if (mode == "table") {
    std::printf(
        "| scene | column | s | rays/s | paper, s | paper, rays/s | hits | undecided | rays "
        "whose octant is not that of exact |\n|---|---|---|---|---|---|---|---|---|\n");
    // Gar., Ours, with SSE2
    paper_table<spheres>(how, "spheres", 1.5, 2.5, {15.516, 15.235, 19.860});
    paper_table<quartdef>(how, "quartdef", 1.125, 1.5, {26.109, 0, 0});
    paper_table<tanglecube>(how, "tanglecube", 2, 2.5, {30.719, 0, 0});
    paper_table<holesrot>(how, "holesrot", 2, 2, {30.469, 0, 0});
    paper_table<asterisk<3, 4>>(how, "asterisk(3,4)", 0.5, 1, {113.875, 109.546, 0});
    paper_table<asterisk<9, 18>>(how, "asterisk(9,18)", 0.5, 1, {0, 0, 140.562});
    return 0;
  }
  if (mode == "error") {
    std::printf("| scene | NL | sqrt(3) 2^(-NL-1) of the root | depth: median | greatest | pixels "
                "beyond | octant's middle: median | greatest | pixels beyond | pixels | half width "
                "of the certified, at most |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    errors<tanglecube>(how, "tanglecube", 2, 2.5);
    errors<spheres>(how, "spheres", 1.5, 2.5);
    return 0;
  }
  surface<tanglecube>(how, "tanglecube", 2, 2.5);
  surface<quartdef>(how, "quartdef", 1.125, 1.5);
}
