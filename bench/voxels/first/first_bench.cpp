// graze-first-hits: the first occupied voxel of a sphere shell on each ray, by this library and by
// others, on one core, and whether it is the first one by exact arithmetic.
#include "first_hits.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <graze/batch.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/rounding/environment.hpp>
#include <judge.hpp>
#include <rays.hpp>
#include <string_view>

namespace {

using namespace graze;
using namespace graze::bench;
using rays = std::vector<octree::ray>;

double cpu_seconds_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

auto in_lanes(std::shared_ptr<const octree::voxel_set> set, batch::path path) {
  return [set = std::move(set), path](std::span<const octree::ray> some, octant_key* hits) {
    batch::force_path(path);
    std::vector<std::optional<octree::voxel>> found(some.size());
    octree::first_voxels(*set, some, octree::exactness::exact, found);
    for (const auto& v : found)
      *hits++ = v ? v->packed : no_octant;
  };
}

std::vector<first_hit_contestant> contestants(const occupied_octants& octants) {
  std::vector<first_hit_contestant> all;
  const auto keep = [&](std::vector<first_hit_contestant> some) {
    for (auto& c : some)
      all.push_back(std::move(c));
  };
  const double edge = octants.edge();
  const std::uint32_t side = 1u << octants.level;
  const auto set = [&](const auto& planes) {
    return std::make_shared<const octree::voxel_set>(
        *octree::voxel_set::make(planes, std::span(octants.indices)));
  };
  const auto over = [&](octree::plane_rule rule) {
    return set(*octree::grid::make(octants.root.lo, {edge, edge, edge}, {side, side, side}, rule));
  };
  const auto of_octants = set(*octree::root_cube::make(octants.root, octants.level)),
             of_doubles = over(octree::plane_rule::rounded),
             of_reals = over(octree::plane_rule::exact);
  for (const batch::path p : {batch::path::avx512, batch::path::avx2, batch::path::baseline})
    if (!batch::refusal(p)) {
      const std::string path = batch::name(p);
      all.push_back({"octants, " + path, "graze", in_lanes(of_octants, p)});
      all.push_back({"grid of doubles, " + path, "graze", in_lanes(of_doubles, p)});
      all.push_back({"grid of real numbers, " + path, "graze", in_lanes(of_reals, p)});
    }
#ifdef GRAZE_FIRST_embree
  keep(embree_first_hits(octants));
#endif
#ifdef GRAZE_FIRST_nanovdb
  keep(nanovdb_first_hits(octants));
#endif
#ifdef GRAZE_FIRST_octomap
  keep(octomap_first_hits(octants));
#endif
#ifdef GRAZE_FIRST_pcl
  keep(pcl_first_hits(octants));
#endif
  return all;
}

/// Of rays: right is none where no voxel is crossed, and a touched voxel that is entered no later
/// than the first crossed one.
struct first_verdict {
  std::size_t rays = 0, hit = 0, missed = 0, untouched = 0;
};

class first_judge {
public:
  explicit first_judge(const occupied_octants& octants) : octants_(octants), exact_(octants) {}

  void add(const octree::ray& r, const std::vector<octant_key>& answers,
           std::vector<first_verdict>& verdicts) const {
    const std::vector<touched_octant> touched = exact_.touched(r);
    std::vector<mpq_class> entries;
    std::optional<mpq_class> first;
    for (const touched_octant& v : touched) {
      const auto index = peers::index_of(v.key);
      entries.push_back(oracle::rational::range_in(r.origin(), r.direction(),
                                                   octants_.corner(index, 0),
                                                   octants_.corner(index, 1))
                            ->first);
      if (v.crossed && (!first || entries.back() < *first))
        first = entries.back();
    }
    for (std::size_t c = 0; c < answers.size(); ++c) {
      first_verdict& v = verdicts[c];
      ++v.rays;
      v.hit += first.has_value();
      if (answers[c] == no_octant) {
        v.missed += first.has_value();
        continue;
      }
      const auto is = std::find_if(touched.begin(), touched.end(),
                                   [&](const touched_octant& t) { return t.key == answers[c]; });
      if (is == touched.end())
        ++v.untouched;
      else if (first && *first < entries[static_cast<std::size_t>(is - touched.begin())])
        ++v.missed;
    }
  }

private:
  const occupied_octants& octants_;
  exact_octants exact_;
};

struct options {
  std::size_t rays = 200'000, blocks = 20, judged = 4'000, level = 9;
  std::string only;
  bool json = false;
};

/// Blocks of rays, each by all in turn, so that a slow second is everybody's; one ahead warms up.
std::vector<std::vector<double>> time(const std::vector<first_hit_contestant>& all, const rays& r,
                                      const options& settings) {
  std::vector<std::vector<double>> rates(all.size());
  const std::size_t size = (r.size() + settings.blocks - 1) / settings.blocks;
  std::vector<octant_key> hits(size);
  for (std::size_t block = 0; block <= settings.blocks; ++block) {
    const std::size_t from = (block == 0 ? 0 : block - 1) * size,
                      to = std::min(from + size, r.size());
    for (std::size_t c = 0; from < to && c < all.size(); ++c) {
      const double start = cpu_seconds_now();
      all[c].trace({r.data() + from, to - from}, hits.data());
      const double seconds = cpu_seconds_now() - start;
      if (block != 0)
        rates[c].push_back(static_cast<double>(to - from) / seconds);
    }
  }
  return rates;
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x.empty() ? 0 : x[x.size() / 2];
}

const char* const usage = "usage: graze-first-hits [--rays=N] [--blocks=N] [--judged=N] "
                          "[--level=1..11] [--only=TEXT] [--json]\n"
                          "  --rays    random rays that are timed (200000)\n"
                          "  --blocks  parts of them, each by all in turn (20)\n"
                          "  --judged  rays of each kind that are judged exactly (4000)\n"
                          "  --level   of the octants (9)\n"
                          "  --only    those with TEXT in their name\n";

bool read(std::string_view argument, options& o) {
  const auto number = [&](std::string_view name, std::size_t& x) {
    if (!argument.starts_with(name))
      return false;
    char* end = nullptr;
    const double value = std::strtod(argument.data() + name.size(), &end);
    x = static_cast<std::size_t>(value);
    return *end == '\0' && value >= 1 && value <= 1e9;
  };
  if (argument.starts_with("--only=")) {
    o.only = argument.substr(7);
    return true;
  }
  if (argument == "--json")
    return o.json = true;
  return number("--rays=", o.rays) || number("--blocks=", o.blocks) ||
         number("--judged=", o.judged) || number("--level=", o.level);
}

} // namespace

