// shell_bench: all occupied voxels on each of 10^6 random rays through a sphere shell voxelized at
// level 9, one core; this library's traversals and its peers in one run, repetitions interleaved.
#include "peer.hpp"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <graze/batch.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/octree/voxelizer.hpp>
#include <random>
#include <string_view>

namespace {

using namespace graze;
using namespace graze::octree;
using namespace graze::bench::shell;

/// |p - (1/2, 1/2, 1/2)| = 2/5.
struct shell {
  static constexpr bool natural_extension_suffices = true;
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    using c = constants<N>;
    return sqr(x - c::exact(0.5)) + sqr(y - c::exact(0.5)) + sqr(z - c::exact(0.5)) -
           c::template rational<4, 25>();
  }
};

/// Both ends on the sphere of radius 1/2 about the shell's centre, the greatest in the root.
std::vector<ray> random_rays(std::size_t count) {
  std::mt19937_64 random(20050101);
  const auto point = [&] {
    for (;;) {
      vec3 p;
      for (double& x : p)
        x = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
      const double n = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      if (n > 1 || n < 0.1)
        continue;
      for (double& x : p)
        x = 0.5 + 0.5 * x / n;
      return p;
    }
  };
  std::vector<ray> rays;
  rays.reserve(count);
  while (rays.size() < count) {
    const vec3 p = point(), q = point();
    if (const auto r = ray::make(p, {q[0] - p[0], q[1] - p[1], q[2] - p[2]}))
      rays.push_back(*r);
  }
  return rays;
}

peer ours(const scene& s, std::string name, batch::path path, convention what, exactness how) {
  return {std::move(name),
          [&s, path, what, how](std::size_t first, std::size_t last, findings& out) {
            batch::force_path(path);
            const std::size_t base = out.counts.size();
            out.counts.resize(base + (last - first));
            visit_voxels(s.set, std::span(s.rays).subspan(first, last - first), what, how, {},
                         [&](std::size_t i, std::span<const voxel> found) {
                           for (const voxel& v : found)
                             out.voxels.push_back(v.packed);
                           out.counts[base + i] += static_cast<std::uint32_t>(found.size());
                         });
          }};
}

std::uint64_t missed(const findings& is, const findings& said, std::uint64_t& spurious) {
  std::uint64_t misses = 0;
  std::size_t i = 0, j = 0;
  std::vector<std::uint64_t> a, b;
  for (std::size_t r = 0; r < is.counts.size(); ++r) {
    a.assign(is.voxels.begin() + i, is.voxels.begin() + i + is.counts[r]);
    b.assign(said.voxels.begin() + j, said.voxels.begin() + j + said.counts[r]);
    i += is.counts[r];
    j += said.counts[r];
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    std::size_t both = 0;
    for (std::size_t x = 0, y = 0; x < a.size() && y < b.size();)
      if (a[x] == b[y])
        ++both, ++x, ++y;
      else
        a[x] < b[y] ? ++x : ++y;
    misses += a.size() - both;
    spurious += b.size() - both;
  }
  return misses;
}

/// Of the thread: what else runs on the machine counts little.
double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

} // namespace

