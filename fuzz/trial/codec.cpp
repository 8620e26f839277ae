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
  return bytes;
}

std::optional<trial> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != encoded_size)
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
  const std::uint64_t count = std::uint64_t{1} << t.level;
  for (unsigned a = 0; a < 3; ++a) {
    t.base[a] = next() % count;
    const std::uint64_t extent = (bytes[105] >> (2 * a) & 3u) + 1u;
    t.extent[a] = static_cast<std::uint8_t>(std::min(extent, count - t.base[a]));
  }
  if (!judgeable(t))
    return std::nullopt;
  return t;
}

} // namespace graze::fuzz
