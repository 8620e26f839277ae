#include <graze/render/render.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>

namespace graze::render {
namespace {

constexpr int tile_side = 32;

/// What all threads share. Each pixel depends on nothing but its own ray, so that the order in
/// which tiles are taken cannot be seen in the result.
class tile_loop {
public:
  tile_loop(const scene& s, const caster& work, rendering& target, const std::atomic<bool>* stop)
      : view_(s.view()), lights_(s.lights()), look_(s.look), work_(work), target_(target),
        stop_(stop), tiles_a_row_((target.size + tile_side - 1) / tile_side) {}

  /// Takes tiles until there are none, or until it is told to stop.
  void run() {
    tally counts;
    while (!stopped()) {
      const int tile = next_tile_.fetch_add(1, std::memory_order_relaxed);
      if (tile >= tiles_a_row_ * tiles_a_row_)
        break;
      const int left = tile % tiles_a_row_ * tile_side;
      const int top = tile / tiles_a_row_ * tile_side;
      const std::uint64_t before = counts.rays;
      cast_tile(left, top, counts);
      rays_done_.fetch_add(counts.rays - before, std::memory_order_relaxed);
    }
    const std::lock_guard lock(mutex_);
    add(counts);
    ++finished_;
    all_finished_.notify_one();
  }

  /// Waits until `threads` calls of run() have ended; calls tick about ten times a second.
  template <class Tick> void wait_for(unsigned threads, Tick tick) {
    std::unique_lock lock(mutex_);
    while (!all_finished_.wait_for(lock, std::chrono::milliseconds(100),
                                   [&] { return finished_ == threads; })) {
      lock.unlock();
      tick(rays_done_.load(std::memory_order_relaxed));
      lock.lock();
    }
  }

private:
  [[nodiscard]] bool stopped() const {
    return stop_ != nullptr && stop_->load(std::memory_order_relaxed);
  }

  /// All rays of a tile at once: the traversal takes several in turn.
  void cast_tile(int left, int top, tally& counts) const {
    const int right = std::min(left + tile_side, target_.size);
    const int bottom = std::min(top + tile_side, target_.size);
    std::vector<octree::ray> rays;
    rays.reserve(static_cast<std::size_t>(tile_side) * tile_side);
    for (int row = top; row < bottom; ++row)
      for (int column = left; column < right; ++column)
        rays.push_back(view_.ray_through(column, row, target_.size));
    std::vector<octree::surface_hit> hits(rays.size());
    work_.first_hits(rays, hits, &counts.visited);
    std::size_t k = 0;
    for (int row = top; row < bottom; ++row)
      for (int column = left; column < right; ++column, ++k)
        target_.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(target_.size) +
                       static_cast<std::size_t>(column)] = lit(rays[k], hits[k], counts);
  }

  pixel lit(const octree::ray& r, const octree::surface_hit& found, tally& counts) const {
    ++counts.rays;
    const vec3& d = r.direction();
    const auto depth_at = [&](double t) {
      return static_cast<float>(t * std::sqrt(detail::dot(d, d)));
    };
    switch (found.outcome) {
    case octree::verdict::miss:
      ++counts.misses;
      return {narrow(background), std::numeric_limits<float>::infinity()};
    case octree::verdict::undecided:
      ++counts.undecided;
      return {narrow(undecided_colour), depth_at(found.t_near)};
    case octree::verdict::hit:
      break;
    }
    ++counts.hits;
    const double t = found.t_near + (found.t_far - found.t_near) / 2;
    vec3 point;
    for (int a = 0; a < 3; ++a)
      point[a] = r.origin()[a] + t * d[a];
    return {narrow(shade(look_, point, work_.gradient(point), d, lights_)), depth_at(t)};
  }

  static std::array<float, 3> narrow(const colour& c) {
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
  }

  void add(const tally& part) {
    tally& sum = target_.counts;
    sum.rays += part.rays;
    sum.hits += part.hits;
    sum.misses += part.misses;
    sum.undecided += part.undecided;
    sum.visited.cells_opened += part.visited.cells_opened;
    sum.visited.leaves_kept += part.visited.leaves_kept;
  }

  const camera view_;
  const std::array<light, 2> lights_;
  const material look_;
  const caster& work_;
  rendering& target_;
  const std::atomic<bool>* stop_;
  const int tiles_a_row_;
  std::atomic<int> next_tile_{0};
  std::atomic<std::uint64_t> rays_done_{0};
  std::mutex mutex_;
  std::condition_variable all_finished_;
  unsigned finished_ = 0;
};

} // namespace

rendering cast(const scene& s, const caster& work, const settings& how,
               const std::atomic<bool>* stop, const progress_report& report) {
  rendering result;
  result.size = how.size;
  const std::size_t count = static_cast<std::size_t>(how.size) * static_cast<std::size_t>(how.size);
  pixel unfinished{{}, std::numeric_limits<float>::infinity()};
  for (std::size_t c = 0; c < 3; ++c)
    unfinished.colour[c] = static_cast<float>(unfinished_colour[c]);
  result.pixels.assign(count, unfinished);

  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  tile_loop loop(s, work, result, stop);
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < how.threads; ++i)
    threads.emplace_back([&loop] { loop.run(); });
  loop.wait_for(how.threads, [&](std::uint64_t done) {
    if (report)
      report(done, count, elapsed());
  });
  threads.clear(); // joins
  result.seconds = elapsed();
  result.complete = result.counts.rays == count;
  return result;
}

picture to_picture(const rendering& result) {
  picture image{result.size, result.size, {{"R", {}}, {"G", {}}, {"B", {}}, {"Z", {}}}, {}};
  for (channel& c : image.channels)
    c.values.reserve(result.pixels.size());
  for (const pixel& p : result.pixels) {
    for (std::size_t c = 0; c < 3; ++c)
      image.channels[c].values.push_back(p.colour[c]);
    image.channels[3].values.push_back(p.depth);
  }
  return image;
}

} // namespace graze::render
