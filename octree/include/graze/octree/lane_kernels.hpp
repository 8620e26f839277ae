#pragma once
/// First hits and voxelization of a surface, eight children at a time, by the widest instructions
/// that the processor has: the results of surface_traversal and voxelize, bit for bit, sooner.
///
/// The kernels of the four surfaces of surfaces.hpp are in graze::octree. For a surface of one's
/// own: a file for each path, compiled for its instructions, that defines a table by
/// make_lane_kernels (lane_kernels_of_path.hpp), and a specialization of lane_kernels_of that
/// chooses among them; octree/src/lanes is the model.
#include <cassert>
#include <graze/batch.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/voxelizer.hpp>
#include <span>

namespace graze::octree {

/// What a path has compiled for the surface F.
template <Surface F> struct lane_kernels {
  /// surface_traversal<F>::first_hit, for arguments that its make() accepts.
  surface_hit (*first_hit)(const F&, const box& domain, const sparse_octree&, int level, const ray&,
                           traversal_counts*);
  /// The same for `count` rays, two in turn; counts are added to.
  void (*first_hits)(const F&, const box& domain, const sparse_octree&, int level, const ray* rays,
                     std::size_t count, surface_hit* hits, traversal_counts*);
  /// Fills the room with the octree of voxelize<F> below the node returned, which is the root's.
  sparse_octree::builder::inner (*voxelize)(const F&, const box& domain, const cube& root,
                                            int level, sparse_octree::room&);
};

/// The path's kernels. The path must run here (batch::refusal).
template <Surface F> const lane_kernels<F>& lane_kernels_of(batch::path p);
template <> const lane_kernels<spheres>& lane_kernels_of<spheres>(batch::path p);
template <> const lane_kernels<quartdef>& lane_kernels_of<quartdef>(batch::path p);
template <> const lane_kernels<tanglecube>& lane_kernels_of<tanglecube>(batch::path p);
template <> const lane_kernels<holesrot>& lane_kernels_of<holesrot>(batch::path p);

/// voxelize(f, root, domain) by a path's kernels: the same octree, or the same refusal; and refuses
/// a path that does not run here. Any rounding mode; any thread.
template <Surface F>
[[nodiscard]] expected<sparse_octree> voxelize_in_lanes(const F& f, const root_cube& root,
                                                        const box& domain,
                                                        batch::path p = batch::path_in_use()) {
  if (const auto reason = batch::refusal(p))
    return unexpected{*reason};
  if (!(domain.lo[0] <= domain.hi[0] && domain.lo[1] <= domain.hi[1] &&
        domain.lo[2] <= domain.hi[2]))
    return unexpected{"domain is empty"};
  sparse_octree::room out(root);
  const auto top = lane_kernels_of<F>(p).voxelize(f, domain, root.box(), root.level(), out);
  if (out.overflowed)
    return unexpected{"the octree has more than 2^32 nodes at this level"};
  return std::move(out).finish(top);
}

/// The same in the smallest symmetric root that holds the domain.
template <Surface F>
[[nodiscard]] expected<sparse_octree> voxelize_in_lanes(const F& f, const box& domain, int level,
                                                        batch::path p = batch::path_in_use()) {
  const expected<root_cube> root = enclosing_root(domain, level);
  if (!root)
    return unexpected{root.reason()};
  return voxelize_in_lanes(f, *root, domain, p);
}

/// surface_traversal<F> by a path's kernels. One indirect call a ray.
template <Surface F> class lane_traversal {
public:
  /// Refuses what surface_traversal::make refuses, and a path that does not run here. Without a
  /// path: the one in use (batch::path_in_use, or the environment variable GRAZE_BATCH_PATH).
  /// `octree` must come from voxelizing the same surface in the same domain, and outlive this
  /// object.
  [[nodiscard]] static expected<lane_traversal> make(const F& surface, const box& domain,
                                                     const sparse_octree& octree, int level,
                                                     batch::path p = batch::path_in_use()) {
    if (const auto reason = batch::refusal(p))
      return unexpected{*reason};
    const auto checked = surface_traversal<F>::make(surface, domain, octree, level);
    if (!checked)
      return unexpected{checked.reason()};
    return lane_traversal(surface, domain, octree, level, p);
  }

  /// As surface_traversal::first_hit. Any rounding mode; any thread.
  [[nodiscard]] surface_hit first_hit(const ray& r, traversal_counts* counts = nullptr) const {
    return kernels_->first_hit(surface_, domain_, *octree_, level_, r, counts);
  }
  /// hits[i] = first_hit(rays[i]), sooner: rays are taken two in turn. As many hits as rays.
  void first_hits(std::span<const ray> rays, std::span<surface_hit> hits,
                  traversal_counts* counts = nullptr) const {
    assert(rays.size() == hits.size());
    kernels_->first_hits(surface_, domain_, *octree_, level_, rays.data(), rays.size(), hits.data(),
                         counts);
  }
  [[nodiscard]] int level() const { return level_; }

private:
  lane_traversal(const F& surface, const box& domain, const sparse_octree& octree, int level,
                 batch::path p)
      : surface_(surface), domain_(domain), octree_(&octree), level_(level),
        kernels_(&lane_kernels_of<F>(p)) {}

  F surface_;
  box domain_;
  const sparse_octree* octree_;
  int level_;
  const lane_kernels<F>* kernels_;
};

} // namespace graze::octree
