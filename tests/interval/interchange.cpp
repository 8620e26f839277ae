/// The interchange representation: bytes as the standard orders them, and what is no interval.
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/interchange.hpp>
#include <vector>

namespace {

using graze::bounds, graze::decorated_bounds, graze::decoration;
using graze::bounds_from_bytes, graze::decorated_from_bytes, graze::to_bytes;
using std::endian;

constexpr double infinity = graze::checking::infinity;
const double not_a_number = graze::checking::nan();

std::vector<int> octets(const auto& bytes) {
  std::vector<int> all;
  for (const std::byte b : bytes)
    all.push_back(std::to_integer<int>(b));
  return all;
}

graze::decorated_bytes bytes_of(double lower, double upper, int octet) {
  graze::decorated_bytes bytes;
  graze::detail::put_double(bytes.data(), lower, endian::big);
  graze::detail::put_double(bytes.data() + 8, upper, endian::big);
  bytes[16] = static_cast<std::byte>(octet);
  return bytes;
}
graze::interval_bytes bytes_of(double lower, double upper) {
  graze::interval_bytes bytes;
  std::copy_n(bytes_of(lower, upper, 0).begin(), 16, bytes.begin());
  return bytes;
}

bool same(const bounds& x, const bounds& y) { return x.within(y) && y.within(x); }

} // namespace

TEST_CASE("interval.interchange: the bytes of inf, sup and decoration", "[unit]") {
  CHECK(octets(to_bytes(bounds{-1, 2}, endian::big)) ==
        std::vector{0xbf, 0xf0, 0, 0, 0, 0, 0, 0, 0x40, 0, 0, 0, 0, 0, 0, 0});
  CHECK(octets(to_bytes(decorated_bounds{{-1, 2}, decoration::com})) ==
        std::vector{0, 0, 0, 0, 0, 0, 0xf0, 0xbf, 0, 0, 0, 0, 0, 0, 0, 0x40, 16});
  // -0 below, +0 above; +inf below, -inf above is empty
  for (const bounds zero : {bounds{0.0, 0.0}, bounds{-0.0, -0.0}})
    CHECK(octets(to_bytes(zero, endian::big)) ==
          std::vector{0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(octets(to_bytes(bounds::empty(), endian::big)) ==
        std::vector{0x7f, 0xf0, 0, 0, 0, 0, 0, 0, 0xff, 0xf0, 0, 0, 0, 0, 0, 0});
  CHECK(octets(to_bytes(decorated_bounds{bounds::empty(), decoration::trv}, endian::big))[16] == 4);
  const auto nai = to_bytes(decorated_bounds::nai(), endian::big);
  CHECK(std::isnan(graze::detail::get_double(nai.data(), endian::big)));
  CHECK(std::isnan(graze::detail::get_double(nai.data() + 8, endian::big)));
  CHECK(octets(nai)[16] == 0);
}

TEST_CASE("interval.interchange: what is written reads back", "[unit]") {
  for (const endian order : {endian::little, endian::big})
    for (const bounds x : {bounds{-1, 2}, bounds{0, 0}, bounds{-0x1p-1074, 0x1.fffffffffffffp1023},
                           bounds{-infinity, 3}, bounds::entire(), bounds::empty()}) {
      const auto bare = bounds_from_bytes(to_bytes(x, order), order);
      REQUIRE(bare);
      CHECK(same(*bare, x));
      for (const decoration d :
           {decoration::trv, decoration::def, decoration::dac, decoration::com}) {
        const bool possible = d == decoration::trv || (d == decoration::com && x.is_common()) ||
                              (d != decoration::com && !x.is_empty());
        const auto marked = decorated_from_bytes(to_bytes(decorated_bounds{x, d}, order), order);
        CHECK(marked.has_value() == possible);
        if (marked) {
          CHECK(same(marked->part, x));
          CHECK(marked->label == d);
        }
      }
    }
  const auto nai = decorated_from_bytes(to_bytes(decorated_bounds::nai()));
  REQUIRE(nai);
  CHECK(nai->is_nai());
}

TEST_CASE("interval.interchange: other bytes are refused", "[unit]") {
  for (const auto& bytes :
       {bytes_of(2, 1), bytes_of(infinity, infinity), bytes_of(-infinity, -infinity),
        bytes_of(not_a_number, 1), bytes_of(1, not_a_number), bytes_of(not_a_number, not_a_number)})
    CHECK_FALSE(bounds_from_bytes(bytes, endian::big));
  CHECK(bounds_from_bytes(bytes_of(0.0, -0.0), endian::big));
  for (const int octet : {1, 2, 3, 5, 7, 9, 13, 15, 17, 255})
    CHECK_FALSE(decorated_from_bytes(bytes_of(1, 2, octet), endian::big));
  CHECK_FALSE(decorated_from_bytes(bytes_of(1, 2, 0), endian::big)); // ill, but a set
  CHECK_FALSE(decorated_from_bytes(bytes_of(not_a_number, 2, 0), endian::big));
  CHECK_FALSE(decorated_from_bytes(bytes_of(1, not_a_number, 0), endian::big));
  CHECK_FALSE(decorated_from_bytes(bytes_of(not_a_number, not_a_number, 4), endian::big));
  CHECK_FALSE(decorated_from_bytes(bytes_of(2, 1, 4), endian::big));
}
