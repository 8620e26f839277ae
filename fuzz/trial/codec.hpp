#pragma once
/// Trials as bytes, for drivers that only know bytes (libFuzzer, a corpus of files).
///
///   offset  size  what, little endian
///        0    48  origin x, y, z, direction x, y, z (binary64)
///       48    32  the root's lowest corner x, y, z, and its size
///       80    24  base x, y, z
///      104     1  level
///      105     1  extent - 1: two bits an axis, x lowest
/// A ray through octants ends here. Others go on:
///      106     1  cells (0 cube, 1 grid, 2 boxes), bit 2: a segment
///      107     1  of a grid its rule; of boxes their number - 1
///      108    24  of a segment its end
///      132        of a grid by a rule 48 bytes of origin and spacing, 12 of counts; of given planes three
///                 bytes of numbers - 1, and the planes; of boxes 48 bytes each, lo and hi
#include <optional>
#include <span>
#include <trial/trial.hpp>
#include <vector>

namespace graze::fuzz {

/// Of a ray through octants.
inline constexpr std::size_t encoded_size = 106;

/// decode() gives the trial back, bit for bit.
std::vector<std::uint8_t> encode(const trial& t);

/// The trial of these bytes; what it holds passes judgeable(). Numbers out of range are brought into
/// it, so that most bytes mean something: an infinity or NaN loses a bit of its exponent, the level
/// is taken modulo 54, the base modulo the count, the block ends at the far faces, a spacing is its
/// magnitude, planes are sorted, and so are a box's faces. Nothing for too few bytes, or too many, and for
/// those that still do not pass (a direction of 0, a root whose octants are not exact).
std::optional<trial> decode(std::span<const std::uint8_t> bytes);

} // namespace graze::fuzz
