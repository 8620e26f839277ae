#pragma once
/// The benchmark's octants and rays. Fixed seeds; rays in single precision where a peer computes in
/// it, so that none of them is judged by a ray that it was not given.
#include <graze/octree/ray.hpp>
#include <peers/occupied_octants.hpp>
#include <random>

namespace graze::bench {

using peers::occupied_octants;

/// The octants that meet the sphere around 0 of radius 0.8 in the root [-1,1]^3: 790,000 at level 9.
[[nodiscard]] occupied_octants sphere_shell(int level);

/// Rays from the root's circumsphere to points spread evenly over the ball within the shell, every
/// component in single precision.
[[nodiscard]] std::vector<octree::ray> random_rays(std::size_t count, std::uint64_t seed);

enum class precision { single, twice };

/// Rays within a few units in the last place of octants' vertices and edges, a third each: aimed
/// at one from afar; from vertex to vertex; along planes of the grid.
[[nodiscard]] std::vector<octree::ray> adversarial_rays(const occupied_octants& octants,
                                                        precision p, std::size_t count,
                                                        std::uint64_t seed);

} // namespace graze::bench
