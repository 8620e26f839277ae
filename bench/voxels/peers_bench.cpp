// graze-voxel-peers: this library's ray traversals, those of papers and those of other libraries on
// one core: all occupied voxels of a sphere shell on each of the same random rays, and what each
// reports on random and on adversarial rays against the exact answer.
#include "contestants.hpp"
#include "judge.hpp"
#include "rays.hpp"
#include <cstdio>
#include <cstdlib>
#include <graze/rounding/environment.hpp>
#include <peers/library.hpp>
#include <string_view>
#include <utility>

namespace {

using namespace graze::bench;
namespace octree = graze::octree;
using rays = std::vector<octree::ray>;

struct options {
  std::size_t rays = 1'000'000, judged = 10'000, blocks = 20, level = 9;
  double slice = 0; ///< seconds of a block that one contestant gets; 0: all of the block
  std::string only;
  bool json = false;
};

struct timing {
  std::vector<double> rates; ///< rays a second, one a block
  std::size_t rays = 0, visited = 0;
};

/// Blocks of rays, each by all contestants in turn, so that a slow second is everybody's. One that
/// does not come to a block's end within its slice is timed on the first rays of it. A block ahead
/// warms up.
std::vector<timing> time(const std::vector<contestant>& all, const rays& r,
                         const options& settings) {
  constexpr std::size_t chunk = 256; // its voxels are overwritten by the next
  const std::size_t size = (r.size() + settings.blocks - 1) / settings.blocks;
  std::vector<timing> timings(all.size());
  reported found;
  for (std::size_t block = 0; block <= settings.blocks; ++block) {
    const std::size_t from = (block == 0 ? 0 : block - 1) * size;
    const std::size_t to = std::min(from + size, r.size());
    for (std::size_t c = 0; from < to && c < all.size(); ++c) {
      timing t;
      const double start = cpu_seconds();
      double seconds = 0;
      for (std::size_t at = from; at < to && (settings.slice == 0 || seconds < settings.slice);) {
        const std::size_t count = std::min(settings.slice == 0 || at != from ? chunk : 16, to - at);
        found.clear();
        all[c].trace({r.data() + at, count}, found);
        at += count;
        t.rays += count;
        t.visited += found.octants.size();
        seconds = cpu_seconds() - start;
      }
      if (block == 0)
        continue;
      timings[c].rates.push_back(static_cast<double>(t.rays) / seconds);
      timings[c].rays += t.rays;
      timings[c].visited += t.visited;
    }
  }
  return timings;
}

struct judged {
  const char* kind;
  std::vector<verdict> verdicts; ///< each contestant
};

judged judge(const std::vector<contestant>& all, const exact_octants& exact, const rays& some,
             const char* kind) {
  judged result{kind, std::vector<verdict>(all.size())};
  reported found;
  for (const octree::ray& r : some) {
    const std::vector<touched_octant> truth = exact.touched(r);
    for (std::size_t i = 0; i < all.size(); ++i) {
      found.clear();
      all[i].trace({&r, 1}, found);
      result.verdicts[i].add(truth, found.octants);
    }
  }
  return result;
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x.empty() ? 0 : x[x.size() / 2];
}

void print_table(const std::vector<contestant>& all, const std::vector<timing>& timings,
                 const std::vector<judged>& verdicts) {
  std::printf("%-32s %9s %12s %12s %12s %13s\n", "traversal", "build s", "Mrays/s", "slowest",
              "fastest", "voxels/ray");
  for (std::size_t c = 0; c < all.size(); ++c) {
    const timing& t = timings[c];
    const auto [low, high] = std::minmax_element(t.rates.begin(), t.rates.end());
    std::printf("%-32s %9.2f %12.4f %12.4f %12.4f %13.4f\n", all[c].name.c_str(),
                all[c].build_seconds, median(t.rates) * 1e-6, *low * 1e-6, *high * 1e-6,
                static_cast<double>(t.visited) / static_cast<double>(t.rays));
  }
  for (const judged& j : verdicts) {
    std::printf("\n%s: %zu rays touch %zu voxels, cross %zu\n", j.kind, j.verdicts[0].rays,
                j.verdicts[0].touched, j.verdicts[0].crossed);
    std::printf("%-32s %12s %12s %12s %12s %12s\n", "traversal", "missed", "gaps", "rays w. gap",
                "spurious", "doubles");
    for (std::size_t c = 0; c < all.size(); ++c) {
      const verdict& v = j.verdicts[c];
      std::printf("%-32s %12zu %12zu %12zu %12zu %12zu\n", all[c].name.c_str(), v.missed, v.gaps,
                  v.bad_rays, v.spurious, v.doubles);
    }
  }
  std::puts("\nmissed: the ray touches the closed voxel, not reported. gaps: those of them whose\n"
            "interior it meets, wrong in every convention. spurious: reported, not touched.");
}

/// The rays and octants on the first line, and which traversals are only judged; then a line a
/// traversal.
void print_json(const std::vector<contestant>& all, const std::vector<timing>& timings,
                const std::vector<judged>& verdicts, const occupied_octants& octants,
                const options& settings) {
  std::printf("{\"scene\": \"sphere shell\", \"level\": %d, \"voxels\": %zu, \"rays\": %zu, "
              "\"blocks\": %zu, \"slice_seconds\": %g, \"missing\": \"%s\", \"untimed\": {",
              octants.level, octants.indices.size(), settings.rays, settings.blocks, settings.slice,
              GRAZE_PEERS_MISSING);
  const char* between = "";
  for (const graze::peers::library& library : graze::peers::libraries())
    for (const graze::peers::variant& v : library.variants)
      if (v.in_benchmarks == graze::peers::timed::no)
        std::printf("%s\"%s\": \"%s\"", std::exchange(between, ", "), v.name, v.title);
  std::puts("}}");
  for (std::size_t c = 0; c < all.size(); ++c) {
    const timing& t = timings[c];
    std::printf("{\"name\": \"%s\", \"kind\": \"%s\", \"traversal\": \"%s\", \"path\": \"%s\", "
                "\"build_seconds\": %.3f, \"rays_timed\": %zu, \"voxels_a_ray\": %.5f, "
                "\"rays_a_second\": [",
                all[c].name.c_str(), all[c].kind.c_str(), all[c].traversal.c_str(),
                all[c].path.c_str(), all[c].build_seconds, t.rays,
                static_cast<double>(t.visited) / static_cast<double>(t.rays));
    for (std::size_t k = 0; k < t.rates.size(); ++k)
      std::printf("%s%.0f", k == 0 ? "" : ", ", t.rates[k]);
    std::printf("], \"judged\": {");
    for (const judged& j : verdicts) {
      const verdict& v = j.verdicts[c];
      std::printf("%s\"%s\": {\"rays\": %zu, \"touched\": %zu, \"crossed\": %zu, \"missed\": %zu, "
                  "\"gaps\": %zu, \"rays_with_gap\": %zu, \"spurious\": %zu, \"doubles\": %zu}",
                  &j == verdicts.data() ? "" : ", ", j.kind, v.rays, v.touched, v.crossed, v.missed,
                  v.gaps, v.bad_rays, v.spurious, v.doubles);
    }
    std::puts("}}");
  }
}

const char* const usage =
    "usage: graze-voxel-peers [--rays=N] [--blocks=N] [--slice=SECONDS] [--judged=N] "
    "[--level=1..11]\n"
    "                         [--only=TEXT] [--json]\n"
    "  --rays    random rays that are timed (1000000)\n"
    "  --blocks  parts of them, each by all traversals in turn (20)\n"
    "  --slice   what a traversal may take for a part; then it is timed on the first rays (no "
    "limit)\n"
    "  --judged  rays of each kind that are judged exactly (10000)\n"
    "  --level   of the octree (9)\n"
    "  --only    those with TEXT in their name, their path or what graze-fuzz calls them\n";

bool read(std::string_view argument, options& o) {
  const auto number = [&](std::string_view name, auto& x) {
    if (!argument.starts_with(name))
      return false;
    char* end = nullptr;
    const char* const text = argument.data() + name.size(); // of argv: it ends with 0
    const double value = std::strtod(text, &end);
    x = static_cast<std::remove_reference_t<decltype(x)>>(value);
    return end != text && *end == '\0' && value >= 0 && value <= 1e9;
  };
  if (argument.starts_with("--only=")) {
    o.only = argument.substr(7);
    return true;
  }
  if (argument == "--json")
    return o.json = true;
  return number("--rays=", o.rays) || number("--blocks=", o.blocks) ||
         number("--slice=", o.slice) || number("--judged=", o.judged) ||
         number("--level=", o.level);
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-voxel-peers"))
    return 2;
  options settings;
  for (int i = 1; i < argc; ++i)
    if (!read(argv[i], settings))
      return std::fputs(usage, stderr), 2;
  if (settings.rays == 0 || settings.blocks == 0 || settings.level < 1 || settings.level > 11)
    return std::fputs(usage, stderr), 2;
  const occupied_octants octants = sphere_shell(static_cast<int>(settings.level));
  const std::vector<contestant> all = contestants(octants, settings.only);
  if (all.empty()) {
    std::fprintf(stderr, "graze-voxel-peers: no traversal has \"%s\" in its name\n",
                 settings.only.c_str());
    return 2;
  }
  if (!settings.json)
    std::printf("sphere shell, level %zu: %zu voxels; %zu random rays, one core; missing:%s\n\n",
                settings.level, octants.indices.size(), settings.rays, GRAZE_PEERS_MISSING);
  const std::vector<timing> timings = time(all, random_rays(settings.rays, 1), settings);
  std::vector<judged> verdicts;
  if (settings.judged != 0) {
    const exact_octants exact(octants);
    const auto adversarial = [&](precision p, std::uint64_t seed) {
      return adversarial_rays(octants, p, settings.judged, seed);
    };
    verdicts.push_back(judge(all, exact, random_rays(settings.judged, 2), "random"));
    verdicts.push_back(judge(all, exact, adversarial(precision::single, 3), "adversarial float"));
    verdicts.push_back(judge(all, exact, adversarial(precision::twice, 4), "adversarial double"));
  }
  if (settings.json)
    print_json(all, timings, verdicts, octants, settings);
  else
    print_table(all, timings, verdicts);
  return 0;
}
