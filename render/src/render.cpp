#include <graze/render/render.hpp>

#include "shader.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <graze/support/threads.hpp>
#include <limits>
#include <mutex>

namespace graze::render {
namespace {

constexpr int tile_side = 32;

std::array<float, 3> narrow(const std::array<double, 3>& c) {
  return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

const pixel unfinished_pixel = {narrow(unfinished_colour), std::numeric_limits<float>::infinity(),
                                0};

/// One thread's part of the work, a tile at a time. Each pixel depends on nothing but its own rays,
/// and sums of integers and greatest numbers on no order, so that the order in which tiles are
/// taken cannot be seen. Its buffers are kept from tile to tile: given back to the system and asked
/// for again, they cost more than the rays.
class worker {
public:
  worker(const scene& s, const caster& surface, const settings& chosen, rendering& target,
         const std::atomic<bool>* stop)
      : scene_(s), surface_(surface, stop), settings_(chosen), target_(target),
        shader_(s, surface_, chosen), place_(target.part) {}

  /// `place` is relative to the rendering's part. False, and nothing is left of it, if the work was
  /// stopped.
  bool render(const window& place) {
    const tally before = counts_;
    look_at(place);
    if (!surface_.stopped())
      return true;
    counts_ = before;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      target_.pixels[at(k)] = unfinished_pixel;
      if (settings_.facts)
        target_.facts[at(k)] = {};
    }
    return false;
  }

  [[nodiscard]] const tally& counts() const { return counts_; }

private:
  void look_at(const window& place) {
    place_ = place;
    sums_.assign(place.size.count(), colour{});
    seen_.assign(place.size.count(), 0);
    colours_.resize(place.size.count());
    const int side = settings_.sampling;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const bool centre = 2 * i + 1 == side && 2 * j + 1 == side;
        cast(side, i, j, centre);
        shader_.look(rays_, hits_, colours_, counts_);
        for (std::size_t k = 0; k < sums_.size(); ++k) {
          if (scene_.transparent && sees_background(hits_[k].outcome))
            continue;
          ++seen_[k];
          for (std::size_t c = 0; c < 3; ++c)
            sums_[k][c] += colours_[k][c];
        }
        if (centre)
          note_facts();
      }
    if (side % 2 == 0) {
      cast(1, 0, 0, true);
      note_facts();
    }
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      for (double& c : sums_[k])
        c /= side * side;
      pixel& p = target_.pixels[at(k)];
      p.colour = narrow(sums_[k]);
      p.alpha = static_cast<float>(seen_[k]) / static_cast<float>(side * side);
    }
    counts_.pixels += sums_.size();
  }

  [[nodiscard]] bool sees_background(octree::verdict v) const {
    return octree::is_free(v) && (v == octree::verdict::miss || !settings_.show_gaps);
  }

  /// Casts ray (i, j) of side^2 of every pixel.
  void cast(int side, int i, int j, bool centre) {
    const window& part = target_.part;
    const extent& whole = target_.whole;
    rays_.clear();
    for (int row = 0; row < place_.size.height; ++row)
      for (int column = 0; column < place_.size.width; ++column)
        rays_.push_back(scene_.view.ray_through((part.column + place_.column + column) * side + i,
                                                (part.row + place_.row + row) * side + j,
                                                whole.width * side, whole.height * side));
    hits_.resize(rays_.size());
    counts_.camera_rays += rays_.size();
    if (!centre || !settings_.facts) {
      surface_.first_hits(rays_, hits_, &counts_.visited);
      return;
    }
    steps_.assign(rays_.size(), 0); // one by one: the same hits, and each ray's own count
    for (std::size_t k = 0; k < rays_.size() && !surface_.stopped(); ++k) {
      octree::traversal_counts own;
      surface_.whole().first_hits({&rays_[k], 1}, {&hits_[k], 1}, &own);
      steps_[k] = own.cells_opened;
      counts_.visited.cells_opened += own.cells_opened;
      counts_.visited.leaves_kept += own.leaves_kept;
    }
  }

