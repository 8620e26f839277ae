// graze-traversal-bench images: seconds, depth error and wrong pixels of every method against NL,
// judged by exact first roots. graze-traversal-bench table: the paper's Table 1 today.
#include "traversal_bench.hpp"
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <graze/octree/exact.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/rounding/split.hpp>
#include <limits>
#include <peers/paper2005/gargantini.hpp>
#include <peers/paper2005/plain.hpp>
#include <peers/paper2005/published.hpp>
#include <support/exact_roots.hpp>

namespace graze::bench {
namespace {
using namespace graze;
using namespace graze::octree;
using namespace graze::peers;

/// What the paper's Table 1 has of ray casting, seconds on a Pentium 4 of 2.4 GHz; 0: the cell is
/// lost.
struct paper_row {
  double gargantini, ours, with_sse2;
};

paper_row paper_times(std::string_view scene) {
  struct named_row {
    std::string_view scene;
    paper_row times;
  };
  constexpr named_row rows[] = {
      {"spheres", {15.516, 15.235, 19.860}},    {"quartdef", {26.109, 0, 0}},
      {"tanglecube", {30.719, 0, 0}},           {"holesrot", {30.469, 0, 0}},
      {"asterisk(3,4)", {113.875, 109.546, 0}}, {"asterisk(9,18)", {0, 0, 140.562}}};
  for (const named_row& row : rows)
    if (row.scene == scene)
      return row.times;
  return {0, 0, 0};
}

/// The first root of a pixel's ray: at t = head + tail, within half_width; no number where the
/// exact ray misses, infinity where it is not known.
struct root {
  double head, tail, half_width;

