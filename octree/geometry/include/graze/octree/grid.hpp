#pragma once
/// Grids of planes of any kind: spacings that are no power of two, another one on each axis, planes
/// as somebody's library rounds them, or any increasing numbers. (root_cube is for octants.)
#include <graze/needs_cxx20.hpp>

#include <array>
#include <cstdint>
#include <graze/expected.hpp>
#include <graze/octree/plane_rule.hpp>
#include <graze/octree/slabs.hpp>
#include <memory>
#include <span>
#include <vector>

namespace graze::octree {

/// count(a) voxels on axis a, between count(a) + 1 planes that increase. Voxel k is [plane k,
/// plane k + 1); the last one has its upper plane too. An axis may be flat: one voxel, whose two
/// planes are the same. Copies share their planes. Units: scene length.
class grid {
public:
  static constexpr std::uint32_t most_voxels = 1u << 20; ///< on an axis

  /// Planes 0 .. count from an origin and a spacing by `rule`, any but `given`. A spacing of 0 and
  /// a count of 1 make a flat axis. Refuses counts outside 1 .. 2^20, numbers that are not finite,
  /// negative spacings, planes beyond the doubles, and planes that by their rule do not increase.
  [[nodiscard]] static expected<grid> make(const vec3& origin, const vec3& spacing,
                                           const std::array<std::uint32_t, 3>& count,
                                           plane_rule rule);

  /// These planes (plane_rule::given). One plane makes a flat axis. Refuses more than 2^20 + 1 and
  /// none, numbers that are not finite, and planes that do not increase.
  [[nodiscard]] static expected<grid> make(const std::array<std::span<const double>, 3>& planes);

  [[nodiscard]] plane_rule rule() const { return shared_->rule; }
  /// Voxels on an axis.
  [[nodiscard]] std::uint32_t count(int axis) const { return shared_->count[at(axis)]; }
  [[nodiscard]] bool flat(int axis) const { return shared_->flat[at(axis)]; }

  /// Plane k <= count(axis), not rounded.
  [[nodiscard]] plane_value plane(int axis, std::uint32_t k) const {
    if (rule() == plane_rule::exact)
      return {shared_->origin[at(axis)], shared_->spacing[at(axis)], k};
    return {shared_->lower[at(axis)][k]};
  }
  /// The greatest double not above plane k, and the least not below it: the plane itself for every
  /// rule but `exact`.
  [[nodiscard]] double lower(int axis, std::uint32_t k) const {
    return shared_->lower[at(axis)][k];
  }
  [[nodiscard]] double upper(int axis, std::uint32_t k) const { return upper_planes(axis)[k]; }
  /// Of all planes, count(axis) + 1.
  [[nodiscard]] std::span<const double> lower_planes(int axis) const {
    return shared_->lower[at(axis)];
  }
  [[nodiscard]] std::span<const double> upper_planes(int axis) const {
    return rule() == plane_rule::exact ? shared_->upper[at(axis)] : shared_->lower[at(axis)];
  }
  /// The greatest upper(k) - lower(k) of an axis, rounded up.
  [[nodiscard]] double plane_width(int axis) const { return shared_->width[at(axis)]; }

  /// What voxel `index` lies between; index[a] < count(a).
  [[nodiscard]] slabs voxel(const std::array<std::uint32_t, 3>& index) const {
    slabs s;
    for (int a = 0; a < 3; ++a) {
      const std::uint32_t k = index[at(a)];
      s.lower[at(a)] = plane(a, k);
      s.upper[at(a)] = plane(a, k + 1);
      s.closed_far |= k + 1 == count(a) ? 1u << a : 0;
    }
    return s;
  }

private:
  struct planes {
    plane_rule rule = plane_rule::given;
    vec3 origin{}, spacing{};
    std::array<std::uint32_t, 3> count{};
    std::array<bool, 3> flat{};
    std::array<std::vector<double>, 3> lower, upper; ///< upper: of the rule `exact` alone
    vec3 width{};
  };
  static expected<grid> make_within_scope(const vec3& origin, const vec3& spacing,
                                          const std::array<std::uint32_t, 3>& count,
                                          plane_rule rule);
  static expected<grid> make_within_scope(const std::array<std::span<const double>, 3>& planes);
  static constexpr unsigned at(int axis) { return static_cast<unsigned>(axis); }
  explicit grid(std::shared_ptr<const planes> p) : shared_(std::move(p)) {}
  std::shared_ptr<const planes> shared_;
};

} // namespace graze::octree