  void note_facts() {
    if (settings_.facts) {
      proofs_.resize(rays_.size());
      surface_.whole().prove(rays_, hits_, proofs_);
    }
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const octree::surface_hit& h = hits_[k];
      const vec3& d = rays_[k].direction();
      const double unit = std::sqrt(detail::dot(d, d));
      constexpr float infinity = std::numeric_limits<float>::infinity();
      float& depth = target_.pixels[at(k)].depth;
      depth = infinity;
      switch (h.outcome) {
      case octree::verdict::miss:
        ++counts_.misses;
        break;
      case octree::verdict::pole:
        ++counts_.poles;
        break;
      case octree::verdict::jump:
        ++counts_.jumps;
        break;
      case octree::verdict::gap:
        ++counts_.gaps;
        break;
      case octree::verdict::undecided:
        ++counts_.undecided;
        depth = static_cast<float>(h.t_near * unit);
        break;
      case octree::verdict::hit:
        ++counts_.hits;
        depth = static_cast<float>(middle(h) * unit);
        break;
      }
      if (!settings_.facts)
        continue;
      pixel_facts& f = target_.facts[at(k)];
      f.verdict = static_cast<int>(h.outcome);
      f.proven = proofs_[k];
      f.direction = rays_[k].direction();
      f.steps = static_cast<std::uint32_t>(std::min<std::uint64_t>(steps_[k], ~std::uint32_t{0}));
      if (is_free(h.outcome))
        continue;
      // sqrt and products: 4 roundings, so 2^-24 more than covers them
      f.depth_width =
          std::nextafter(static_cast<float>((h.t_far - h.t_near) * unit * (1 + 0x1p-24)), infinity);
      if (h.t_far == h.t_near)
        f.depth_width = 0;
      if (h.outcome == octree::verdict::undecided)
        continue;
      const vec3 point = point_at(rays_[k], middle(h));
      f.normal = narrow(facing_normal(surface_.whole().gradient(point), d));
      f.object = static_cast<int>(object_at(scene_, point));
    }
  }

  /// The place of the tile's pixel k in the rendering.
  [[nodiscard]] std::size_t at(std::size_t k) const {
    const auto width = static_cast<std::size_t>(place_.size.width);
    const std::size_t row = static_cast<std::size_t>(place_.row) + k / width;
    return row * static_cast<std::size_t>(target_.part.size.width) +
           static_cast<std::size_t>(place_.column) + k % width;
  }

  const scene& scene_;
  interruptible_caster surface_;
  const settings& settings_;
  rendering& target_;
  shader shader_;
  tally counts_;
  window place_; ///< the tile in hand
  std::vector<colour> sums_, colours_;
  std::vector<int> seen_; ///< of a pixel's rays those that are in its sum
  std::vector<octree::ray> rays_;
  std::vector<octree::surface_hit> hits_;
  std::vector<std::uint64_t> steps_;
  std::vector<proof> proofs_;
};

} // namespace

namespace {
/// Part `index` of the floats whose sum is x: 24 bits each, so that three have all of it. What has no
/// float, since it is too small or too large, is rounded up, so that the sum is no less than x.
float part_up(double x, int index) {
  constexpr float greatest = std::numeric_limits<float>::max();
  for (int i = 0;; ++i) {
    float part = static_cast<float>(x);
    if (i == 2 && static_cast<double>(part) < x)
      part = std::nextafter(part, std::numeric_limits<float>::infinity());
    if (std::isinf(part) && std::isfinite(x))
      part = x > 0 ? part : -greatest; // infinity, or the rest is lost
    if (i == index)
      return part;
    x = std::isfinite(part) && part != -greatest ? x - static_cast<double>(part) : 0;
  }
}
float part_down(double x, int index) { return -part_up(-x, index); }
float float_up(double x) {
  const auto near = static_cast<float>(x);
  return static_cast<double>(near) < x
             ? std::nextafter(near, std::numeric_limits<float>::infinity())
             : near;
}
float float_down(double x) { return -float_up(-x); }
} // namespace

tally& tally::operator+=(const tally& part) {
  pixels += part.pixels;
  hits += part.hits;
  misses += part.misses;
  undecided += part.undecided;
  poles += part.poles;
  jumps += part.jumps;
  gaps += part.gaps;
  camera_rays += part.camera_rays;
  shadow_rays += part.shadow_rays;
  reflected_rays += part.reflected_rays;
  secondary_undecided += part.secondary_undecided;
  longest_shift = std::max(longest_shift, part.longest_shift);
  visited.cells_opened += part.visited.cells_opened;
  visited.leaves_kept += part.visited.leaves_kept;
  return *this;
}