  [[nodiscard]] long double t() const { return static_cast<long double>(head) + tail; }
  [[nodiscard]] bool is_hit() const { return std::isfinite(head); }
  [[nodiscard]] bool is_miss() const { return std::isnan(head); }
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double unknown = std::numeric_limits<double>::infinity();

template <class F> root exact_root(const F& f, const ray& r, const box& domain) {
  const auto found = support::first_root(f, r, domain);
  if (!found)
    return {none, 0, 0};
  const mpq_class middle = (found->lo + found->hi) / 2;
  const double head = oracle::double_below(middle);
  return {head, oracle::double_below(middle - head), 0};
}

template <class F> std::vector<root> make_truth(const box& domain, const std::vector<ray>& rays) {
  std::vector<root> truth;
  if constexpr (is_algebraic<F>()) {
    for (const ray& r : rays)
      truth.push_back(exact_root(F{}, r, domain));
  } else {
    const auto along = lane_certified_traversal<F>::make(F{}, domain);
    std::vector<certified_hit> hits(rays.size());
    if (!along)
      std::abort();
    along->first_hits(rays, hits);
    for (const certified_hit& h : hits) {
      const long double t = (static_cast<long double>(h.t_near) + h.t_far) / 2;
      const auto head = static_cast<double>(t);
      if (h.outcome == verdict::hit)
        truth.push_back({head, static_cast<double>(t - head), (h.t_far - h.t_near) / 2});
      else
        truth.push_back({h.outcome == verdict::miss ? none : unknown, 0, 0});
    }
  }
  return truth;
}

/// Read from the file where it is there and of that many rays; else made, and written to it.
template <class F>
std::vector<root> truth_of(const options& settings, const box& domain,
                           const std::vector<ray>& rays) {
  std::vector<root> truth(rays.size());
  const auto bytes = static_cast<std::streamsize>(rays.size() * sizeof(root));
  if (!settings.truth.empty()) {
    std::ifstream in(settings.truth, std::ios::binary);
    if (in.read(reinterpret_cast<char*>(truth.data()), bytes) && in.peek() == EOF)
      return truth;
  }
  truth = make_truth<F>(domain, rays);
  if (!settings.truth.empty() && !std::ofstream(settings.truth, std::ios::binary)
                                      .write(reinterpret_cast<const char*>(truth.data()), bytes))
    std::fprintf(stderr, "graze-traversal-bench: %s cannot be written\n", settings.truth.c_str());
  return truth;
}

/// A way to a scene's first hits.
struct method {
  const char* name;
  double paper;              ///< seconds in the paper's Table 1; 0: lost or not there
  bool of_paper;             ///< a column of that table
  std::function<void()> run; ///< fills `hits`
  std::vector<surface_hit> hits;
  std::vector<double> times;
};

/// By the traversal M, the surface evaluated by B, scalar code.
template <class F, class M, rounding::Backend B>
void add_scalar(std::vector<method>& all, const char* name, double paper, bool of_paper,
                const box& domain, const sparse_octree& octree, int levels,
                const std::vector<ray>& rays) {
  const auto made = surface_traversal<F, M, B>::make(F{}, domain, octree, levels);
  if (!made)
    return; // not at so many levels
  method& m = all.emplace_back(method{name, paper, of_paper, {}, {}, {}});
  m.hits.resize(rays.size());
  m.run = [t = *made, &rays, &hits = m.hits] {
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = t.first_hit(rays[i]);
  };
}

/// The methods by descent to a level, in the order of Table 1.
template <class F>
void add_descents(std::vector<method>& all, const options& settings, const box& domain,
                  const sparse_octree& octree, int levels, const paper_row& paper,
                  const std::vector<ray>& rays) {
  using rounding::nearest, rounding::split, rounding::upward;
  constexpr convention owned = convention::owned;
  const auto scalar = [&]<class M, rounding::Backend B>(const char* name, double then,
                                                        bool of_paper) {
    if (settings.wants_method(name))
      add_scalar<F, M, B>(all, name, then, of_paper, domain, octree, levels, rays);
  };
  scalar.template operator()<gargantini, undirected>("gargantini", paper.gargantini, true);
  scalar.template operator()<plain, undirected>("plain", paper.ours, true);
  scalar.template operator()<published, nearest>("published", paper.with_sse2, true);
  scalar.template operator()<sound<split, owned>, split>("split", paper.with_sse2, true);
  scalar.template operator()<sound<upward, owned>, upward>("upward", 0, false);
  for (const batch::path p : batch::paths) {
    if (!settings.wants_method(batch::name(p)))
      continue;
    const auto t = lane_traversal<F>::make(F{}, domain, octree, levels, p);
    if (!t)
      continue;
    method& m = all.emplace_back(method{batch::name(p), 0, false, {}, {}, {}});
    m.hits.resize(rays.size());
    m.run = [t = *t, &rays, &hits = m.hits] { t.first_hits(rays, hits); };
  }
  scalar.template operator()<exact<upward, owned>, upward>("exact", 0, false);
}

/// Certified hits along the ray, on each path. They have no level.
template <class F>
void add_certified(std::vector<method>& all, const options& settings, const box& domain,
                   const std::vector<ray>& rays) {
  static const std::string names[] = {"certified baseline", "certified avx2", "certified avx512"};
  for (const batch::path p : batch::paths)
    for (const std::string& name : names) {
      if (name != std::string("certified ") + batch::name(p) || !settings.wants_method(name))
        continue;
      const auto t = lane_certified_traversal<F>::make(F{}, domain, p);
      if (!t)
        continue;
      method& m = all.emplace_back(method{name.c_str(), 0, false, {}, {}, {}});
      m.hits.resize(rays.size());
      m.run = [t = *t, &rays, &hits = m.hits,
               found = std::vector<certified_hit>(rays.size())]() mutable {
        t.first_hits(rays, found);
        for (std::size_t i = 0; i < rays.size(); ++i)
          hits[i] = {found[i].outcome, found[i].t_near, found[i].t_far, {}, false};
      };
    }
}

/// All in turn, a repetition at a time. The first run of each warms up what is quick; a method that
/// has taken how.seconds is not repeated, nor one that takes a quarter of it at its first run.
void measure(std::vector<method>& all, const options& settings) {
  std::vector<double> taken(all.size());
  for (int r = 0; r <= settings.repetitions; ++r)
    for (std::size_t i = 0; i < all.size(); ++i) {
      method& m = all[i];
      if (!m.times.empty() && taken[i] > settings.seconds)
        continue;
      const double start = seconds();
      m.run();
      const double took = seconds() - start;
      taken[i] += took;
      if (r > 0 || took > settings.seconds / 4)
        m.times.push_back(took);
    }
}

/// What a method's hits are worth, beside the exact roots.
struct judgement {
  int hits = 0, undecided = 0, wrong_hits = 0, wrong_misses = 0;
  int not_enclosed = 0; ///< hits whose interval of t does not hold the first root
  int beyond = 0,
      octants_beyond = 0; ///< pixels with an error greater than half an octant's diagonal
  std::vector<double> depths, distances; ///< of the interval's middle, of the first octant's
};

judgement judge(const std::vector<surface_hit>& hits, const std::vector<root>& truth,
                const std::vector<ray>& rays, double half_diagonal) {
  judgement j;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const surface_hit& h = hits[i];
    j.hits += h.outcome == verdict::hit;
    j.undecided += h.outcome == verdict::undecided;
    if (truth.empty())
      continue;
    const root& first = truth[i];
    j.wrong_hits += h.outcome == verdict::hit && first.is_miss();
    j.wrong_misses += h.outcome == verdict::miss && first.is_hit();
    if (h.outcome != verdict::hit || !first.is_hit())
      continue;
    const vec3 &o = rays[i].origin(), &d = rays[i].direction();
    const long double t = first.t(), middle = (static_cast<long double>(h.t_near) + h.t_far) / 2;
    const double length = std::hypot(d[0], d[1], d[2]);
    j.not_enclosed += t + first.half_width < h.t_near || h.t_far < t - first.half_width;
    j.depths.push_back((static_cast<double>(std::fabs(middle - t)) + first.half_width) * length);
    j.beyond += half_diagonal > 0 && j.depths.back() > half_diagonal;
    if (h.leaf.size == 0)
      continue;
    long double squares = 0;
    for (int a = 0; a < 3; ++a) {
      const long double apart = o[a] + t * d[a] - h.leaf.mid(a);
      squares += apart * apart;
    }
    j.distances.push_back(static_cast<double>(std::sqrt(squares)));
    j.octants_beyond += j.distances.back() > half_diagonal;
  }
  return j;
}

bool same_leaf(const surface_hit& a, const surface_hit& b) {
  return a.leaf.size == b.leaf.size && (a.leaf.size == 0 || a.leaf.lo == b.leaf.lo);
}

/// A method at a level.
struct row {
  const char* scene;
  int levels; ///< 0 of certified hits
  double bound;
  const method* measured;
  judgement found;
  int other_octants; ///< rays whose first octant is not that of `exact`; -1 without it
};

void print_json(const row& r, const options& settings) {
  const method& m = *r.measured;
  const judgement& j = r.found;
  std::printf(
      "{\"what\": \"image\", \"scene\": \"%s\", \"size\": %d, \"method\": \"%s\", "
      "\"levels\": %d, \"seconds\": %.6f, \"quartiles\": [%.6f, %.6f], \"repetitions\": %zu, "
      "\"hits\": %d, \"undecided\": %d, \"wrong_hits\": %d, \"wrong_misses\": %d, "
      "\"not_enclosed\": %d, \"compared\": %zu, \"half_diagonal\": %.4e, "
      "\"depth\": [%.4e, %.4e, %.4e], \"beyond\": %d, "
      "\"octant\": [%.4e, %.4e], \"octants_beyond\": %d",
      r.scene, settings.size, m.name, r.levels, median(m.times), quantile(m.times, 0.25),
      quantile(m.times, 0.75), m.times.size(), j.hits, j.undecided, j.wrong_hits, j.wrong_misses,
      j.not_enclosed, j.depths.size(), r.bound, median(j.depths), quantile(j.depths, 0.999),
      quantile(j.depths, 1), j.beyond, median(j.distances), quantile(j.distances, 1),
      j.octants_beyond);
  if (r.other_octants >= 0)
    std::printf(", \"other_octants\": %d", r.other_octants);
  if (m.of_paper) // null: the cell is lost
    m.paper > 0 ? std::printf(", \"paper_seconds\": %.3f", m.paper)
                : std::printf(", \"paper_seconds\": null");
  std::printf("}\n");
}

void print_text(const row& r) {
  const judgement& j = r.found;
  std::printf("| %s | %s | %d | %.4f | %d | %d | %d | %d | %d | %.2e | %.2e | %.2e | %.2e | %d | "
              "%.2e | %.2e | %d |\n",
              r.scene, r.measured->name, r.levels, median(r.measured->times), j.hits, j.undecided,
              j.wrong_hits, j.wrong_misses, j.not_enclosed, r.bound, median(j.depths),
              quantile(j.depths, 0.999), quantile(j.depths, 1), j.beyond, median(j.distances),
              quantile(j.distances, 1), j.octants_beyond);
}

void print_table(const row& r, std::size_t rays) {
  const double t = median(r.measured->times), count = static_cast<double>(rays);
  char then[64] = "- | -";
  if (r.measured->paper > 0)
    std::snprintf(then, sizeof then, "%.3f | %.0f", r.measured->paper,
                  512 * 512 / r.measured->paper);
  else if (r.measured->of_paper)
    std::snprintf(then, sizeof then, "lost | lost");
  std::printf("| %s | %s | %.3f | %.0f | %s | %d | %d | %d |\n", r.scene, r.measured->name, t,
              count / t, then, r.found.hits, r.found.undecided, r.other_octants);
}

/// One row for each method at each level; `as_table` without a judgement.
template <class F>
void scene(const options& settings, bool as_table, const built_in_surface<F>& surface) {
  const char* const name = surface.name;
  const paper_row paper = paper_times(name);
  const box domain = surface.domain();
  const std::vector<ray> rays = camera_rays(surface.scale, settings.size);
  double start = seconds();
  const auto octree = voxelize_in_lanes(F{}, domain, 9);
  const double voxelized = seconds() - start;
  if (!octree)
    std::abort();
  start = seconds();
  const std::vector<root> truth =
      as_table ? std::vector<root>{} : truth_of<F>(settings, domain, rays);
  if (settings.json) {
    double widest = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const vec3& d = rays[i].direction();
      widest = std::max(widest, truth[i].half_width * std::hypot(d[0], d[1], d[2]));
    }
    const auto hits =
        std::count_if(truth.begin(), truth.end(), [](const root& r) { return r.is_hit(); });
    const auto misses =
        std::count_if(truth.begin(), truth.end(), [](const root& r) { return r.is_miss(); });
    std::printf(
        "{\"what\": \"scene\", \"scene\": \"%s\", \"size\": %d, \"truth\": \"%s\", \"hits\": %td, "
        "\"misses\": %td, \"truth_half_width\": %.3e, \"truth_seconds\": %.3f, \"octree_seconds\": "
        "%.5f}\n",
        name, settings.size, is_algebraic<F>() ? "exact" : "certified", hits, misses, widest,
        seconds() - start, voxelized);
  }
  const auto show = [&](int levels, std::vector<method>& all) {
    measure(all, settings);
    const double bound =
        levels == 0 ? 0 : std::sqrt(3.0) * std::ldexp(octree->root_octant().size, -levels - 1);
    const auto judge_of = std::find_if(all.begin(), all.end(), [](const method& m) {
      return std::string_view(m.name) == "exact";
    });
    for (const method& m : all) {
      row r{name, levels, bound, &m, judge(m.hits, truth, rays, bound), -1};
      if (judge_of != all.end()) {
        r.other_octants = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
          r.other_octants += !same_leaf(m.hits[i], judge_of->hits[i]);
      }
      as_table        ? print_table(r, rays.size())
      : settings.json ? print_json(r, settings)
                      : print_text(r);
    }
    std::fflush(stdout);
  };
  if (!as_table) {
    std::vector<method> along;
    along.reserve(3); // a method's run refers to its hits
    add_certified<F>(along, settings, domain, rays);
    show(0, along);
  }
  for (const int levels : settings.levels) {
    std::vector<method> all;
    all.reserve(9);
    add_descents<F>(all, settings, domain, *octree, levels, paper, rays);
    show(levels, all);
  }
}

int all_scenes(const options& settings, bool as_table) {
  for_each_built_in([&](const auto& surface) {
    if (settings.wants(surface.name))
      scene(settings, as_table, surface);
  });
  return 0;
}

} // namespace

int images(const options& settings) {
  if (!settings.json)
    std::printf(
        "| scene | method | NL | s | hits | undecided | wrong hits | wrong misses | not enclosed | "
        "sqrt(3) 2^(-NL-1) of the root | depth: median | 99.9 %% | greatest | pixels beyond | "
        "first octant's middle: median | greatest | pixels beyond |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  return all_scenes(settings, false);
}

int table(const options& settings) {
  options fixed = settings;
  fixed.levels = {30};
  fixed.methods = {"gargantini", "plain", "published", "split", "upward", "avx512", "exact"};
  std::printf("| scene | column | s | rays/s | paper, s | paper, rays/s | hits | undecided | rays "
              "whose octant is not that of exact |\n|---|---|---|---|---|---|---|---|---|\n");
  return all_scenes(fixed, true);
}

} // namespace graze::bench
