// graze-voxel-peers [RAYS [JUDGED [LEVEL]]]: traversals of others on one core: all occupied voxels
// of a sphere shell on each of 10^6 random rays, and what they report against the exact answer.
#include "peers/judge.hpp"
#include "peers/peers.hpp"
#include "peers/rays.hpp"
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

namespace {

using namespace graze::bench;
namespace octree = graze::octree;
using rays = std::vector<octree::ray>;
/// Of the thread: what else runs on the machine counts little.
double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// A peer behind one indirect call a block of rays, none a ray.
struct contestant {
  std::string name;
  double build_seconds = 0;
  std::function<std::size_t(const octree::ray*, std::size_t)> visit; ///< voxels reported
  std::function<void(const octree::ray&, std::vector<voxel_key>&)> occupied;
  std::vector<double> rates; ///< rays a second, a block each
  std::size_t visited = 0;
};

std::vector<contestant> contestants(const voxel_grid& grid) {
  std::vector<contestant> all;
  for_each_peer([&]<class Library>() {
    const double start = cpu_seconds();
    const auto p = std::make_shared<peer<Library>>(grid);
    contestant c;
    c.name = peer<Library>::name;
    c.build_seconds = (cpu_seconds() - start);
    c.visit = [p](const octree::ray* r, std::size_t count) {
      std::vector<voxel_key> found;
      std::size_t voxels = 0;
      for (std::size_t i = 0; i < count; ++i) {
        found.clear();
        p->occupied(r[i], found);
        voxels += found.size();
      }
      return voxels;
    };
    c.occupied = [p](const octree::ray& r, std::vector<voxel_key>& found) {
      p->occupied(r, found);
    };
    all.push_back(std::move(c));
  });
  return all;
}

/// Blocks of rays, each by all peers in turn, so that a slow second is everybody's.
void time(std::vector<contestant>& all, const rays& r) {
  constexpr std::size_t blocks = 20;
  const std::size_t size = (r.size() + blocks - 1) / blocks;
  for (std::size_t from = 0; from < r.size(); from += size) {
    const std::size_t count = std::min(size, r.size() - from);
    for (contestant& c : all) {
      const double start = cpu_seconds();
      c.visited += c.visit(r.data() + from, count);
      c.rates.push_back(static_cast<double>(count) / (cpu_seconds() - start));
    }
  }
  std::printf("%-10s %9s %12s %12s %12s %13s\n", "peer", "build s", "Mrays/s", "slowest", "fastest",
              "voxels/ray");
  for (contestant& c : all) {
    std::sort(c.rates.begin(), c.rates.end());
    std::printf("%-10s %9.2f %12.4f %12.4f %12.4f %13.4f\n", c.name.c_str(), c.build_seconds,
                c.rates[c.rates.size() / 2] * 1e-6, c.rates.front() * 1e-6, c.rates.back() * 1e-6,
                static_cast<double>(c.visited) / static_cast<double>(r.size()));
  }
}

void judge(std::vector<contestant>& all, const exact_voxels& exact, const rays& r,
           const char* kind) {
  std::vector<verdict> verdicts(all.size());
  std::vector<voxel_key> found;
  for (const octree::ray& one : r) {
    const std::vector<exact_voxels::voxel> truth = exact.on(one);
    for (std::size_t i = 0; i < all.size(); ++i) {
      found.clear();
      all[i].occupied(one, found);
      verdicts[i].add(truth, found);
    }
  }
  if (verdicts.empty())
    return;
  std::printf("\n%s: %zu rays touch %zu voxels, cross %zu\n", kind, verdicts[0].rays,
              verdicts[0].touched, verdicts[0].crossed);
  std::printf("%-10s %12s %12s %12s %12s %12s\n", "peer", "missed", "gaps", "rays w. gap",
              "spurious", "doubles");
  for (std::size_t i = 0; i < all.size(); ++i)
    std::printf("%-10s %12zu %12zu %12zu %12zu %12zu\n", all[i].name.c_str(), verdicts[i].missed,
                verdicts[i].gaps, verdicts[i].bad_rays, verdicts[i].spurious, verdicts[i].doubles);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, std::size_t otherwise) {
    return argc > i ? static_cast<std::size_t>(std::strtoull(argv[i], nullptr, 10)) : otherwise;
  };
  const std::size_t timed = argument(1, 1'000'000), judged = argument(2, 10'000);
  const std::size_t level = argument(3, 9);
  if (timed == 0 || level < 1 || level > 11) {
    std::fprintf(stderr, "usage: graze-voxel-peers [RAYS [JUDGED [LEVEL 1..11]]]\n");
    return 2;
  }
  const voxel_grid grid = sphere_shell(static_cast<int>(level));
  std::printf("sphere shell, level %zu: %zu voxels; %zu random rays, one core; missing:%s\n\n",
              level, grid.voxels.size(), timed, GRAZE_PEERS_MISSING);
  std::vector<contestant> all = contestants(grid);
  time(all, random_rays(timed, 1));
  const exact_voxels exact(grid);
  judge(all, exact, random_rays(judged, 2), "random, single precision");
  judge(all, exact, adversarial_rays(grid, precision::single, judged, 3),
        "adversarial, single precision");
  judge(all, exact, adversarial_rays(grid, precision::twice, judged, 4),
        "adversarial, double precision");
  std::puts("\nmissed: the ray touches the closed voxel, not reported. gaps: those of them whose\n"
            "interior it meets, wrong in every convention. spurious: reported, not touched.");
  return 0;
}
