#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <limits>
#include <peers/maps/voxel_map.hpp>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace graze::peers {

namespace {

/// A rule of planes by the names of replay lines, where it gives all of them.
struct spelled_planes {
  const char* rule = nullptr;
  vec3 origin{}, spacing{};
};

double by_rule(const std::string& rule, double origin, double spacing, std::size_t k) {
  const auto n = static_cast<double>(k);
  if (rule == "rounded")
    return std::fma(n, spacing, origin);
  const volatile double product = n * spacing;
  return origin + product;
}

spelled_planes spelled(const voxel_map& map) {
  for (const char* rule : {"rounded", "multiplied"}) {
    spelled_planes found{rule, {}, map.spacing};
    bool all = true;
    for (unsigned a = 0; a < 3 && all; ++a) {
      const std::vector<double>& planes = map.planes[a];
      found.origin[a] = planes[0];
      for (std::size_t k = 0; k < planes.size() && all; ++k)
        all = by_rule(rule, planes[0], map.spacing[a], k) == planes[k];
    }
    if (all)
      return found;
  }
  return {};
}

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "\"%a\"", x);
  return text;
}
template <class Numbers, class Text> std::string list(const Numbers& numbers, const Text& text) {
  std::string all = "[";
  for (const auto& n : numbers) {
    if (all.size() > 1)
      all += ',';
    all += text(n);
  }
  all += ']';
  return all;
}
template <class Numbers> std::string integers(const Numbers& numbers) {
  return list(numbers, [](auto n) { return std::to_string(n); });
}

std::string grid_text(const voxel_map& map) {
  if (const spelled_planes by = spelled(map); by.rule != nullptr) {
    std::array<std::size_t, 3> count{};
    for (unsigned a = 0; a < 3; ++a)
      count[a] = map.planes[a].size() - 1;
    return "{\"origin\":" + list(by.origin, hex) + ",\"spacing\":" + list(by.spacing, hex) +
           ",\"count\":" + integers(count) + ",\"planes\":\"" + by.rule + "\"}";
  }
  return "{\"planes\":" +
         list(map.planes, [](const std::vector<double>& p) { return list(p, hex); }) + "}";
}

/// For each plane of an axis, whether its double lies in another voxel by the library's index than by the
/// planes; or, with `below`, the double before it.
std::vector<bool> moved_planes(const voxel_map& map, unsigned axis, bool below) {
  const std::vector<double>& planes = map.planes[axis];
  std::vector<bool> moved(planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto here = static_cast<std::int64_t>(k);
    const double before = std::nextafter(planes[k], -std::numeric_limits<double>::infinity());
    moved[k] = below ? map.index(axis, before) != here - 1 : map.index(axis, planes[k]) != here;
  }
  return moved;
}

std::vector<octant_index> with_moved_faces(const voxel_map& map, bool below) {
  std::array<std::vector<bool>, 3> moved;
  for (unsigned a = 0; a < 3; ++a)
    moved[a] = moved_planes(map, a, below);
  std::vector<octant_index> found;
  for (const octant_index& v : map.voxels) {
    bool is = false;
    for (unsigned a = 0; a < 3; ++a)
      is = is || moved[a][v[a]] || moved[a][v[a] + 1];
    if (is)
      found.push_back(v);
  }
  return found;
}

std::string ambiguities(const voxel_map& map) {
  if (!map.index)
    return "\"ambiguous\":null,\"ambiguous_below\":null";
  std::vector<octant_index> at = with_moved_faces(map, false);
  const std::size_t count = at.size();
  at.resize(std::min<std::size_t>(count, 8));
  return "\"ambiguous\":" + std::to_string(count) +
         ",\"ambiguous_voxels\":" + list(at, [](const octant_index& v) { return integers(v); }) +
         ",\"ambiguous_below\":" + std::to_string(with_moved_faces(map, true).size());
}

/// In a string of JSON.
std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      all += '\\';
    all += c < ' ' || c > '~' ? '?' : c;
  }
  return all + '"';
}

void check(const voxel_map& map) {
  if (map.voxels.empty())
    throw map_refused("no voxel is occupied");
  for (unsigned a = 0; a < 3; ++a) {
    const std::vector<double>& p = map.planes[a];
    if (p.size() < 2 || p.size() - 1 > most_map_count)
      throw map_refused("the map has " + std::to_string(p.size()) +
                        " planes on an axis: 2 to 2^20 + 1 are taken");
    for (std::size_t k = 0; k < p.size(); ++k)
      if (!std::isfinite(p[k]) || (k > 0 && !(p[k - 1] < p[k])))
        throw map_refused(std::string("the planes of axis ") + "xyz"[a] +
                          " are not finite and increasing");
  }
}

