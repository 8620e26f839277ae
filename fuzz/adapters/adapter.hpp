#pragma once
/// What a C++ program needs to be asked by graze-fuzz, in its plain form (docs/adapters.md): a
/// request, an answer, and the loop that reads one and writes the other. C++20 and nothing else;
/// copy it beside a traversal of your own:
///
///   int main() {
///     return adapter::serve("crossed", [](const adapter::request& r, adapter::answer& a) {
///       for (const adapter::index3& voxel : r.voxels())
///         if (my_test(r.origin, r.direction, r.corner(voxel, 0), r.corner(voxel, 1)))
///           a.visit(voxel);
///     });
///   }
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace adapter {

using vec3 = std::array<double, 3>;
/// A voxel by its place in the whole grid, 0 to 2^level - 1 an axis.
using index3 = std::array<std::uint64_t, 3>;

/// A ray, and the occupied voxels: `extent` (1 to 4) an axis from `base` on, all of them.
struct request {
  std::uint64_t id = 0;
  int level = 0; ///< the root has 2^level voxels an axis
  index3 base{}, extent{};
  vec3 origin{}, direction{}; ///< {origin + t direction : t >= 0}, any finite doubles
  vec3 lo{};                  ///< the root's lowest corner
  double size = 0;            ///< and its edge

  [[nodiscard]] double voxel_size() const { return std::ldexp(size, -level); }
  [[nodiscard]] std::vector<index3> voxels() const {
    std::vector<index3> all;
    for (std::uint64_t z = 0; z < extent[2]; ++z)
      for (std::uint64_t y = 0; y < extent[1]; ++y)
        for (std::uint64_t x = 0; x < extent[0]; ++x)
          all.push_back({base[0] + x, base[1] + y, base[2] + z});
    return all;
  }
  /// A voxel's lowest (side 0) or highest (side 1) corner.
  [[nodiscard]] vec3 corner(const index3& voxel, unsigned side) const {
    vec3 c{};
    for (unsigned a = 0; a < 3; ++a)
      c[a] = lo[a] + static_cast<double>(voxel[a] + side) * voxel_size();
    return c;
  }
  /// For a library whose cells have edge 1 and are counted from coordinate 0: voxel v is cell
  /// first + v, a point p is p / voxel_size(), and neither is rounded. False where that does not
  /// hold: an edge that is no power of two, a root between cells or further than 2^15 of them away,
  /// levels beyond 15.
  bool in_cells(std::array<int, 3>& first) const {
    int exponent = 0;
    if (level > 15 || std::frexp(size, &exponent) != 0.5)
      return false;
    for (unsigned a = 0; a < 3; ++a) {
      const double at = lo[a] / voxel_size();
      if (!(std::fabs(at) <= 0x1p15) || at != std::floor(at))
        return false;
      first[a] = static_cast<int>(at);
    }
    return true;
  }
};

/// What the traversal did.
class answer {
public:
  void visit(const index3& voxel) {
    for (const std::uint64_t i : voxel)
      text_ += std::to_string(i) += ' ';
  }
  /// The ray that the traversal really worked on, where it is another than the request's.
  void received(const vec3& origin, const vec3& direction) {
    received_ = "received";
    for (const vec3& v : {origin, direction})
      for (const double x : v) {
        char number[40];
        std::snprintf(number, sizeof number, " %a", x);
        received_ += number;
      }
  }
  /// The traversal does not take this ray.
  void skip() { skipped_ = true; }

  [[nodiscard]] std::string line() const { return skipped_ ? "skip\n" : text_ + received_ + "\n"; }

private:
  std::string text_, received_;
  bool skipped_ = false;
};

/// The float next to x, in a double. Not inlined: where gcc 12 vectorises two of them at -O3, it
/// drops both conversions.
[[gnu::noinline]] inline double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}
inline vec3 to_float(const vec3& v) { return {to_float(v[0]), to_float(v[1]), to_float(v[2])}; }

inline bool is_finite(const vec3& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// v times a power of two, so that its largest component is in [1, 2): the same direction (unless
/// a component underflows: tell `received`), for a traversal that expects a length of about 1.
inline vec3 scaled(const vec3& v) {
  const double largest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  const int exponent = std::ilogb(largest);
  return {std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), std::ldexp(v[2], -exponent)};
}

namespace detail {

/// A line of standard input; false at its end.
inline bool read_line(std::string& line) {
  line.clear();
  for (int c = std::getchar(); c != EOF; c = std::getchar()) {
    if (c == '\n')
      return true;
    line += static_cast<char>(c);
  }
  return false;
}

inline bool read(const std::string& line, request& r) {
  const char* at = line.c_str();
  bool good = true;
  const auto number = [&](auto& x, auto parse) {
    char* end = nullptr;
    x = static_cast<std::remove_reference_t<decltype(x)>>(parse(at, &end));
    good = good && end != at;
    at = end;
  };
  const auto whole = [](const char* text, char** end) { return std::strtoull(text, end, 10); };
  const auto real = [](const char* text, char** end) { return std::strtod(text, end); };
  number(r.id, whole);
  number(r.level, whole);
  for (index3* v : {&r.base, &r.extent})
    for (std::uint64_t& x : *v)
      number(x, whole);
  for (vec3* v : {&r.origin, &r.direction, &r.lo})
    for (double& x : *v)
      number(x, real);
  number(r.size, real);
  return good;
}

} // namespace detail

/// Answers until the input ends: traverse(request, answer) for each ray. `promise` is what it is
/// judged by: crossed, owned, touched, exactly-owned or exactly-touched. Gives main()'s exit code.
template <class Traverse> int serve(const char* promise, Traverse&& traverse) {
  std::printf("promise %s\n", promise);
  std::string line;
  request r;
  while (detail::read_line(line)) {
    if (!detail::read(line, r)) {
      std::fprintf(stderr, "no request in plain numbers: graze-fuzz run --plain --command ...\n");
      return 2;
    }
    answer a;
    traverse(r, a);
    std::fputs(a.line().c_str(), stdout);
    std::fflush(stdout); // after each line: the next request may wait for it
  }
  return 0;
}

} // namespace adapter
