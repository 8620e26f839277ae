#pragma once
/// What casters have in common, whatever finds their first hits.
#include <algorithm>
#include <array>
#include <graze/octree/lane_kernels.hpp>
#include <graze/render/scene.hpp>
#include <optional>
#include <vector>

namespace graze::render {

expected<std::unique_ptr<caster>> prepare_built_in(const scene& s, int octree_level, int levels,
                                                   method by);

/// A secondary ray that would have to begin further away from its hit is not cast.
inline double longest_shift(const octree::box& domain) {
  double side = 0;
  for (std::size_t a = 0; a < 3; ++a)
    side = std::max(side, domain.hi[a] - domain.lo[a]);
  return 0x1p-10 * side;
}

/// A surface whose kernels are compiled for the lanes, and its octree, if the method needs one.
template <octree::Surface F> class lane_caster final : public caster {
public:
  using traversal = octree::lane_traversal<F>;
  using certified_traversal = octree::lane_certified_traversal<F>;
  using backend = octree::kernel_backend;

  /// The octree is built here, and the traversal refers to it.
  static expected<std::unique_ptr<lane_caster>> make(const F& f, const octree::box& domain,
                                                     int octree_level, int levels, method by) {
    if (by == method::certified) {
      auto along = certified_traversal::make(f, domain);
      if (!along)
        return unexpected{along.reason()};
      return std::unique_ptr<lane_caster>(
          new lane_caster(f, domain, nullptr, std::nullopt, *std::move(along)));
    }
    auto tree = octree::voxelize_in_lanes(f, domain, octree_level);
    if (!tree)
      return unexpected{tree.reason()};
    auto kept = std::make_unique<const octree::sparse_octree>(*std::move(tree));
    auto work = traversal::make(f, domain, *kept, levels);
    if (!work)
      return unexpected{work.reason()};
    return std::unique_ptr<lane_caster>(
        new lane_caster(f, domain, std::move(kept), *std::move(work), std::nullopt));
  }

  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts) const override {
    if (work_) {
      work_->first_hits(rays, hits, counts);
      return;
    }
    std::array<octree::certified_hit, 256> found;
    for (std::size_t from = 0; from < rays.size(); from += found.size()) {
      const std::size_t count = std::min(found.size(), rays.size() - from);
      along_->first_hits(rays.subspan(from, count), {found.data(), count},
                         counts != nullptr ? &counts->cells_opened : nullptr);
      for (std::size_t i = 0; i < count; ++i)
        hits[from + i] = {found[i].outcome, found[i].t_near, found[i].t_far, {{}, 0}, false};
    }
  }
  vec3 gradient(const vec3& point) const override { return octree::normal(f_, point); }
  void depart(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
              std::span<departure> departures) const override {
    [[maybe_unused]] const backend::scope scope;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i].outcome == octree::verdict::hit)
        departures[i] = render::depart<F, backend>(f_, domain_, rays[i], hits[i], longest_);
  }
  std::size_t object_at(const vec3&) const override { return 0; }
  std::uint64_t octree_leaves() const override { return tree_ ? tree_->leaf_count() : 0; }

private:
  lane_caster(const F& f, const octree::box& domain,
              std::unique_ptr<const octree::sparse_octree> tree, std::optional<traversal> work,
              std::optional<certified_traversal> along)
      : f_(f), domain_(domain), longest_(longest_shift(domain)), tree_(std::move(tree)),
        work_(std::move(work)), along_(std::move(along)) {}

  const F f_;
  const octree::box domain_;
  const double longest_;
  std::unique_ptr<const octree::sparse_octree> tree_;
  std::optional<traversal> work_; ///< one of the two
  std::optional<certified_traversal> along_;
};

} // namespace graze::render
