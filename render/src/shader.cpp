#include "shader.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace graze::render {
namespace {

using octree::verdict;

void add(colour& sum, double weight, const colour& part) {
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] += weight * part[c];
}

vec3 difference(const vec3& a, const vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

} // namespace

void interruptible_caster::first_hits(std::span<const octree::ray> rays,
                                      std::span<octree::surface_hit> hits,
                                      octree::traversal_counts* counts) {
  using clock = std::chrono::steady_clock;
  constexpr std::size_t least = 8, most = 1024; // a tile's
  constexpr auto quick = std::chrono::milliseconds(10), slow = std::chrono::milliseconds(50);
  while (!rays.empty() && !stopped()) {
    const std::size_t count = std::min(at_once_, rays.size());
    const auto start = clock::now();
    whole_.first_hits(rays.first(count), hits.first(count), counts);
    const auto taken = clock::now() - start;
    if (taken < quick)
      at_once_ = std::min(2 * at_once_, most);
    else if (taken > slow)
      at_once_ = std::max(at_once_ / 2, least);
    rays = rays.subspan(count);
    hits = hits.subspan(count);
  }
  std::fill(hits.begin(), hits.end(), octree::surface_hit{verdict::miss, 0, 0, {{}, 0}, false});
}

void shader::look(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
                  std::span<colour> colours, tally& counts) {
  std::fill(colours.begin(), colours.end(), colour{});
  pixels_.resize(rays.size());
  for (std::size_t i = 0; i < pixels_.size(); ++i)
    pixels_[i] = i;
  weights_.assign(rays.size(), 1.0);
  sort(rays, hits, pixels_, weights_, colours);
  for (int reflections = 0; !seen_.empty(); ++reflections) {
    if (mode_ == mode::trace) {
      find_departures(counts);
      find_shadows(counts);
    }
    reflect(colours, mode_ == mode::cast || reflections == most_reflections, counts);
    if (rays_.empty())
      return;
    hits_.resize(rays_.size());
    surface_.first_hits(rays_, hits_, &counts.visited);
    counts.reflected_rays += rays_.size();
    counts.secondary_undecided += static_cast<std::uint64_t>(
        std::count_if(hits_.begin(), hits_.end(), [](const octree::surface_hit& h) {
          return h.outcome == verdict::undecided;
        }));
    sort(rays_, hits_, pixels_, weights_, colours);
  }
}

/// Colours the rays that end in nothing, and lists the hits.
void shader::sort(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
                  std::span<const std::size_t> pixels, std::span<const double> weights,
                  std::span<colour> colours) {
  seen_.clear();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    switch (hits[i].outcome) {
    case verdict::miss:
      add(colours[pixels[i]], weights[i], scene_.background);
      break;
    case verdict::pole:
    case verdict::jump:
    case verdict::gap:
      add(colours[pixels[i]], weights[i], behind_gaps_);
      break;
    case verdict::undecided:
      add(colours[pixels[i]], weights[i], undecided_colour);
      break;
    case verdict::hit: {
      const vec3 point = point_at(rays[i], middle(hits[i])), &direction = rays[i].direction();
      const vec3 gradient = surface_.whole().gradient(point);
      seen_.emplace_back(pixels[i], weights[i], rays[i], hits[i], point,
                         facing_normal(gradient, direction), detail::dot(gradient, direction) > 0,
                         object_at(scene_, point), departure{}, 0);
    }
    }
  }
}

void shader::find_departures(tally& counts) {
  rays_.clear();
  hits_.clear();
  for (const seen& s : seen_) {
    rays_.push_back(s.ray);
    hits_.push_back(s.hit);
  }
  departures_.resize(seen_.size());
  surface_.whole().depart(rays_, hits_, departures_);
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    seen_[i].from = departures_[i];
    if (departures_[i].proven)
      counts.longest_shift = std::max(counts.longest_shift, departures_[i].shift);
  }
}

/// A light on the other side of the tangent plane gives nothing in any case; shade() says so.
void shader::find_shadows(tally& counts) {
  for (std::size_t l = 0; l < scene_.lights.size(); ++l) {
    rays_.clear();
    pixels_.clear();
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const seen& s = seen_[i];
      const vec3& lamp = scene_.lights[l].position;
      if (!(detail::dot(s.normal, difference(lamp, s.point)) > 0))
        continue;
      // t = 1 is the light
      const auto towards = octree::ray::make(s.from.point, difference(lamp, s.from.point));
      if (!s.from.proven || !towards) {
        ++counts.secondary_undecided;
        continue;
      }
      rays_.push_back(*towards);
      pixels_.push_back(i);
    }
    hits_.resize(rays_.size());
    surface_.first_hits(rays_, hits_, &counts.visited);
    counts.shadow_rays += rays_.size();
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const octree::surface_hit& h = hits_[k];
      if (h.outcome == verdict::hit && h.t_far < 1)
        seen_[pixels_[k]].shadowed |= std::uint64_t{1} << l;
      else if (!is_free(h.outcome) && h.t_near <= 1)
        ++counts.secondary_undecided;
    }
  }
}

/// Adds the hits' own colours and makes the next batch, the rays that they reflect, if not `last`.
void shader::reflect(std::span<colour> colours, bool last, tally& counts) {
  rays_.clear();
  pixels_.clear();
  weights_.clear();
  for (const seen& s : seen_) {
    const material& look = scene_.objects[s.object].look;
    const bool mirrors = !last && look.reflection > 0;
    const colour& body = s.inside && look.inside ? *look.inside : look.body;
    const colour own = shade(look, body, s.point, s.normal, s.ray.direction(), scene_.lights,
                             [&](std::size_t l) { return (s.shadowed >> l & 1) != 0; });
    add(colours[s.pixel], mirrors ? s.weight * (1 - look.reflection) : s.weight, own);
    if (!mirrors)
      continue;
    const double weight = s.weight * look.reflection;
    const auto next = octree::ray::make(s.from.point, reflected(s.ray.direction(), s.normal));
    if (!s.from.proven || !next) {
      ++counts.secondary_undecided;
      add(colours[s.pixel], weight, undecided_colour);
      continue;
    }
    rays_.push_back(*next);
    pixels_.push_back(s.pixel);
    weights_.push_back(weight);
  }
}

} // namespace graze::render
