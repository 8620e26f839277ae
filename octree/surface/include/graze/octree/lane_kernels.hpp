#pragma once
/// First hits and voxelization of a surface, eight children or eight rays at a time, by the widest
/// instructions that the processor has: the results of surface_traversal, certified_traversal and
/// voxelize, bit for bit, sooner.
///
/// The kernels of the surfaces that are built in (surfaces.hpp) are in graze::octree. For a
/// surface of one's own: a file for each path, compiled for its instructions, that defines a table
/// by make_lane_kernels (lane_kernels_of_path.hpp), and a specialization of lane_kernels_of that
/// chooses among them; octree/surface/src/lanes is the model.
#include <graze/needs_cxx20.hpp>

#include <cassert>
#include <graze/batch.hpp>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/upward.hpp>
#include <span>
#include <tuple>

namespace graze::octree {

/// What a path has compiled for the surface F.
template <Surface F> struct lane_kernels {
  /// surface_traversal<F>::first_hit, for arguments that its make() accepts.
  surface_hit (*first_hit)(const F&, const box& domain, const sparse_octree&, int level, const ray&,
                           traversal_counts*);
  /// The same for `count` rays, two in turn; counts are added to.
  void (*first_hits)(const F&, const box& domain, const sparse_octree&, int level, const ray* rays,
                     std::size_t count, surface_hit* hits, traversal_counts*);
  /// certified_traversal<F>::first_hit of `count` rays, but for closer looks; `steps`, if any, is added
  /// to.
  void (*certified_hits)(const F&, const box& domain, const ray* rays, std::size_t count,
                         certified_hit* hits, std::uint64_t* steps);
  /// What scalar_judge says of an octant, and what voxelization adds below it. Within a scope of
  /// lane_judge.
  std::uint8_t (*open)(const F&, const box& domain, const cube& cell);
  leaf_children (*leaves)(const F&, const box& domain, const cube& cell);
  sparse_octree::builder::inner (*voxelize)(const F&, const box& domain, const cube& cell,
                                            int level, int last_level, sparse_octree::builder&);
};

namespace detail {
template <class... F>
std::tuple<lane_kernels<F>...> kernels_of(const std::tuple<built_in_surface<F>...>&);
/// The kernels of all surfaces that are built in.
using built_in_kernels = decltype(kernels_of(built_in_surfaces));
const built_in_kernels& built_in_kernels_of(batch::path p);
} // namespace detail

/// The path's kernels. The path must run here (batch::refusal). Specialized for surfaces that are
/// not built in.
template <Surface F> const lane_kernels<F>& lane_kernels_of(batch::path p) {
  return std::get<lane_kernels<F>>(detail::built_in_kernels_of(p));
}

/// The scalar backend beside the kernels, whose scope serves every path: embedded rounding looks at
/// no mode.
#if defined(__x86_64__)
using kernel_backend = rounding::upward;
#else
using kernel_backend = rounding::nearest;
#endif

/// scalar_judge's verdicts by a path's kernels. Models ChildrenJudge; a whole subtree is one call.
/// `f` must outlive it.
template <Surface F> class lane_judge {
public:
  using scope = typename kernel_backend::scope;
  using octant = cube;
  /// The path must run here (batch::refusal).
  lane_judge(const F& f, const box& domain, batch::path p = batch::path_in_use())
      : f_(&f), domain_(domain), kernels_(&lane_kernels_of<F>(p)) {}

  [[nodiscard]] std::uint8_t open(const cube& cell) const {
    return kernels_->open(*f_, domain_, cell);
  }
  [[nodiscard]] leaf_children leaves(const cube& cell) const {
    return kernels_->leaves(*f_, domain_, cell);
  }
  /// Adds all that is below an octant of `level`, and returns its node.
  sparse_octree::builder::inner voxelize(const cube& cell, int level, int last_level,
                                         sparse_octree::builder& out) const {
    return kernels_->voxelize(*f_, domain_, cell, level, last_level, out);
  }

private:
  const F* f_;
  box domain_;
  const lane_kernels<F>* kernels_;
};

/// voxelize(f, root, domain) by a path's kernels: the same octree, or the same refusal; and refuses
/// a path that does not run here. Any rounding mode; any thread.
template <Surface F>
[[nodiscard]] expected<sparse_octree> voxelize_in_lanes(const F& f, const root_cube& root,
                                                        const box& domain,
                                                        batch::path p = batch::path_in_use()) {
  if (const auto reason = batch::refusal(p))
    return unexpected{*reason};
  if (!detail::is_proper(domain))
    return unexpected{"domain is empty"};
  return voxelize_by(lane_judge<F>(f, domain, p), root);
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

/// certified_traversal<F> by a path's kernels, eight rays at a time. One indirect call a batch.
template <Surface F> class lane_certified_traversal {
public:
  /// Refuses what certified_traversal::make refuses, and a path that does not run here.
  [[nodiscard]] static expected<lane_certified_traversal>
  make(const F& surface, const box& domain, batch::path p = batch::path_in_use()) {
    if (const auto reason = batch::refusal(p))
      return unexpected{*reason};
    if (const auto checked = certified_traversal<F>::make(surface, domain); !checked)
      return unexpected{checked.reason()};
    return lane_certified_traversal(surface, domain, p);
  }

  /// hits[i] = certified_traversal::first_hit(rays[i]). As many hits as rays. Any rounding mode;
  /// any thread.
  void first_hits(std::span<const ray> rays, std::span<certified_hit> hits,
                  std::uint64_t* steps = nullptr) const {
    assert(rays.size() == hits.size());
    kernels_->certified_hits(surface_, domain_, rays.data(), rays.size(), hits.data(), steps);
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = looked_closer(surface_, rays[i], domain_, hits[i]);
  }

private:
  lane_certified_traversal(const F& surface, const box& domain, batch::path p)
      : surface_(surface), domain_(domain), kernels_(&lane_kernels_of<F>(p)) {}

  F surface_;
  box domain_;
  const lane_kernels<F>* kernels_;
};

} // namespace graze::octree
