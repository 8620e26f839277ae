#pragma once
/// The camera of DESIGN ("The six scenes and the camera"): every constant is dyadic, so that a peer
/// that follows the order of operations below casts the same double rays, bit for bit.
#include <graze/octree/ray.hpp>
#include <graze/octree/vector.hpp>

namespace graze::render {

using octree::vec3;

/// A pinhole camera. Units: scene length.
struct camera {
  vec3 eye;
  vec3 centre; ///< CD: from the eye to the picture's centre
  vec3 right;  ///< CR: the picture's full width
  vec3 up;     ///< CU: the picture's full height

  /// DESIGN's camera at scale S: eye = S (3, 2, 6). Exact for every S of the six scenes.
  [[nodiscard]] static camera standard(double scale);

  /// The ray through the centre of pixel (column, row), row 0 on top, of a size x size picture;
  /// 0 <= column, row < size <= 2^15. Order of operations, each rounded to nearest, none fused:
  ///   u = (2 column + 1 - size) / (2 size)          integers, then one division
  ///   v = (size - 1 - 2 row) / (2 size)
  ///   direction[a] = (centre[a] + u * right[a]) + v * up[a]
  /// The direction is not normalized: t = 1 is the picture plane. The ray that is cast is this
  /// double ray, whatever its distance from the ideal one. Error of the direction: 0 where size is
  /// a power of two (u and v have at most 15 bits, the constants at most 14, so that no operation
  /// rounds); otherwise below 2^-49 a component, which is 2 ulps of the largest component (that
  /// along z, 4.5 < |z| < 8).
  [[nodiscard]] octree::ray ray_through(int column, int row, int size) const;
};

} // namespace graze::render