bool write_all(const std::string& header, const std::vector<octant_index>& voxels) {
  static_assert(std::endian::native == std::endian::little && sizeof(octant_index) == 12);
  return std::fwrite(header.data(), 1, header.size(), stdout) == header.size() &&
         std::fwrite(voxels.data(), sizeof(octant_index), voxels.size(), stdout) == voxels.size() &&
         std::fflush(stdout) == 0;
}

std::string first_line(std::string text) {
  text = text.substr(0, std::min<std::size_t>(text.find('\n'), 300));
  for (char& c : text)
    if (c < ' ' || c > '~')
      c = '?';
  return text;
}

void bound_resources() {
  const auto at_most = [](auto resource, rlim_t most) {
    rlimit now{};
    if (getrlimit(resource, &now) == 0 && now.rlim_cur > most) {
      now.rlim_cur = std::min(most, now.rlim_max);
      setrlimit(resource, &now);
    }
  };
  at_most(RLIMIT_AS, rlim_t{1} << 34);
  at_most(RLIMIT_CPU, 600);
  at_most(RLIMIT_CORE, 0);
}

} // namespace

void voxel_map::add(const octant_index& lo, const octant_index& hi) {
  std::uint64_t number = 1; // of three counts to 2^20
  for (unsigned a = 0; a < 3; ++a)
    number *= hi[a] - lo[a];
  if (number > most_map_voxels - voxels.size())
    throw map_refused("more than 2^26 voxels are occupied: take a part of the map");
  for (std::uint32_t z = lo[2]; z < hi[2]; ++z)
    for (std::uint32_t y = lo[1]; y < hi[1]; ++y)
      for (std::uint32_t x = lo[0]; x < hi[0]; ++x)
        voxels.push_back({x, y, z});
}

void index_bounds::add(const std::array<std::int64_t, 3>& from,
                       const std::array<std::int64_t, 3>& to) {
  for (unsigned a = 0; a < 3; ++a) {
    lo[a] = std::min(lo[a], from[a]);
    hi[a] = std::max(hi[a], to[a]);
  }
}

index_range range_of(std::int64_t lowest, std::int64_t highest) {
  const auto refuse = [] {
    throw map_refused("the occupied voxels span more than 2^20 on an axis: take a part of the map");
  };
  if (highest - lowest + 3 > most_map_count)
    refuse();
  index_range r;
  if (lowest < 1)
    r.first = -static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(1 - lowest)));
  if (highest + 2 - r.first > most_map_count)
    r.first = lowest - 1;
  r.count = static_cast<std::uint32_t>(highest + 2 - r.first);
  return r;
}

std::string refusal() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "the library wants more memory than 16 GiB for it";
  } catch (const std::exception& e) {
    return first_line(e.what());
  } catch (...) {
    return "the library does not read it";
  }
}

int write_map(const char* program, const map_library& library, const std::string& path,
              const map_options& options) {
  // what libraries say of damaged files is no line of ours
  const int errors = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int output = dup(STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  bound_resources();
  std::string why, header;
  voxel_map map;
  try {
    struct stat file{};
    if (stat(path.c_str(), &file) != 0)
      throw map_refused(std::strerror(errno));
    if (!S_ISREG(file.st_mode))
      throw map_refused("not a regular file");
    if (file.st_size == 0)
      throw map_refused("the file is empty");
    if (static_cast<std::uint64_t>(file.st_size) > most_map_bytes)
      throw map_refused("the file is larger than 4 GiB");
    map = library.read(path, options);
    std::sort(map.voxels.begin(), map.voxels.end(),
              [](const octant_index& a, const octant_index& b) {
                return std::array{a[2], a[1], a[0]} < std::array{b[2], b[1], b[0]};
              });
    map.voxels.erase(std::unique(map.voxels.begin(), map.voxels.end()), map.voxels.end());
    check(map);
    header = "{\"library\":" + quoted(map.library) + ",\"rule\":" + quoted(map.rule) +
             ",\"grid\":" + grid_text(map) + ",\"first\":" + integers(map.first) +
             ",\"names\":" + quoted(map.names) +
             ",\"voxels\":" + std::to_string(map.voxels.size()) + "," + ambiguities(map) + "}\n";
  } catch (...) {
    why = refusal();
  }
  std::fflush(stdout);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (!why.empty()) {
    std::fprintf(stderr, "%s: %s: %s\n", program, first_line(path).c_str(), why.c_str());
    return 2;
  }
  if (!write_all(header, map.voxels)) {
    std::fprintf(stderr, "%s: cannot write the voxels\n", program);
    return 2;
  }
  return 0;
}

} // namespace graze::peers
