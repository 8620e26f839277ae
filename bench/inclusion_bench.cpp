// graze-inclusion-bench: what the form of a surface's inclusion function costs. Ray casting as in
// the paper's Table 1 (octree to level 9, NL 30, scalar code, backend upward), the forms of a scene
// in turn. One core; medians of the thread's own processor time.
#include "traversal_bench.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <graze/functions/trigonometric.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/rounding/environment.hpp>
#include <memory>
#include <string>
#include <vector>

namespace {
using namespace graze;
using namespace graze::octree;
using bench::camera_rays, bench::median, bench::seconds;

struct options : bench::options {
  int resolution = 30; ///< NL
};

/// F's natural extension and nothing else: to call it tight leaves out the mean value form.
template <class F> struct natural : F {
  static constexpr bool natural_extension_suffices = true;
};
/// F's natural extension and, where that does not exclude 0, its mean value form.
template <class F> struct with_mean_value : F {
  static constexpr bool natural_extension_suffices = false;
};

// The same functions, less well written.

/// x^4 and x^2 by products: each factor is taken for an independent variable.
struct tanglecube_products {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    const auto five = constants<N>::exact(5);
    return x * x * x * x - x * x * five + (y * y * y * y - y * y * five) +
           (z * z * z * z - z * z * five) + constants<N>::template rational<59, 5>();
  }
};
/// As printed: x^4 - 5 x^2, each power tight by itself.
struct tanglecube_powers {
  template <class N> static N part(const N& x) {
    const N square = sqr(x);
    return sqr(square) - square * constants<N>::exact(5);
  }
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return part(x) + part(y) + part(z) + constants<N>::template rational<59, 5>();
  }
};
/// x^2 (x^2 - 5)
struct tanglecube_factors {
  template <class N> static N part(const N& x) {
    const N square = sqr(x);
    return square * (square - constants<N>::exact(5));
  }
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return part(x) + part(y) + part(z) + constants<N>::template rational<59, 5>();
  }
};
/// x^4 - 2 x^2 + y^4 - 2 y^2 + z^4 - 2 z^2 + 2
struct quartdef_powers {
  template <class N> static N part(const N& x) {
    const N square = sqr(x);
    return sqr(square) - square * constants<N>::exact(2);
  }
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return part(x) + part(y) + part(z) + constants<N>::exact(2);
  }
};
/// x x x - x
struct holesrot_products {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return x * x * x - x + (y * y * y - y) + (z * z * z - z);
  }
};
/// x (x^2 - 1)
struct holesrot_factors {
  template <class N> static N part(const N& x) { return x * (sqr(x) - constants<N>::exact(1)); }
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return part(x) + part(y) + part(z);
  }
};
/// x^2 - 2 a x + y^2 - 2 b y + z^2 - 2 c z + (a^2 + b^2 + c^2 - r^2) of each sphere; the constants
/// are exact doubles.
struct spheres_powers {
  template <class N> static N part(const spheres::sphere& s, const N& x, const N& y, const N& z) {
    using c = constants<N>;
    const auto& [a, b, d] = s.centre;
    return sqr(x) - x * c::exact(2 * a) + (sqr(y) - y * c::exact(2 * b)) +
           (sqr(z) - z * c::exact(2 * d)) + c::exact(a * a + b * b + d * d - s.radius * s.radius);
  }
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    N least = part(spheres::parts[0], x, y, z);
    for (std::size_t i = 1; i < spheres::parts.size(); ++i)
      least = lesser(least, part(spheres::parts[i], x, y, z));
    return least;
  }
};
/// The paper's formula by the interval functions sin and atan2; derivatives as the asterisk's.
template <int M, int N> struct asterisk_sines : asterisk<M, N> {
  using asterisk<M, N>::operator();
  template <class Policies>
  boost::numeric::interval<double, Policies>
  operator()(const boost::numeric::interval<double, Policies>& x,
             const boost::numeric::interval<double, Policies>& y,
             const boost::numeric::interval<double, Policies>& z) const {
    using interval = boost::numeric::interval<double, Policies>;
    const interval square = sqr(x) + sqr(y), rho = graze::sqrt(square);
    return graze::sin(interval(double{M}) * graze::atan2(y, x)) *
               graze::sin(interval(double{N}) * graze::atan2(rho, z)) -
           graze::sqrt(square + sqr(z));
  }
};

/// A form of a scene's inclusion function.
struct form {
  std::string name;
  std::size_t octants = 0; ///< of the octree
  double voxelization = 0; ///< seconds
  std::function<traversal_counts(std::vector<surface_hit>&)> run;
  std::vector<double> times;
  std::vector<surface_hit> hits;
  traversal_counts counts;
};

template <class F>
form make_form(const char* name, const options& settings, const box& domain,
               const std::vector<ray>& rays) {
  const double start = seconds();
  auto octree = voxelize(F{}, domain, 9);
  form r;
  r.name = name;
  r.voxelization = seconds() - start;
  if (!octree)
    std::abort();
  r.octants = octree->node_count() + octree->leaf_count();
  const auto kept = std::make_shared<const sparse_octree>(std::move(*octree));
  const auto made = surface_traversal<F>::make(F{}, domain, *kept, settings.resolution);
  if (!made)
    std::abort();
  r.run = [t = *made, kept, &rays](std::vector<surface_hit>& hits) {
    traversal_counts counts;
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = t.first_hit(rays[i], &counts);
    return counts;
  };
  return r;
}

template <class F> struct named {
  const char* name;
};

