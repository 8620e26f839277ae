#pragma once
/// Rays through a voxel_set: all occupied voxels on a ray, in order, by callback or as a range; the
/// first one; a segment of the ray; batches of rays.
///
/// Eight lanes of AVX-512, four of AVX2 or the baseline, chosen at run time as for batches
/// (graze::batch::force_path and GRAZE_BATCH_PATH force one); the verdicts are the same on all. The
/// loops are compiled in the library and fill a buffer: a call through a pointer for a buffer, none
/// for a voxel, and callbacks run in the caller's own rounding mode.
///
/// A voxel is reported if the ray {o + t d : t >= 0}, its segment, or a segment between two points
///   conservative, closed   may touch the closed voxel: never one too few, rarely one too many;
///   conservative, owned    may have a point in the half-open voxel: likewise;
///   exact, closed          touches the closed voxel: never one too few, never one too many;
///   exact, owned           has a point in the half-open voxel (closed at the far faces of the root
///                          or grid, and where a grid is flat).
/// When it is in a voxel, by which face it enters, and on what length: exact_line.hpp, asked of
/// voxel_set::cell; a walk does not pay for it.
/// Owned voxels come front to back. Closed ones come in the order of their indices, each axis taken
/// in the direction of the ray, node by node; that is front to back but for those touched in
/// common.
#include <graze/needs_cxx20.hpp>

#include <cstddef>
#include <graze/octree/exact_line.hpp>
#include <graze/octree/voxel_rays_state.hpp>
#include <graze/octree/voxel_set.hpp>
#include <iterator>
#include <optional>
#include <span>

namespace graze::octree {

namespace detail {
/// The kernels of the path in use, for the planes of this set.
const voxel_rays_walk& voxel_rays_kernels(const voxel_set& set);
/// Sets what depends on the set, and what is asked.
void prepare(voxel_rays_state& s, const voxel_set& set, convention rule, exactness certainty,
             const ray_segment& segment, bool soonest);
inline void set_line(voxel_rays_state& s, const ray& r) {
  for (unsigned a = 0; a < 3; ++a) {
    s.origin[a] = r.origin()[a];
    s.direction[a] = r.direction()[a];
  }
}
inline void set_line(voxel_rays_state& s, const segment& between) {
  for (unsigned a = 0; a < 3; ++a) {
    s.origin[a] = between.from()[a];
    s.direction[a] = between.to()[a];
  }
  s.between_points = true;
  s.first = 0;
  s.last = 1;
}

template <class Line>
std::uint64_t count_voxels(const voxel_set& set, std::span<const Line> lines, convention rule,
                           exactness certainty, std::span<std::uint32_t> counts,
                           const ray_segment& part) {
  const voxel_rays_walk& kernels = voxel_rays_kernels(set);
  voxel_rays_state state;
  prepare(state, set, rule, certainty, part, false);
  std::uint64_t opened = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    set_line(state, lines[i]);
    counts[i] = kernels.count(state);
    opened += state.opened;
  }
  return opened;
}
template <class Line, class Visit>
std::uint64_t visit_voxels(const voxel_set& set, std::span<const Line> lines, convention rule,
                           exactness certainty, const ray_segment& part, Visit&& visit) {
  const voxel_rays_walk& kernels = voxel_rays_kernels(set);
  std::array<voxel, 128> found;
  voxel_rays_state state;
  prepare(state, set, rule, certainty, part, false);
  std::uint64_t opened = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    set_line(state, lines[i]);
    for (std::size_t n = kernels.begin(state, found.data(), found.size()); n != 0;
         n = state.ended() ? 0 : kernels.fill(state, found.data(), found.size()))
      visit(i, std::span<const voxel>(found.data(), n));
    opened += state.opened;
  }
  return opened;
}
} // namespace detail

/// A walk through the occupied voxels on a ray: a generator whose whole state is in the object
/// (about 60 KB, of which few are used); nothing is allocated. The set must outlive it; it is not
/// copied or moved. With `soonest` the first voxels come after the least work; without, all do.
class voxel_walk {
public:
  voxel_walk(const voxel_set& set, const ray& r, convention rule = convention::owned,
             exactness certainty = exactness::exact, const ray_segment& segment = {},
             bool soonest = false)
      : kernels_(&detail::voxel_rays_kernels(set)) {
    detail::prepare(state_, set, rule, certainty, segment, soonest);
    detail::set_line(state_, r);
  }
  /// From one point to another.
  voxel_walk(const voxel_set& set, const segment& between, convention rule = convention::owned,
             exactness certainty = exactness::exact, bool soonest = false)
      : kernels_(&detail::voxel_rays_kernels(set)) {
    detail::prepare(state_, set, rule, certainty, {}, soonest);
    detail::set_line(state_, between);
  }
  voxel_walk(const voxel_walk&) = delete;
  voxel_walk& operator=(const voxel_walk&) = delete;

  /// Writes the next voxels, 64 at least to ask for; none means that there are no more.
  std::size_t next(std::span<voxel> out) {
    if (begun_)
      return state_.ended() ? 0 : kernels_->fill(state_, out.data(), out.size());
    begun_ = true;
    return kernels_->begin(state_, out.data(), out.size());
  }
  /// Nodes opened so far.
  [[nodiscard]] std::uint64_t opened() const { return begun_ ? state_.opened : 0; }