int main(int argc, char** argv) {
  bool json = false, libraries = true;
  std::size_t count = 1'000'000;
  int repetitions = 9;
  for (int i = 1; i < argc; ++i) {
    const std::string_view a = argv[i];
    if (a == "--json")
      json = true;
    else if (a == "--no-libraries")
      libraries = false;
    else if (a.starts_with("--rays="))
      count = static_cast<std::size_t>(std::max(1l, std::atol(argv[i] + 7)));
    else if (a.starts_with("--repetitions="))
      repetitions = std::max(1, std::atoi(argv[i] + 14));
    else {
      std::fprintf(stderr,
                   "usage: shell_bench [--rays=N] [--repetitions=N] [--no-libraries] [--json]\n");
      return 2;
    }
  }
  const root_cube root = *root_cube::make({{0, 0, 0}, 1}, 9);
  auto tree = voxelize(shell{}, root, box{{0, 0, 0}, {1, 1, 1}});
  auto set = voxel_set::from_tree(root, *tree);
  const scene s{root, *std::move(tree), *std::move(set), random_rays(count)};

  std::vector<peer> peers;
  for (const batch::path p : {batch::path::avx512, batch::path::avx2, batch::path::baseline})
    if (!batch::refusal(p)) {
      const std::string suffix = std::string(" ") + batch::name(p);
      peers.push_back(
          ours(s, "graze exact closed" + suffix, p, convention::closed, exactness::exact));
      peers.push_back(
          ours(s, "graze exact owned" + suffix, p, convention::owned, exactness::exact));
      peers.push_back(
          ours(s, "graze conservative" + suffix, p, convention::closed, exactness::conservative));
    }
#ifdef GRAZE_BENCH_EMBREE
  peers.push_back(embree_peer(s));
#endif
  peers.push_back(gargantini_peer(s));
  if (libraries)
    for (peer& p : library_peers(s))
      peers.push_back(std::move(p));

  findings truth, said;
  peers.front().trace(0, count, truth);
  struct row {
    double rate;
    std::uint64_t visits, misses, spurious;
  };
  std::vector<row> rows;
  for (const peer& p : peers) {
    row r{0, 0, 0, 0};
    said.clear();
    p.trace(0, count, said);
    r.visits = said.voxels.size();
    r.misses = missed(truth, said, r.spurious);
    rows.push_back(r);
  }
  // a chunk's voxels are overwritten by the next
  std::vector<std::vector<double>> seconds(peers.size());
  constexpr std::size_t chunk = 10'000;
  for (int k = 0; k < repetitions; ++k)
    for (std::size_t p = 0; p < peers.size(); ++p) {
      const double begin = cpu_seconds();
      for (std::size_t i = 0; i < count; i += chunk) {
        said.clear();
        peers[p].trace(i, std::min(count, i + chunk), said);
      }
      seconds[p].push_back(cpu_seconds() - begin);
    }
  std::uint64_t opened = 0;
  {
    batch::unforce_path();
    std::vector<std::uint32_t> counts(count);
    opened = count_voxels(s.set, s.rays, convention::closed, exactness::exact, counts);
  }
  double embree = 0;
  for (std::size_t p = 0; p < peers.size(); ++p) {
    rows[p].rate = static_cast<double>(count) / median(seconds[p]);
    if (peers[p].name == "embree3")
      embree = rows[p].rate;
  }
  if (json) {
    std::printf("{\"voxels\": %zu, \"rays\": %zu, \"repetitions\": %d, \"missing\": \"%s\", "
                "\"nodes_opened_a_ray\": %.3f, \"set_bytes\": %zu, \"results\": [",
                s.set.voxel_count(), count, repetitions, GRAZE_BENCH_MISSING,
                static_cast<double>(opened) / static_cast<double>(count), s.set.bytes());
    for (std::size_t p = 0; p < peers.size(); ++p)
      std::printf("%s{\"name\": \"%s\", \"rays_a_second\": %.0f, \"visits_a_ray\": %.5f, "
                  "\"misses\": %llu, \"spurious\": %llu}",
                  p == 0 ? "" : ", ", peers[p].name.c_str(), rows[p].rate,
                  static_cast<double>(rows[p].visits) / static_cast<double>(count),
                  static_cast<unsigned long long>(rows[p].misses),
                  static_cast<unsigned long long>(rows[p].spurious));
    std::printf("]}\n");
    return 0;
  }
  std::printf("%zu voxels (%zu nodes, %zu bytes), %zu rays, median of %d; peers missing:%s\n",
              s.set.voxel_count(), s.set.node_count(), s.set.bytes(), count, repetitions,
              GRAZE_BENCH_MISSING);
  std::printf("nodes opened a ray: %.2f (exact, closed)\n",
              static_cast<double>(opened) / static_cast<double>(count));
  std::printf("%-32s %10s %8s %12s %8s %9s\n", "", "M rays/s", "/embree", "visits/ray", "misses",
              "spurious");
  for (std::size_t p = 0; p < peers.size(); ++p)
    std::printf("%-32s %10.3f %8.2f %12.4f %8llu %9llu\n", peers[p].name.c_str(),
                rows[p].rate * 1e-6, embree > 0 ? rows[p].rate / embree : 0.0,
                static_cast<double>(rows[p].visits) / static_cast<double>(count),
                static_cast<unsigned long long>(rows[p].misses),
                static_cast<unsigned long long>(rows[p].spurious));
}
