#pragma once
/// What a C++ program needs to be asked by graze-fuzz, in its plain form (docs/adapters.md): a
/// request, an answer, and the loop that reads one and writes the other. C++20 and nothing else;
/// copy it beside a traversal of your own. Ray against box:
///
///   int main() {
///     return adapter::serve({.cells = "boxes"}, [](const adapter::request& r, adapter::answer& a) {
///       for (const adapter::cell& box : r.cells())
///         if (my_test(r.origin, r.direction, box.lo, box.hi))
///           a.visit(box);
///     });
///   }
///
/// and a first hit:
///
///     return adapter::serve({.promise = "first", .cells = "boxes"}, [](const auto& r, auto& a) {
///       const my_tree tree(r.cells());
///       if (const auto hit = tree.first_hit(r.origin, r.direction))
///         a.first(hit->box, hit->t);
///     });
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace adapter {

using vec3 = std::array<double, 3>;
/// A voxel by its place in the whole grid; a box by its place in the list, in [0].
using index3 = std::array<std::uint64_t, 3>;

/// What the traversal says first: what it is judged by, and what it is to be asked.
struct hello {
  const char* promise = "crossed"; ///< or owned, touched, exactly-owned, exactly-touched; first,
                                   ///< first-touched; any; count
  const char* cells = "cube";      ///< or grid, boxes
  bool segments = false;           ///< instead of rays
  bool as_float = false;           ///< rays and boxes are rounded to float before they are sent
  double tolerance = -1;           ///< of t and distance, in ulps; negative: as graze-fuzz has it
};

/// An occupied cell: its place, and its box (the nearest doubles, where a grid's planes are none).
struct cell {
  index3 index;
  vec3 lo, hi;
};

/// The float next to x, in a double. Not inlined: where gcc 12 vectorises two of them at -O3, it
/// drops both conversions.
[[gnu::noinline]] inline double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}
inline vec3 to_float(const vec3& v) { return {to_float(v[0]), to_float(v[1]), to_float(v[2])}; }

/// A ray, or a segment, and the cells: occupied voxels, `extent` (1 to 4) an axis from `base` on, all
/// of them; or boxes.
struct request {
  std::uint64_t id = 0;
  int level = 0; ///< of a cube: the root has 2^level voxels an axis
  index3 base{}, extent{};
  vec3 origin{}, direction{}; ///< {origin + t direction : t >= 0}, any finite doubles
  vec3 end{};                 ///< of a segment, instead of the direction
  vec3 lo{};                  ///< a cube's lowest corner
  double size = 0;            ///< and its edge
  std::string planes;         ///< of a grid, the rule of its planes: exact, rounded, ..., given
  vec3 from{}, spacing{};     ///< of a grid whose planes are not given, and
  index3 count{};             ///< its voxels an axis
  std::array<std::vector<double>, 3> given; ///< of one whose planes are
  std::vector<cell> boxes;
  std::vector<double> echo; ///< to be given back; serve() does