/// The last form is the one in use.
template <class Surface, class... F>
void scene(const options& settings, const built_in_surface<Surface>& row, named<F>... forms) {
  const char* const name = row.name;
  if (!settings.wants(name))
    return;
  const box domain = row.domain();
  const std::vector<ray> rays = camera_rays(row.scale, settings.size);
  std::vector<form> all;
  (all.push_back(make_form<F>(forms.name, settings, domain, rays)), ...);
  for (int r = 0; r < settings.repetitions; ++r)
    for (form& f : all) {
      if (!f.times.empty() && f.times[0] > 5)
        continue;
      f.hits.resize(rays.size());
      const double start = seconds();
      f.counts = f.run(f.hits);
      f.times.push_back(seconds() - start);
    }
  const double in_use = median(all.back().times), count = static_cast<double>(rays.size());
  for (form& f : all) {
    int hits = 0, undecided = 0;
    for (const surface_hit& h : f.hits) {
      hits += h.outcome == verdict::hit;
      undecided += h.outcome == verdict::undecided;
    }
    const double t = median(f.times), opened = static_cast<double>(f.counts.cells_opened) / count;
    if (settings.json)
      std::printf("{\"scene\": \"%s\", \"form\": \"%s\", \"octants\": %zu, \"voxelize_seconds\": "
                  "%.4f, \"opened_per_ray\": %.2f, \"seconds\": %.4f, \"times\": %.3f, \"rays\": "
                  "%zu, \"hits\": %d, \"undecided\": %d}\n",
                  name, f.name.c_str(), f.octants, f.voxelization, opened, t, t / in_use,
                  rays.size(), hits, undecided);
    else
      std::printf("| %s | %s | %zu | %.3f | %.1f | %.3f | %.2f | %d | %d |\n", name, f.name.c_str(),
                  f.octants, f.voxelization, opened, t, t / in_use, hits, undecided);
  }
  std::fflush(stdout);
}

int complain(const char* why) {
  std::fprintf(stderr,
               "graze-inclusion-bench: %s\nusage: graze-inclusion-bench [--repetitions N] [--size "
               "PIXELS] [--levels NL] [--scene NAME] [--json]\n",
               why);
  return 2;
}
} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-inclusion-bench"))
    return 2;
  options settings;
  settings.repetitions = 3;
  settings.size = 256;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto number = [&](int& to, int least, int most) {
      to = i + 1 < argc ? std::atoi(argv[++i]) : 0;
      return to >= least && to <= most;
    };
    if (a == "--json")
      settings.json = true;
    else if (a == "--scene" && i + 1 < argc)
      settings.scene = argv[++i];
    else if ((a == "--repetitions" && number(settings.repetitions, 1, 1000)) ||
             (a == "--size" && number(settings.size, 1, 4096)) ||
             (a == "--levels" && number(settings.resolution, 9, 52)))
      continue;
    else
      return complain(("bad option " + a).c_str());
  }
  if (!settings.json)
    std::printf("| scene | form | octants to level 9 | voxelization, s | octants opened a ray | "
                "rays, s | times the form in use | hits | undecided |\n"
                "|---|---|---|---|---|---|---|---|---|\n");
  scene(settings, built_in<tanglecube>, //
        named<natural<tanglecube_products>>{"x x x x - 5 x x: natural"},
        named<with_mean_value<tanglecube_products>>{"x x x x - 5 x x: natural, mean value"},
        named<natural<tanglecube_powers>>{"x^4 - 5 x^2: natural"},
        named<with_mean_value<tanglecube_powers>>{"x^4 - 5 x^2: natural, mean value"},
        named<natural<tanglecube_factors>>{"x^2 (x^2 - 5): natural"},
        named<with_mean_value<tanglecube>>{"(x^2 - 5/2)^2: natural, mean value"},
        named<tanglecube>{"(x^2 - 5/2)^2: natural"});
  scene(settings, built_in<quartdef>, //
        named<natural<quartdef_powers>>{"x^4 - 2 x^2: natural"},
        named<with_mean_value<quartdef_powers>>{"x^4 - 2 x^2: natural, mean value"},
        named<with_mean_value<quartdef>>{"(x^2 - 1)^2: natural, mean value"},
        named<quartdef>{"(x^2 - 1)^2: natural"});
  scene(settings, built_in<holesrot>, //
        named<natural<holesrot_products>>{"x x x - x: natural"},
        named<with_mean_value<holesrot_products>>{"x x x - x: natural, mean value"},
        named<natural<holesrot_factors>>{"x (x^2 - 1): natural"},
        named<with_mean_value<holesrot_factors>>{"x (x^2 - 1): natural, mean value"},
        named<with_mean_value<holesrot>>{"monotone pieces, mean value"},
        named<holesrot>{"monotone pieces"});
  scene(settings, built_in<spheres>, //
        named<natural<spheres_powers>>{"x^2 - 2 a x: natural"},
        named<with_mean_value<spheres_powers>>{"x^2 - 2 a x: natural, mean value"},
        named<with_mean_value<spheres>>{"(x - a)^2: natural, mean value"},
        named<spheres>{"(x - a)^2: natural"});
  scene(
      settings, built_in<asterisk<3, 4>>, //
      named<natural<asterisk_sines<3, 4>>>{"sines: natural"},
      named<with_mean_value<asterisk<3, 4>>>{"monotone pieces of polynomials: natural, mean value"},
      named<asterisk<3, 4>>{"monotone pieces of polynomials: natural"});
  scene(settings, built_in<asterisk<9, 18>>, //
        named<natural<asterisk_sines<9, 18>>>{"sines: natural"},
        named<with_mean_value<asterisk<9, 18>>>{
            "monotone pieces of polynomials: natural, mean value"},
        named<asterisk<9, 18>>{"monotone pieces of polynomials: natural"});
  return 0;
}
