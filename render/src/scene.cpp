#include <graze/render/scene.hpp>

#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/surfaces.hpp>
#include <vector>

namespace graze::render {
namespace {

template <class Surface> class surface_caster final : public caster {
public:
  using traversal = octree::lane_traversal<Surface>;

  /// The octree is built here, and the traversal refers to it.
  static expected<std::unique_ptr<caster>> make(const octree::box& domain, int octree_level,
                                                int levels) {
    auto tree = octree::voxelize_in_lanes(Surface{}, domain, octree_level);
    if (!tree)
      return unexpected{tree.reason()};
    auto kept = std::make_unique<const octree::sparse_octree>(*std::move(tree));
    auto work = traversal::make(Surface{}, domain, *kept, levels);
    if (!work)
      return unexpected{work.reason()};
    return std::unique_ptr<caster>(new surface_caster(std::move(kept), *std::move(work)));
  }

  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts) const override {
    work_.first_hits(rays, hits, counts);
  }
  vec3 gradient(const vec3& point) const override { return octree::normal(Surface{}, point); }
  std::uint64_t octree_leaves() const override { return tree_->leaf_count(); }

private:
  surface_caster(std::unique_ptr<const octree::sparse_octree> tree, traversal work)
      : tree_(std::move(tree)), work_(std::move(work)) {}

  std::unique_ptr<const octree::sparse_octree> tree_;
  traversal work_;
};

template <class Surface>
expected<std::unique_ptr<caster>> prepare(const scene& s, int octree_level, int levels) {
  return surface_caster<Surface>::make(s.domain, octree_level, levels);
}

constexpr octree::box symmetric(double half) { return {{-half, -half, -half}, {half, half, half}}; }

} // namespace

std::span<const scene> scenes() {
  static const std::vector<scene> table = {
      {"spheres",
       "nine spheres: (0,0,0) r 1; (1.75,0,0), (-1.75,.25,0), (0,1.75,.25), (0,-1.75,0), "
       "(.25,0,1.75), "
       "(0,0,-1.75) r .625; (1.25,1.25,1.25), (-1.25,-1.25,1.25) r .375",
       1.5,
       symmetric(2.5),
       {{0.80, 0.16, 0.10}},
       prepare<octree::spheres>},
      {"quartdef",
       "(x^2-1)^2+(y^2-1)^2+(z^2-1)^2-1",
       1.125,
       symmetric(1.5),
       {{0.10, 0.42, 0.75}},
       prepare<octree::quartdef>},
      {"tanglecube",
       "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8",
       2,
       symmetric(2.5),
       {{0.85, 0.50, 0.06}},
       prepare<octree::tanglecube>},
      {"holesrot",
       "x^3+y^3+z^3-x-y-z",
       2,
       symmetric(2),
       {{0.16, 0.55, 0.20}},
       prepare<octree::holesrot>},
  };
  return table;
}

const scene* find_scene(std::string_view name) {
  for (const scene& s : scenes())
    if (s.name == name)
      return &s;
  return nullptr;
}

std::string scene_names() {
  std::string names;
  for (const scene& s : scenes())
    names += (names.empty() ? "" : ", ") + s.name;
  return names;
}

} // namespace graze::render
