#pragma once
/// What the modes of graze-traversal-bench share: options, the camera's rays, times.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <graze/octree/ray.hpp>
#include <string>
#include <time.h>
#include <vector>

namespace graze::bench {

struct options {
  int repetitions = 5;
  int size = 512;
  bool json = false;
  std::string scene; ///< of `surface`, `images`, `table` and `error`: only this one

  // of `images`
  std::vector<int> levels{10, 15, 20, 25, 30, 35, 40, 45, 50, 53};
  std::vector<std::string> methods; ///< all where empty
  double seconds = 2;               ///< a method that has taken longer at a level is not repeated
  std::string truth;                ///< a file of the scene's exact roots, read, or written

  [[nodiscard]] bool wants(const char* name) const { return scene.empty() || scene == name; }
  [[nodiscard]] bool wants_method(const std::string& name) const {
    return methods.empty() || std::find(methods.begin(), methods.end(), name) != methods.end();
  }
};

/// Of this thread's own time on the processor: on a quiet machine that is the wall clock's.
inline double seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The element that the given part of the others precede; part 0 is the least, 1 the greatest.
inline double quantile(std::vector<double> x, double part) {
  if (x.empty())
    return 0;
  std::sort(x.begin(), x.end());
  const auto last = static_cast<double>(x.size() - 1);
  return x[static_cast<std::size_t>(std::ceil(part * last))];
}
inline double median(const std::vector<double>& x) { return quantile(x, 0.5); }

/// Seconds: median and quartiles.
struct spread {
  double low, middle, high;
};
inline spread spread_of(const std::vector<double>& x) {
  return {quantile(x, 0.25), median(x), quantile(x, 0.75)};
}

/// The six scenes' camera (docs/definitions.md), without its framing: size x size rays.
inline std::vector<octree::ray> camera_rays(double scale, int size) {
  std::vector<octree::ray> rays;
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const double u = (i + 0.5) / size - 0.5, v = 0.5 - (j + 0.5) / size;
      rays.push_back(*octree::ray::make({3 * scale, 2 * scale, 6 * scale},
                                        {-3 + u * 3.578125 + v * -0.51171875, -2 + v * 3.8330078125,
                                         -6 + u * -1.7890625 + v * -1.0224609375}));
    }
  return rays;
}

struct contender {
  std::string name;
  std::function<void()> run;
  std::vector<double> times;
};

inline void measure(std::vector<contender>& all, int repetitions) {
  for (contender& c : all)
    c.run(); // warm
  for (int r = 0; r < repetitions; ++r)
    for (contender& c : all) {
      const double start = seconds();
      c.run();
      c.times.push_back(seconds() - start);
    }
}

/// The modes `images` and `table` (traversal_images.cpp).
int images(const options& settings);
int table(const options& settings);

} // namespace graze::bench
