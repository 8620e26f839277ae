#pragma once
/// Voxelization eight children at a time, by the widest instructions that the processor has: the
/// bytes of voxelize, sooner.
///
/// The kernels of the four surfaces of surfaces.hpp are in graze::octree. For a surface of one's
/// own: a file for each path, compiled for its instructions, that defines a table by
/// make_voxelizer_kernels (voxelizer_kernels_of_path.hpp), and a specialization of
/// voxelizer_kernels_of that chooses among them; octree/src/voxelizer is the model.
#include <graze/batch.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/rounding/nearest.hpp>
#include <type_traits>

namespace graze::octree {

/// The last-level test of eight children but for its end: bit i of `kept` where child i may hold a
/// zero, of `certified` and `one_sign`, parts of it, where its corners have two proven signs, and
/// the same one at all.
struct leaf_signs {
  std::uint8_t kept, certified, one_sign;
};

/// What a path has compiled for the surface F: pure arithmetic, no memory but the arguments. Called
/// within a scope of kernel_backend. Every corner of the octant's children must be a double. A
/// result has bit i for child i.
template <Surface F> struct voxelizer_kernels {
  /// has_no_zero of inclusion.hpp.
  unsigned (*no_zero)(const F&, const double* corner, double half);
  leaf_signs (*leaves)(const F&, const double* corner, double half);
  /// The end of leaf_content, for children with one sign at all corners: f is proven monotone in
  /// each variable or, by the mean value form, free of zeros.
  unsigned (*none_of_one_sign)(const F&, const double* corner, double half);
};

/// The scalar backend beside the kernels, whose scope serves every path: embedded rounding looks at
/// no mode.
#if defined(__x86_64__)
using kernel_backend = rounding::upward;
#else
using kernel_backend = rounding::nearest;
#endif

/// The path's kernels. The path must run here (batch::refusal).
template <Surface F> const voxelizer_kernels<F>& voxelizer_kernels_of(batch::path p);
template <> const voxelizer_kernels<spheres>& voxelizer_kernels_of<spheres>(batch::path p);
template <> const voxelizer_kernels<quartdef>& voxelizer_kernels_of<quartdef>(batch::path p);
template <> const voxelizer_kernels<tanglecube>& voxelizer_kernels_of<tanglecube>(batch::path p);
template <> const voxelizer_kernels<holesrot>& voxelizer_kernels_of<holesrot>(batch::path p);

/// scalar_judge's verdicts by a path's kernels; an octant that the domain cuts is left to the
/// scalar one. `f` must outlive it.
template <Surface F> class lane_judge {
public:
  using scope = typename kernel_backend::scope;
  /// The path must run here (batch::refusal).
  lane_judge(const F& f, const box& domain, batch::path p = batch::path_in_use())
      : f_(&f), scalar_(f, domain), kernels_(voxelizer_kernels_of<F>(p)) {}

  [[nodiscard]] std::uint8_t open(const cube& cell) const {
    if (scalar_.is_cut(cell)) [[unlikely]]
      return scalar_.open(cell);
    return static_cast<std::uint8_t>(~kernels_.no_zero(*f_, cell.lo.data(), cell.size / 2));
  }

  [[nodiscard]] leaf_children leaves(const cube& cell) const {
    if (scalar_.is_cut(cell)) [[unlikely]]
      return scalar_.leaves(cell);
    const double* corner = cell.lo.data();
    const double half = cell.size / 2;
    const leaf_signs found = kernels_.leaves(*f_, corner, half);
    unsigned kept = found.kept;
    if (found.one_sign != 0)
      kept &= ~(found.one_sign & kernels_.none_of_one_sign(*f_, corner, half));
    return {static_cast<std::uint8_t>(kept), found.certified};
  }

private:
  const F* f_;
  scalar_judge<F, kernel_backend> scalar_;
  voxelizer_kernels<F> kernels_;
};

/// voxelize by a path's kernels: the same bytes. Refuses also a path that does not run here.
template <Surface F>
[[nodiscard]] expected<sparse_octree> voxelize_eight(const F& f, const root_cube& root,
                                                     const box& domain,
                                                     batch::path p = batch::path_in_use()) {
  if (!detail::is_proper(domain))
    return unexpected{"domain is empty"};
  if (const auto reason = batch::refusal(p))
    return unexpected{*reason};
  return voxelize_by(lane_judge<F>(f, domain, p), root);
}

/// The same in the smallest symmetric root that holds the domain.
template <Surface F>
[[nodiscard]] expected<sparse_octree> voxelize_eight(const F& f, const box& domain, int level,
                                                     batch::path p = batch::path_in_use()) {
  const expected<root_cube> root = enclosing_root(domain, level);
  if (!root)
    return unexpected{root.reason()};
  return voxelize_eight(f, *root, domain, p);
}

} // namespace graze::octree