  class iterator {
  public:
    using value_type = voxel;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::input_iterator_tag;
    iterator() = default;
    explicit iterator(voxel_walk& w) : walk_(&w) {}
    const voxel& operator*() const { return walk_->buffer_[walk_->at_]; }
    iterator& operator++() {
      if (++walk_->at_ == walk_->held_)
        walk_->refill();
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const iterator& i, std::default_sentinel_t) { return i.ended(); }

  private:
    [[nodiscard]] bool ended() const { return walk_->held_ == 0; }
    voxel_walk* walk_ = nullptr;
  };
  /// A single pass: begins where the walk is.
  iterator begin() {
    refill();
    return iterator(*this);
  }
  static std::default_sentinel_t end() { return std::default_sentinel; }

private:
  void refill() {
    held_ = next(buffer_);
    at_ = 0;
  }
  const detail::voxel_rays_walk* kernels_;
  detail::voxel_rays_state state_;
  bool begun_ = false;
  std::size_t held_ = 0, at_ = 0;
  std::array<voxel, 128> buffer_;
};

namespace detail {
template <class Visit> bool visit_all(voxel_walk& walk, Visit& visit) {
  std::array<voxel, 128> found;
  while (const std::size_t n = walk.next(found))
    for (std::size_t i = 0; i < n; ++i)
      if (visit(found[i]))
        return true;
  return false;
}
inline std::optional<voxel> first_of(voxel_walk& walk) {
  std::array<voxel, 64> found; // one node's: the walk ends with the first that has any
  return walk.next(found) != 0 ? std::optional(found[0]) : std::nullopt;
}
} // namespace detail

/// Calls visit(voxel) for each occupied voxel on the ray; stops when visit returns true, and then
/// returns true.
template <class Visit>
bool visit_voxels(const voxel_set& set, const ray& r, convention rule, exactness certainty,
                  const ray_segment& segment, Visit&& visit) {
  voxel_walk walk(set, r, rule, certainty, segment);
  return detail::visit_all(walk, visit);
}
/// On a segment between points.
template <class Visit>
bool visit_voxels(const voxel_set& set, const segment& between, convention rule,
                  exactness certainty, Visit&& visit) {
  voxel_walk walk(set, between, rule, certainty);
  return detail::visit_all(walk, visit);
}

/// The first occupied voxel that owns a point of the ray's segment (`exact`), or the first that may
/// (`conservative`).
[[nodiscard]] inline std::optional<voxel> first_voxel(const voxel_set& set, const ray& r,
                                                      exactness certainty = exactness::exact,
                                                      const ray_segment& segment = {}) {
  voxel_walk walk(set, r, convention::owned, certainty, segment, true);
  return detail::first_of(walk);
}
[[nodiscard]] inline std::optional<voxel> first_voxel(const voxel_set& set, const segment& between,
                                                      exactness certainty = exactness::exact) {
  voxel_walk walk(set, between, convention::owned, certainty, true);
  return detail::first_of(walk);
}

/// first_voxel of each ray, into hits (as many as rays): what does not depend on the ray is done
/// once.
inline void first_voxels(const voxel_set& set, std::span<const ray> rays, exactness certainty,
                         std::span<std::optional<voxel>> hits, const ray_segment& segment = {}) {
  const detail::voxel_rays_walk& kernels = detail::voxel_rays_kernels(set);
  std::array<voxel, 64> found;
  detail::voxel_rays_state state;
  detail::prepare(state, set, convention::owned, certainty, segment, true);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    detail::set_line(state, rays[i]);
    hits[i] = kernels.begin(state, found.data(), found.size()) != 0 ? std::optional(found[0])
                                                                    : std::nullopt;
  }
}

/// The number of occupied voxels on each ray, into counts (as many as rays). Returns the number of
/// nodes opened.
inline std::uint64_t count_voxels(const voxel_set& set, std::span<const ray> rays, convention rule,
                                  exactness certainty, std::span<std::uint32_t> counts,
                                  const ray_segment& segment = {}) {
  return detail::count_voxels(set, rays, rule, certainty, counts, segment);
}
/// On segments between points.
inline std::uint64_t count_voxels(const voxel_set& set, std::span<const segment> segments,
                                  convention rule, exactness certainty,
                                  std::span<std::uint32_t> counts) {
  return detail::count_voxels(set, segments, rule, certainty, counts, {});
}

/// Calls visit(i, voxels) for each ray i with spans of its occupied voxels, in order: none, one or
/// more spans a ray. Returns the number of nodes opened.
template <class Visit>
std::uint64_t visit_voxels(const voxel_set& set, std::span<const ray> rays, convention rule,
                           exactness certainty, const ray_segment& segment, Visit&& visit) {
  return detail::visit_voxels(set, rays, rule, certainty, segment, visit);
}
/// On segments between points.
template <class Visit>
std::uint64_t visit_voxels(const voxel_set& set, std::span<const segment> segments, convention rule,
                           exactness certainty, Visit&& visit) {
  return detail::visit_voxels(set, segments, rule, certainty, {}, visit);
}

} // namespace graze::octree
