#pragma once
/// What the generators share: a special vertex of the grid, exact ways to lead a ray to it, and the
/// block around it.
#include <generate/random.hpp>
#include <trial/number.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

/// A vertex of the grid of a trial's level: lo + index * size, exact; or of its grid of any planes (the
/// nearest doubles where they are none), of which `root` is then a frame: size a power of two not far from
/// the grid's, and `level` such that 2^level is not far from its count.
struct site {
  std::array<std::uint64_t, 3> index;
  vec3 vertex;
};

/// The usual distance of two planes of an axis: exact for octants, 0 on a flat axis.
double pitch(const trial& t, unsigned axis);
/// The first and the last plane of an axis.
double lowest(const trial& t, unsigned axis);
double highest(const trial& t, unsigned axis);

/// A vertex of an occupied voxel of the trial's map; for such a trial the next three are the same.
site pick_occupied_site(random_stream& random, const trial& t);

/// Where vertices lie: mostly anywhere, at times on the planes of a coarser level (where many
/// ancestors meet) or beside them, at times on the root's faces.
site pick_site(random_stream& random, const trial& t);
/// A vertex on one to three of the root's faces.
site pick_root_site(random_stream& random, const trial& t);
/// A vertex whose coordinates are mid-planes of coarse levels on at least two axes.
site pick_coarse_site(random_stream& random, const trial& t);
/// The vertex at these indices.
site site_at(const trial& t, const std::array<std::uint64_t, 3>& index);

/// Occupies the 2x2x2 octants around the vertex (those that are in the root), at times one more
/// layer.
void occupy(random_stream& random, trial& t, const site& s);

/// A random double with a random number of significant bits and an exponent between the given ones.
double random_double(random_stream& random, int lowest_exponent, int highest_exponent);

/// A distance from 0 to about the root's size, either sign, log-uniform, a multiple of the root's
/// size times 2^-53.
double random_offset(random_stream& random, const trial& t);

/// The origin o nearest to v - offset for which v - o is an exact double; v itself when offset is
/// too fine. Then the ray o + t (v - o) goes through v to the last bit.
double exact_origin(double v, double offset);

/// Multiplies a direction by 2^k, where that is exact, and leaves it where it is not.
void scale(vec3& direction, int k);

/// A small integer in -2^bits..2^bits, not 0.
double small_integer(random_stream& random, int bits);

/// A random finite direction, not 0, of moderate exponents; at times with zero components.
vec3 random_direction(random_stream& random);

} // namespace graze::fuzz
