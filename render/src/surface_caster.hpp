#pragma once
/// Rays at one surface, by the kernels that are compiled for it.
#include <algorithm>
#include <array>
#include <graze/octree_formula/lane_kernels.hpp>
#include <graze/render/scene.hpp>
#include <optional>
#include <vector>

namespace graze::render {

/// A secondary ray that would have to begin further away from its hit is not cast.
inline double longest_shift(const octree::box& domain) {
  double side = 0;
  for (std::size_t a = 0; a < 3; ++a)
    side = std::max(side, domain.hi[a] - domain.lo[a]);
  return 0x1p-10 * side;
}

/// A surface whose kernels are compiled for the lanes, and its octree, if the method needs one. Of a
/// source (scene_surface.hpp), which is kept, since its surface may refer to it.
template <class Source> class surface_caster final : public caster {
public:
  using surface = decltype(std::declval<const Source&>().surface());
  using traversal = octree::lane_traversal<surface>;
  using certified_traversal = octree::lane_certified_traversal<surface>;
  using backend = octree::kernel_backend;

  /// The octree is built here, and the traversal refers to it.
  static expected<std::unique_ptr<caster>> make(const Source& source, const octree::box& domain,
                                                int octree_level, int levels, method search) {
    const surface f = source.surface();
    if (search == method::certified) {
      auto along = certified_traversal::make(f, domain);
      if (!along)
        return unexpected{along.reason()};
      return std::unique_ptr<caster>(
          new surface_caster(source, domain, nullptr, std::nullopt, *std::move(along)));
    }
    auto tree = octree::voxelize_in_lanes(f, domain, octree_level);
    if (!tree)
      return unexpected{tree.reason()};
    auto kept = std::make_unique<const octree::sparse_octree>(*std::move(tree));
    auto descent = traversal::make(f, domain, *kept, levels);
    if (!descent)
      return unexpected{descent.reason()};
    return std::unique_ptr<caster>(
        new surface_caster(source, domain, std::move(kept), *std::move(descent), std::nullopt));
  }

  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts) const override {
    if (descent_) {
      descent_->first_hits(rays, hits, counts);
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
  vec3 gradient(const vec3& point) const override {
    return octree::normal(source_.surface(), point);
  }
  void depart(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
              std::span<departure> departures) const override {
    const surface f = source_.surface();
    [[maybe_unused]] const backend::scope scope;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i].outcome == octree::verdict::hit)
        departures[i] = render::depart<surface, backend>(f, domain_, rays[i], hits[i], longest_);
  }
  void prove(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
             std::span<proof> proofs) const override {
    const surface f = source_.surface();
    [[maybe_unused]] const backend::scope scope;
    for (std::size_t i = 0; i < rays.size(); ++i)
      proofs[i] = render::prove<surface, backend>(f, rays[i], hits[i]);
  }
  std::uint64_t octree_leaves() const override { return tree_ ? tree_->leaf_count() : 0; }

private:
  surface_caster(const Source& source, const octree::box& domain,
                 std::unique_ptr<const octree::sparse_octree> tree,
                 std::optional<traversal> descent, std::optional<certified_traversal> along)
      : source_(source), domain_(domain), longest_(longest_shift(domain)), tree_(std::move(tree)),
        descent_(std::move(descent)), along_(std::move(along)) {}

  const Source source_;
  const octree::box domain_;
  const double longest_;
  std::unique_ptr<const octree::sparse_octree> tree_;
  std::optional<traversal> descent_; ///< one of the two
  std::optional<certified_traversal> along_;
};

} // namespace graze::render