  [[nodiscard]] double voxel_size() const { return std::ldexp(size, -level); }
  /// Plane k of a grid; the nearest double, where the rule is "exact".
  [[nodiscard]] double plane(unsigned axis, std::uint64_t k) const {
    const double o = from[axis], s = spacing[axis], n = static_cast<double>(k);
    if (planes == "given")
      return given[axis][std::min<std::size_t>(k, given[axis].size() - 1)];
    if (planes == "added") {
      double p = o;
      for (std::uint64_t i = 0; i < k; ++i)
        p += s;
      return p;
    }
    if (planes == "float") {
      const double product = to_float(to_float(n) * to_float(s));
      return to_float(to_float(o) + product); // rounded by double first, which changes nothing
    }
    if (planes == "multiplied") {
      const volatile double product = n * s; // no fused operation
      return o + product;
    }
    return std::fma(n, s, o);
  }
  /// A voxel's lowest (side 0) or highest (side 1) corner.
  [[nodiscard]] vec3 corner(const index3& voxel, unsigned side) const {
    vec3 c{};
    for (unsigned a = 0; a < 3; ++a)
      c[a] = planes.empty() ? lo[a] + static_cast<double>(voxel[a] + side) * voxel_size()
                            : plane(a, voxel[a] + side);
    return c;
  }
  [[nodiscard]] std::vector<index3> voxels() const {
    std::vector<index3> all;
    for (std::uint64_t z = 0; z < extent[2]; ++z)
      for (std::uint64_t y = 0; y < extent[1]; ++y)
        for (std::uint64_t x = 0; x < extent[0]; ++x)
          all.push_back({base[0] + x, base[1] + y, base[2] + z});
    return all;
  }
  /// The boxes, or those of the occupied voxels.
  [[nodiscard]] std::vector<cell> cells() const {
    std::vector<cell> all = boxes;
    for (const index3& v : voxels())
      all.push_back({v, corner(v, 0), corner(v, 1)});
    return all;
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
  explicit answer(const hello& h, const request& r)
      : promise_(h.promise), of_boxes_(!r.boxes.empty()) {}

  void visit(const index3& place) {
    for (unsigned a = 0; a < (of_boxes_ ? 1u : 3u); ++a)
      text_ += std::to_string(place[a]) += ' ';
  }
  /// Of a cell; a template, so that visit({x, y, z}) is the one above.
  template <class Cell> auto visit(const Cell& c) -> decltype(void(c.lo)) { visit(c.index); }
  /// The first cell, where its entry is known in the ray's parameter.
  void first(const cell& c) { visit(c); }
  void first(const cell& c, double t) { visit(c), number(more_, "t", t); }
  /// Of the first cell: its entry as a length, and the face that is entered: "-x", "+x", ...; "none",
  /// where the origin is inside.
  void distance(double d) { number(more_, "distance", d); }
  void face(const char* f) { (more_ += "face ") += f, more_ += ' '; }
  /// For the promises any and count.
  void hit(bool h) { text_ = h ? "true " : "false "; }
  void count(std::uint64_t n) { text_ = std::to_string(n) + " "; }
  /// The ray that the traversal really worked on, where it is another than the request's; of a segment
  /// its two ends.
  void received(const vec3& origin, const vec3& direction_or_end) {
    received_ = "received ";
    for (const vec3& v : {origin, direction_or_end})
      for (const double x : v)
        number(received_, nullptr, x);
  }
  /// The traversal does not take this ray.
  void skip() { skipped_ = true; }

  [[nodiscard]] std::string line(const std::vector<double>& echo = {}) const {
    if (skipped_)
      return "skip\n";
    std::string text = text_ + more_ + received_;
    if (text_.empty() && std::strcmp(promise_, "any") == 0)
      text = "false " + text;
    if (text_.empty() && std::strcmp(promise_, "count") == 0)
      text = "0 " + text;
    if (!echo.empty())
      text += "echo ";
    for (const double x : echo)
      number(text, nullptr, x);
    return text + "\n";
  }

private:
  static void number(std::string& text, const char* name, double x) {
    char digits[48];
    std::snprintf(digits, sizeof digits, "%a ", x);
    if (name != nullptr)
      (text += name) += ' ';
    text += digits;
  }

  const char* promise_;
  bool of_boxes_, skipped_ = false;
  std::string text_, more_, received_;
};

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

/// Takes the words of a line.
class words {
public:
  explicit words(const std::string& line) : at_(line.c_str()) {}
  [[nodiscard]] bool good() const { return good_; }
  bool word(const char* text) {
    const std::size_t length = std::strlen(text);
    if (std::strncmp(at_, text, length) != 0 || (at_[length] != ' ' && at_[length] != '\0'))
      return false;
    at_ += length + (at_[length] == ' ' ? 1 : 0);
    return true;
  }
  std::string word() {
    const char* end = at_ + std::strcspn(at_, " ");
    std::string text(at_, end);
    at_ = *end == ' ' ? end + 1 : end;
    return text;
  }
  void whole(std::uint64_t& x) {
    char* end = nullptr;
    x = std::strtoull(at_, &end, 10);
    went_to(end);
  }
  void whole(index3& v) { whole(v[0]), whole(v[1]), whole(v[2]); }
  void real(double& x) {
    char* end = nullptr;
    x = std::strtod(at_, &end);
    went_to(end);
  }
  void real(vec3& v) { real(v[0]), real(v[1]), real(v[2]); }

private:
  void went_to(const char* end) {
    good_ = good_ && end != at_;
    at_ = *end == ' ' ? end + 1 : end;
  }
  const char* at_;
  bool good_ = true;
};

inline bool read(const std::string& line, const hello& h, request& r) {
  r = {};
  words from(line);
  from.whole(r.id);
  vec3& second = h.segments ? r.end : r.direction;
  if (from.word("boxes")) {
    std::uint64_t n = 0;
    from.real(r.origin), from.real(second), from.whole(n);
    for (std::uint64_t i = 0; i < n && from.good(); ++i) {
      r.boxes.push_back({{i, 0, 0}, {}, {}});
      from.real(r.boxes.back().lo), from.real(r.boxes.back().hi);
    }
  } else if (from.word("grid")) {
    r.planes = from.word();
    from.whole(r.base), from.whole(r.extent), from.real(r.origin), from.real(second);
    if (r.planes == "given") {
      index3 sizes{};
      from.whole(sizes);
      for (unsigned a = 0; a < 3; ++a) {
        r.count[a] = std::max<std::uint64_t>(sizes[a], 2) - 1;
        for (std::uint64_t i = 0; i < sizes[a] && from.good(); ++i)
          from.real(r.given[a].emplace_back());
      }
    } else {
      from.real(r.from), from.real(r.spacing), from.whole(r.count);
    }
  } else {
    std::uint64_t level = 0;
    from.whole(level), from.whole(r.base), from.whole(r.extent);
    r.level = static_cast<int>(level);
    from.real(r.origin), from.real(second), from.real(r.lo), from.real(r.size);
  }
  if (from.word("echo")) {
    r.echo.resize(16);
    for (double& x : r.echo)
      from.real(x);
  }
  return from.good();
}

} // namespace detail

/// Answers until the input ends: traverse(request, answer) for each ray. Gives main()'s exit code.
template <class Traverse> int serve(const hello& h, Traverse&& traverse) {
  std::printf("promise %s cells %s segments %s float %s numbers hex echo true", h.promise, h.cells,
              h.segments ? "true" : "false", h.as_float ? "true" : "false");
  if (h.tolerance >= 0)
    std::printf(" tolerance %a", h.tolerance);
  std::printf("\n");
  std::fflush(stdout);
  std::string line;
  request r;
  for (unsigned long long left = 1; detail::read_line(line);) {
    if (std::sscanf(line.c_str(), "batch %llu", &left) == 1)
      continue; // so many requests follow
    if (!detail::read(line, h, r)) {
      std::fprintf(stderr, "no request in plain numbers: graze-fuzz run --plain --command ...\n");
      return 2;
    }
    answer a(h, r);
    traverse(r, a);
    std::fputs(a.line(r.echo).c_str(), stdout);
    if (--left == 0) {
      left = 1;
      std::fflush(stdout); // after each message: the next may wait for it
    }
  }
  return 0;
}
/// The same for cubes, judged by `promise`.
template <class Traverse> int serve(const char* promise, Traverse&& traverse) {
  return serve(hello{.promise = promise}, traverse);
}

} // namespace adapter