rendering render_picture(const scene& s, const caster& surface, const settings& chosen,
                         const std::atomic<bool>* stop, const progress_report& report) {
  rendering result;
  result.whole = chosen.size;
  result.eye = s.view.eye;
  result.part = chosen.crop.value_or(window{0, 0, chosen.size});
  const std::size_t count = result.part.size.count();
  result.pixels.assign(count, unfinished_pixel);
  if (chosen.facts)
    result.facts.resize(count);

  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const extent& size = result.part.size;
  const int across = (size.width + tile_side - 1) / tile_side,
            down = (size.height + tile_side - 1) / tile_side;
  const auto place_of = [&](int tile) {
    const int left = tile % across * tile_side, top = tile / across * tile_side;
    return window{left,
                  top,
                  {std::min(tile_side, size.width - left), std::min(tile_side, size.height - top)}};
  };
  std::atomic<int> next{0};
  std::atomic<std::uint64_t> done{0};
  std::atomic<bool> failed{false};
  std::mutex merging;
  const auto take_tiles = [&] {
    worker mine(s, surface, chosen, result, stop);
    for (int tile = next++; tile < across * down && !failed; tile = next++) {
      const window place = place_of(tile);
      if (!mine.render(place))
        break;
      done.fetch_add(place.size.count(), std::memory_order_relaxed);
    }
    const std::lock_guard lock(merging);
    result.counts += mine.counts();
  };
  support::thread_group workers(chosen.threads, take_tiles, [&failed] { failed = true; });
  while (!workers.wait_for(std::chrono::milliseconds(100)))
    if (report)
      report(done.load(std::memory_order_relaxed), count, elapsed());
  workers.join();
  result.seconds = elapsed();
  result.complete = result.counts.pixels == count;
  return result;
}

picture to_picture(const rendering& result, bool transparent) {
  const window& part = result.part;
  picture image{part.size.width,    part.size.height,   {}, {}, part.column, part.row,
                result.whole.width, result.whole.height};
  const auto add = [&image](std::string name, const auto& pixels, const auto& value_of) {
    channel& c = image.channels.emplace_back();
    c.name = std::move(name);
    c.values.reserve(pixels.size());
    for (const auto& p : pixels)
      c.values.push_back(static_cast<float>(value_of(p)));
  };
  add("R", result.pixels, [](const pixel& p) { return p.colour[0]; });
  add("G", result.pixels, [](const pixel& p) { return p.colour[1]; });
  add("B", result.pixels, [](const pixel& p) { return p.colour[2]; });
  if (transparent)
    add("A", result.pixels, [](const pixel& p) { return p.alpha; });
  add("Z", result.pixels, [](const pixel& p) { return p.depth; });
  if (result.facts.empty())
    return image;
  using facts = pixel_facts;
  add("depth.width", result.facts, [](const facts& f) { return f.depth_width; });
  add("normal.X", result.facts, [](const facts& f) { return f.normal[0]; });
  add("normal.Y", result.facts, [](const facts& f) { return f.normal[1]; });
  add("normal.Z", result.facts, [](const facts& f) { return f.normal[2]; });
  add("object.id", result.facts, [](const facts& f) { return f.object; });
  add("verdict.code", result.facts, [](const facts& f) { return f.verdict; });
  add("steps.octants", result.facts, [](const facts& f) { return f.steps; });
  for (const int i : {0, 1, 2}) {
    add(fmt::format("depth.lower.{}", i + 1), result.facts,
        [i](const facts& f) { return part_down(f.proven.depth_lower, i); });
    add(fmt::format("depth.upper.{}", i + 1), result.facts,
        [i](const facts& f) { return part_up(f.proven.depth_upper, i); });
  }
  for (const std::size_t a : {0u, 1u, 2u}) {
    add(fmt::format("normal.lower.{}", "XYZ"[a]), result.facts,
        [a](const facts& f) { return float_down(f.proven.normal.lo[a]); });
    add(fmt::format("normal.upper.{}", "XYZ"[a]), result.facts,
        [a](const facts& f) { return float_up(f.proven.normal.hi[a]); });
  }
  return image;
}

} // namespace graze::render
