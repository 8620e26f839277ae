#pragma once
/// The camera of the six scenes (docs/definitions.md): every constant is dyadic, so that a peer that
/// follows the order of operations below casts the same double rays, bit for bit.
#include <graze/octree/ray.hpp>
#include <graze/octree/vector.hpp>
#include <graze/support/status.hpp>

namespace graze::render {

using octree::vec3;

/// A pinhole camera. Units: scene length.
struct camera {
  vec3 eye;
  vec3 centre; ///< CD: from the eye to the picture's centre
  vec3 right;  ///< CR: the picture's full width
  vec3 up;     ///< CU: the picture's full height

  /// The six scenes' camera at scale S: eye = S (3, 2, 6). Exact for every S of the six scenes.
  [[nodiscard]] static camera standard(double scale);

  /// The directions through the picture are far enough from 0 and from overflow for ray_through:
  /// centre is away from the plane of right and up, the three are of like size, and all of it is
  /// finite and between 1e-100 and 1e100 in size. Otherwise the reason.
  [[nodiscard]] support::status check() const;

  /// The ray through the centre of pixel (column, row), row 0 on top, of a width x height picture,
  /// 0 <= column < width, 0 <= row < height, both at most 2^20; pixels are squares, and CR and CU
  /// span the shorter side, m pixels. Order of operations, each rounded to nearest, none fused:
  ///   u = (2 column + 1 - width) / (2 m)          integers, then one division
  ///   v = (height - 1 - 2 row) / (2 m)
  ///   direction[a] = (centre[a] + u * right[a]) + v * up[a]
  /// The direction is not normalized: t = 1 is the picture plane. The ray that is cast is this
  /// double ray, whatever its distance from the ideal one. For the standard camera the error of the
  /// direction is 0 where m is a power of two up to 2^14 and the picture a square (u and v have at
  /// most 15 bits, the constants at most 14, so that no operation rounds); otherwise, for a square,
  /// below 2^-49 a component, which is 2 ulps of the largest component (that along z,
  /// 4.5 < |z| < 8). The direction is not 0 (check()).
  [[nodiscard]] octree::ray ray_through(int column, int row, int width, int height) const;
  [[nodiscard]] octree::ray ray_through(int column, int row, int size) const {
    return ray_through(column, row, size, size);
  }
  friend bool operator==(const camera&, const camera&) = default;
};

} // namespace graze::render
