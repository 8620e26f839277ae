#pragma once
/// How hard a trial is: by how much its ray passes the edges of its octants.
#include <trial/trial.hpp>

namespace graze::fuzz {

/// The smallest distance of the ray from an edge (and so from a vertex) of the block's octants near
/// which it passes, in ulps: by how many ulps origin and direction would all have to change, in the
/// worst way and to first order, for the supporting line to meet the edge. 0: it meets one.
/// Infinity: it passes none at t >= 0 within the block.
///
/// For the planes p on axis a and q on axis b the line meets the edge where
///   D = (p - o_a) d_b - (q - o_b) d_a
/// is 0. Told is |D| / (ulp(p, o_a) |d_b| + |p - o_a| ulp(d_b) + the same of b), with ulp(p, o)
/// that of the larger, since traversals round p - o. In long double, whose exponents hold every
/// product: where it has 64 bits (x86-64), to within 2^-8 ulps.
double margin(const trial& t);

} // namespace graze::fuzz
