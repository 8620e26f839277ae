#pragma once
/// What a batch of rays sees: light, shadows and reflections.
#include <graze/render/render.hpp>

namespace graze::render {

/// A caster whose batches end soon after `stop` is set. One a thread.
class interruptible_caster {
public:
  interruptible_caster(const caster& whole, const std::atomic<bool>* stop)
      : whole_(whole), stop_(stop) {}

  [[nodiscard]] const caster& whole() const { return whole_; }
  [[nodiscard]] bool stopped() const {
    return stop_ != nullptr && stop_->load(std::memory_order_relaxed);
  }
  /// caster::first_hits; once stopped, the rays that are left are misses.
  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts);

private:
  const caster& whole_;
  const std::atomic<bool>* stop_;
  std::size_t at_once_ = 8; ///< as many rays as take a few milliseconds
};

/// Follows a batch of rays, and the batches of shadow rays and of reflected rays that come of it.
/// What becomes of a ray depends on nothing but the ray. One a thread: it keeps its buffers.
class shader {
public:
  shader(const scene& s, interruptible_caster& surface, const settings& chosen)
      : scene_(s), surface_(surface), mode_(chosen.mode),
        behind_gaps_(chosen.show_gaps ? gap_colour : s.background) {}

  /// The colours of what the rays see, given their first hits. As many of each.
  void look(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
            std::span<colour> colours, tally& counts);

private:
  /// A proven hit whose colour is sought.
  struct seen {
    std::size_t pixel; ///< in look's spans
    double weight;     ///< of what is seen in the pixel's colour
    octree::ray ray;
    octree::surface_hit hit;
    vec3 point, normal;
    bool inside; ///< from f < 0
    std::size_t object;
    departure from;
    std::uint64_t shadowed; ///< bit i: light i is proven to be hidden
  };

  void sort(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
            std::span<const std::size_t> pixels, std::span<const double> weights,
            std::span<colour> colours);
  void find_departures(tally& counts);
  void find_shadows(tally& counts);
  void reflect(std::span<colour> colours, bool last, tally& counts);

  const scene& scene_;
  interruptible_caster& surface_;
  mode mode_;
  colour behind_gaps_; ///< what is seen along rays that end in a pole, a jump or a gap
  std::vector<seen> seen_;
  // Of the batch that is followed.
  std::vector<octree::ray> rays_;
  std::vector<octree::surface_hit> hits_;
  std::vector<std::size_t> pixels_;
  std::vector<double> weights_;
  std::vector<departure> departures_;
};

/// o + t d, rounded.
inline vec3 point_at(const octree::ray& r, double t) {
  vec3 p;
  for (std::size_t a = 0; a < 3; ++a)
    p[a] = r.origin()[a] + t * r.direction()[a];
  return p;
}
/// The middle of a hit's enclosure.
inline double middle(const octree::surface_hit& h) { return h.t_near + (h.t_far - h.t_near) / 2; }

} // namespace graze::render
