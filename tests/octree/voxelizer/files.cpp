// Octree files: what is written comes back; what is damaged or made to harm is refused.
#include "../../support/program.hpp"
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_file.hpp>
#include <zlib.h>

using namespace graze;
using namespace graze::octree;

namespace {

using bytes = std::vector<unsigned char>;

sparse_octree small_octree(int level = 3) {
  return *voxelize(quartdef{}, box{{-1.5, -1.5, -1.5}, {1.5, 1.5, 0}}, level);
}
bytes small_file() { return *encode_octree(small_octree(), "quartdef"); }

/// Makes the checksum right again, as one would who means harm.
bytes signed_again(bytes b) {
  const auto sum = static_cast<std::uint32_t>(crc32_z(0, b.data(), b.size() - 4));
  for (unsigned i = 0; i < 4; ++i)
    b[b.size() - 4 + i] = static_cast<unsigned char>(sum >> (8 * i));
  return b;
}
template <class N> bytes with(bytes b, std::size_t at, N value) {
  std::memcpy(b.data() + at, &value, sizeof value);
  return signed_again(std::move(b));
}
void refused(const bytes& b, const std::string& reason) {
  const auto r = decode_octree(b);
  INFO(reason << " | " << r.reason());
  CHECK_FALSE(r);
  CHECK(r.reason().find(reason) != std::string::npos);
  CHECK(r.reason().find('\n') == std::string::npos);
}

} // namespace

TEST_CASE("octree.file: an octree comes back as it was", "[unit]") {
  for (const int level : {1, 2, 3, 7}) {
    const sparse_octree tree = small_octree(level);
    const auto file = encode_octree(tree, "a description");
    REQUIRE(file);
    CHECK(file->size() == 68 + 13 + tree.bytes() + 4);
    const auto back = decode_octree(*file);
    REQUIRE(back);
    CHECK(back->octree == tree);
    CHECK(back->description == "a description");
  }
  const auto empty = voxelize(quartdef{}, box{{4, 4, 4}, {5, 5, 5}}, 3);
  const auto file = encode_octree(*empty, "");
  REQUIRE(file);
  CHECK(decode_octree(*file)->octree == *empty);
  CHECK_FALSE(encode_octree(*empty, std::string(65537, 'x')));
}

TEST_CASE("octree.file: cut short at every byte, or longer, it is refused", "[exhaustive]") {
  const bytes file = small_file();
  int accepted = 0;
  for (std::size_t n = 0; n < file.size(); ++n) {
    const bytes part(file.begin(),
                     file.begin() + static_cast<std::ptrdiff_t>(n)); // exact size: asan
    accepted += decode_octree(part).has_value();
  }
  CHECK(accepted == 0);
  refused(bytes(file.begin(), file.end() - 1), "cut short");
  refused(bytes(file.begin(), file.begin() + 20), "cut short");
  refused({}, "not an octree file");
  bytes longer = file;
  longer.push_back(0);
  refused(longer, "1 bytes after its end");
}

TEST_CASE("octree.file: every bit flipped is refused", "[exhaustive]") {
  const bytes file = small_file();
  int accepted = 0;
  for (std::size_t n = 0; n < 8 * file.size(); ++n) {
    bytes damaged = file;
    damaged[n / 8] = static_cast<unsigned char>(damaged[n / 8] ^ (1u << n % 8));
    accepted += decode_octree(damaged).has_value();
  }
  CHECK(accepted == 0);
}

TEST_CASE("octree.file: with a right checksum, any byte changed is refused or a sound octree",
          "[exhaustive]") {
  const bytes file = small_file();
  for (std::size_t at = 0; at + 4 < file.size(); ++at)
    for (const unsigned change : {1u, 2u, 3u, 0x80u, 0xffu}) {
      const auto r = decode_octree(with(file, at, static_cast<unsigned char>(file[at] ^ change)));
      if (!r)
        continue;
      // the root, the description, a mask of as many children, or a leaf's other content
      const auto again = encode_octree(r->octree, r->description);
      REQUIRE(again);
      CHECK(*again == with(file, at, static_cast<unsigned char>(file[at] ^ change)));
      CHECK(
          (at < 68 + 8 + r->octree.node_count() || at >= file.size() - 4 - r->octree.leaf_count()));
    }
}

