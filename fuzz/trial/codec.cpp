#include <algorithm>
#include <trial/codec.hpp>

namespace graze::fuzz {

namespace {

/// Infinities and NaNs without the lowest bit of their exponent: finite.
double finite(std::uint64_t bits) {
  const double x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : std::bit_cast<double>(bits & ~(std::uint64_t{1} << 52));
}

class writer {
public:
  explicit writer(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
  void word(std::uint64_t value) {
    for (int i = 0; i < 8; ++i)
      bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void number(double x) { word(std::bit_cast<std::uint64_t>(x)); }

private:
  std::vector<std::uint8_t>& bytes_;
};

std::uint64_t word_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i)
    value |= std::uint64_t{bytes[offset + i]} << (8 * i);
  return value;
}

} // namespace

std::vector<std::uint8_t> encode(const trial& t) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(encoded_size);
  writer out(bytes);
  for (const vec3* v : {&t.origin, &t.direction, &t.root.lo})
    for (const double x : *v)
      out.number(x);
  out.number(t.root.size);
  for (const std::uint64_t b : t.base)
    out.word(b);
  bytes.push_back(static_cast<std::uint8_t>(t.level));
  unsigned extent = 0;
  for (unsigned a = 0; a < 3; ++a)
    extent |= (t.extent[a] - 1u) << (2 * a);
  bytes.push_back(static_cast<std::uint8_t>(extent));
  if (!t.end && t.cells() == cell_kind::cube)
    return bytes;
  bytes.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(t.cells()) | (t.end ? 4u : 0u)));
  bytes.push_back(static_cast<std::uint8_t>(
      t.boxes ? t.boxes->size() - 1 : (t.grid ? static_cast<std::size_t>(t.grid->rule) : 0)));
  for (const double x : t.end.value_or(vec3{}))
    out.number(x);
  if (t.boxes)
    for (const octree::box& b : *t.boxes)
      for (const vec3* v : {&b.lo, &b.hi})
        for (const double x : *v)
          out.number(x);
  if (!t.grid)
    return bytes;
  if (t.grid->rule == plane_rule::given) {
    for (const auto& planes : t.grid->given)
      bytes.push_back(static_cast<std::uint8_t>(planes.size() - 1));
    for (const auto& planes : t.grid->given)
      for (const double p : planes)
        out.number(p);
    return bytes;
  }
  for (const vec3* v : {&t.grid->origin, &t.grid->spacing})
    for (const double x : *v)
      out.number(x);
  for (const std::uint32_t n : t.grid->count)
    for (int i = 0; i < 4; ++i)
      bytes.push_back(static_cast<std::uint8_t>(n >> (8 * i)));
  return bytes;
}

namespace {

/// Bytes from the front; zeros where there are no more, and then it is too short.
class byte_reader {
public:
  byte_reader(std::span<const std::uint8_t> bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  std::uint8_t byte() {
    if (at_ == bytes_.size())
      return short_ = true, 0;
    return bytes_[at_++];
  }
  double number() {
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i)
      value |= std::uint64_t{byte()} << (8 * i);
    return finite(value);
  }
  [[nodiscard]] bool ended() const { return !short_ && at_ == bytes_.size(); }

private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_;
  bool short_ = false;
};

/// What follows the common part; false where it is none.
bool decode_scene(std::span<const std::uint8_t> bytes, trial& t) {
  byte_reader in(bytes, encoded_size);
  const std::uint8_t kind = in.byte();
  const std::uint8_t number = in.byte();
  vec3 end;
  for (double& x : end)
    x = in.number();
  if ((kind & 4) != 0)
    t = with_end(t, t.origin, end);
  switch (kind & 3) {
  case 1: {
    grid_planes g;
    g.rule = static_cast<plane_rule>(number % 6);
    if (g.rule == plane_rule::given) {
      std::array<std::size_t, 3> sizes{};
      for (std::size_t& n : sizes)
        n = std::size_t{in.byte()} + 1;
      for (unsigned a = 0; a < 3; ++a) {
        for (std::size_t k = 0; k < sizes[a]; ++k)
          g.given[a].push_back(in.number());
        std::sort(g.given[a].begin(), g.given[a].end());
      }
      g = grid_of(std::move(g.given));
    } else {
      for (double& x : g.origin)
        x = in.number();
      for (double& x : g.spacing)
        x = std::fabs(in.number());
      for (std::uint32_t& n : g.count) {
        n = 0;
        for (int i = 0; i < 4; ++i)
          n |= std::uint32_t{in.byte()} << (8 * i);
        n = n == 0 || n > max_count ? 1 + n % max_count : n;
      }
    }
    t.grid = std::make_shared<const grid_planes>(std::move(g));
    t.root = trial{}.root;
    t.level = trial{}.level;
    break;
  }
  case 2: {
    std::vector<octree::box> boxes(number % max_boxes + 1);
    for (octree::box& b : boxes) {
      for (vec3* v : {&b.lo, &b.hi})
        for (double& x : *v)
          x = in.number();
      for (unsigned a = 0; a < 3; ++a)
        if (b.lo[a] > b.hi[a])
          std::swap(b.lo[a], b.hi[a]);
    }
    t.boxes = std::make_shared<const std::vector<octree::box>>(std::move(boxes));
    t.root = trial{}.root;
    t.level = trial{}.level;
    break;
  }
  case 3:
    return false;
  default:
    break;
  }
  return in.ended();
}

} // namespace

std::optional<trial> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < encoded_size)
    return std::nullopt;
  trial t;
  std::size_t at = 0;
  const auto next = [&] {
    at += 8;
    return word_at(bytes, at - 8);
  };
  for (vec3* v : {&t.origin, &t.direction, &t.root.lo})
    for (double& x : *v)
      x = finite(next());
  t.root.size = finite(next());
  t.level = bytes[104] % (octree::max_level + 1);
  if (bytes.size() != encoded_size && !decode_scene(bytes, t))
    return std::nullopt;
  for (unsigned a = 0; a < 3; ++a) {
    const std::uint64_t count = t.count(a);
    t.base[a] = next() % count;
    const std::uint64_t extent = (bytes[105] >> (2 * a) & 3u) + 1u;
    t.extent[a] = static_cast<std::uint8_t>(std::min(extent, count - t.base[a]));
  }
  if (t.boxes) {
    t.base = {};
    t.extent = {1, 1, 1};
  }
  if (!judgeable(t))
    return std::nullopt;
  return t;
}

} // namespace graze::fuzz
