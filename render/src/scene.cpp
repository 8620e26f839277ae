#include <graze/render/scene.hpp>

#include <algorithm>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/surfaces.hpp>

namespace graze::render {
namespace {

/// A secondary ray that would have to begin further away from its hit is not cast.
double longest_shift(const octree::box& domain) {
  double side = 0;
  for (std::size_t a = 0; a < 3; ++a)
    side = std::max(side, domain.hi[a] - domain.lo[a]);
  return 0x1p-10 * side;
}

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
    return std::unique_ptr<caster>(new surface_caster(std::move(kept), *std::move(work), domain));
  }

  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts) const override {
    work_.first_hits(rays, hits, counts);
  }
  vec3 gradient(const vec3& point) const override { return octree::normal(Surface{}, point); }
  void depart(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
              std::span<departure> departures) const override {
    [[maybe_unused]] const backend::scope scope;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i].outcome == octree::verdict::hit)
        departures[i] =
            render::depart<Surface, backend>(Surface{}, domain_, rays[i], hits[i], longest_);
  }
  std::size_t object_at(const vec3&) const override { return 0; }
  std::uint64_t octree_leaves() const override { return tree_->leaf_count(); }

private:
  using backend = octree::kernel_backend;

  surface_caster(std::unique_ptr<const octree::sparse_octree> tree, traversal work,
                 const octree::box& domain)
      : tree_(std::move(tree)), work_(std::move(work)), domain_(domain),
        longest_(longest_shift(domain)) {}

  std::unique_ptr<const octree::sparse_octree> tree_;
  traversal work_;
  octree::box domain_;
  double longest_;
};

template <class Surface>
expected<std::unique_ptr<caster>> prepare(const scene& s, int octree_level, int levels) {
  return surface_caster<Surface>::make(s.domain, octree_level, levels);
}

template <class Surface>
scene standard(const char* name, const char* formula, double scale, double half,
               const colour& body) {
  return {name,
          formula,
          {{-half, -half, -half}, {half, half, half}},
          camera::standard(scale),
          standard_lights(scale),
          {{name, {body}}},
          default_background,
          prepare<Surface>};
}

} // namespace

std::span<const scene> scenes() {
  static const std::vector<scene> table = {
      standard<octree::spheres>(
          "spheres",
          "nine spheres: (0,0,0) r 1; (1.75,0,0), (-1.75,.25,0), (0,1.75,.25), (0,-1.75,0), "
          "(.25,0,1.75), (0,0,-1.75) r .625; (1.25,1.25,1.25), (-1.25,-1.25,1.25) r .375",
          1.5, 2.5, {0.80, 0.16, 0.10}),
      standard<octree::quartdef>("quartdef", "(x^2-1)^2+(y^2-1)^2+(z^2-1)^2-1", 1.125, 1.5,
                                 {0.10, 0.42, 0.75}),
      standard<octree::tanglecube>("tanglecube", "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8", 2, 2.5,
                                   {0.85, 0.50, 0.06}),
      standard<octree::holesrot>("holesrot", "x^3+y^3+z^3-x-y-z", 2, 2, {0.16, 0.55, 0.20}),
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