TEST_CASE("octree.file: hostile numbers are refused with a reason", "[hardcase]") {
  const sparse_octree tree = small_octree();
  const bytes file = small_file();
  constexpr std::size_t text = 8; // "quartdef"
  const std::size_t masks = 68 + text, first = masks + tree.node_count(),
                    leaves = first + 4 * tree.node_count();
  refused(with(file, 0, 'X'), "not an octree file");
  refused(with(file, 8, std::uint32_t{2}), "version 2");
  refused(with(file, 12, std::uint32_t{0}), "level");
  refused(with(file, 12, std::uint32_t{54}), "level");
  refused(with(file, 12, ~std::uint32_t{0}), "level");
  refused(with(file, 12, std::uint32_t{4}), "do not make an octree");
  refused(with(file, 12, std::uint32_t{2}), "do not make an octree");
  refused(with(file, 40, std::numeric_limits<double>::quiet_NaN()), "root");
  refused(with(file, 40, -1.0), "root");
  refused(with(file, 16, std::numeric_limits<double>::infinity()), "root");
  for (const std::size_t count : {std::size_t{48}, std::size_t{56}}) {
    refused(with(file, count, ~std::uint64_t{0}), "out of range");
    refused(with(file, count, std::uint64_t{1} << 61), "out of range");
    refused(with(file, count, std::uint64_t{0xffff'ffff}), "cut short");
    refused(with(file, count, std::uint64_t{0}), "after its end");
  }
  refused(with(file, 64, ~std::uint32_t{0}), "out of range");
  // indices: beyond the end, to the node itself (a cycle), to its own group, shared
  for (std::size_t i = 0; i < tree.node_count(); ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    for (const std::uint32_t to : {~std::uint32_t{0}, index, index + 1, index - 1,
                                   tree.first_children()[i] + 1, std::uint32_t{0x8000'0000}})
      if (to != tree.first_children()[i])
        refused(with(file, first + 4 * i, to), "do not make an octree");
    if (i > 0 && tree.first_children()[i - 1] != tree.first_children()[i])
      refused(with(file, first + 4 * i, tree.first_children()[i - 1]), "do not make an octree");
    refused(with(file, masks + i, static_cast<unsigned char>(0)), "do not make an octree");
    // one child more or less
    refused(
        with(file, masks + i, static_cast<unsigned char>(tree.masks()[i] & (tree.masks()[i] - 1))),
        "do not make an octree");
  }
  for (const unsigned char c : {0, 3, 255})
    refused(with(file, leaves, c), "leaf");
}

TEST_CASE("octree.file: a folder of nodes that share children does not take exponential time",
          "[hardcase]") {
  // each node of a level points at the same two nodes of the next
  const auto root = root_cube::make({{0, 0, 0}, 1}, 53);
  std::vector<std::uint8_t> masks;
  std::vector<std::uint32_t> first;
  for (std::uint32_t depth = 0; depth < 52; ++depth)
    for (int twin = 0; twin < 2; ++twin) {
      masks.push_back(3);
      first.push_back(depth == 0 ? 0 : 2 * (depth - 1));
    }
  masks.push_back(3);
  first.push_back(2 * 51);
  CHECK_FALSE(
      sparse_octree::from_arrays(*root, masks, first, {content::possible, content::possible}));
  CHECK_FALSE(sparse_octree::from_arrays(*root, {}, {}, {}));
  CHECK_FALSE(sparse_octree::from_arrays(*root, {0}, {}, {}));
}

TEST_CASE("graze-voxelize: writes a file that it reads back, and says what is wrong", "[unit]") {
  const support::scratch dir;
  const std::string file = dir / "a.octree";
  const auto made = support::call(GRAZE_VOXELIZE, "--scene tanglecube --level 6 --out " + file);
  CHECK(made.code == 0);
  CHECK(made.out.find("certified") != std::string::npos);
  const auto loaded = load_octree(file);
  REQUIRE(loaded);
  CHECK(loaded->octree == *voxelize(tanglecube{}, box{{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}}, 6));
  const auto shown = support::call(GRAZE_VOXELIZE, "--json --info " + file);
  CHECK(shown.code == 0);
  CHECK(shown.out.find("\"level\":6") != std::string::npos);

  const std::string threads = dir / "b.octree";
  CHECK(support::call(GRAZE_VOXELIZE, "--scene tanglecube --level 6 --threads 2 -o " + threads)
            .code == 0);
  CHECK(support::content(threads) == support::content(file));

  std::ofstream(dir / "cut", std::ios::binary) << support::content(file).substr(0, 1000);
  std::ofstream(dir / "other") << "hello, world";
  support::refused(GRAZE_VOXELIZE, "--info " + (dir / "cut"), "cut short");
  support::refused(GRAZE_VOXELIZE, "--info " + (dir / "other"), "not an octree file");
  support::refused(GRAZE_VOXELIZE, "--info " + (dir / "none"), "none");
  support::refused(GRAZE_VOXELIZE, "--info " + (dir / ""), "folder");
  support::refused(GRAZE_VOXELIZE, "--scene teapot --out " + file, "tanglecube");
  support::refused(GRAZE_VOXELIZE, "--scene spheres --level 0 --out " + file, "--level must be");
  support::refused(GRAZE_VOXELIZE, "--scene spheres --level 15 --out " + file, "--level must be");
  support::refused(GRAZE_VOXELIZE, "--scene spheres --out " + (dir / "no/a"), "no");
  support::refused(GRAZE_VOXELIZE, "--scene spheres", "--out");
  support::refused(GRAZE_VOXELIZE, "", "--scene");
}