int main(int argc, char** argv) {
  if (!rounding::program_may_start("graze-first-hits"))
    return 2;
  options settings;
  for (int i = 1; i < argc; ++i)
    if (!read(argv[i], settings))
      return std::fputs(usage, stderr), 2;
  if (settings.level > 11)
    return std::fputs(usage, stderr), 2;
  const occupied_octants octants = sphere_shell(static_cast<int>(settings.level));
  std::vector<first_hit_contestant> all = contestants(octants);
  std::erase_if(all, [&](const first_hit_contestant& c) {
    return c.name.find(settings.only) == std::string::npos;
  });
  if (all.empty()) {
    std::fprintf(stderr, "graze-first-hits: none has \"%s\" in its name\n", settings.only.c_str());
    return 2;
  }
  const auto rates = time(all, random_rays(settings.rays, 1), settings);
  const std::pair<const char*, rays> kinds[]{
      {"random", random_rays(settings.judged, 2)},
      {"adversarial float", adversarial_rays(octants, precision::single, settings.judged, 3)},
      {"adversarial double", adversarial_rays(octants, precision::twice, settings.judged, 4)}};
  const first_judge judge(octants);
  std::vector<std::vector<first_verdict>> verdicts;
  for (const auto& [kind, some] : kinds) {
    verdicts.emplace_back(all.size());
    for (const octree::ray& r : some) {
      std::vector<octant_key> answers(all.size());
      for (std::size_t c = 0; c < all.size(); ++c)
        all[c].trace({&r, 1}, &answers[c]);
      judge.add(r, answers, verdicts.back());
    }
  }
  if (!settings.json)
    std::printf("sphere shell, level %zu: %zu voxels; %zu random rays, one core; of %zu rays of "
                "each kind: first "
                "voxel missed / reported though not touched\n%-36s %9s  %-16s %-18s %s\n",
                settings.level, octants.indices.size(), settings.rays, settings.judged,
                "first hits", "Mrays/s", kinds[0].first, kinds[1].first, kinds[2].first);
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (settings.json) {
      std::printf("{\"name\": \"%s\", \"kind\": \"%s\", \"rays_a_second\": [", all[c].name.c_str(),
                  all[c].kind.c_str());
      for (std::size_t k = 0; k < rates[c].size(); ++k)
        std::printf("%s%.0f", k == 0 ? "" : ", ", rates[c][k]);
      std::printf("], \"judged\": {");
      for (std::size_t k = 0; k < verdicts.size(); ++k)
        std::printf("%s\"%s\": {\"rays\": %zu, \"hit\": %zu, \"missed\": %zu, \"untouched\": %zu}",
                    k == 0 ? "" : ", ", kinds[k].first, verdicts[k][c].rays, verdicts[k][c].hit,
                    verdicts[k][c].missed, verdicts[k][c].untouched);
      std::puts("}}");
      continue;
    }
    std::printf("%-36s %9.3f ", all[c].name.c_str(), median(rates[c]) * 1e-6);
    for (std::size_t k = 0; k < verdicts.size(); ++k)
      std::printf(" %7zu / %-7zu", verdicts[k][c].missed, verdicts[k][c].untouched);
    std::puts("");
  }
  return 0;
}
