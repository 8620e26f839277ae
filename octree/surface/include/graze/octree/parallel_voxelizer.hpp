#pragma once
/// Voxelization on several threads: the bytes of voxelize_by, for any number of threads. The only header
/// of graze::octree that needs more than the package has; link the target graze::octree_parallel.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <atomic>
#include <functional>
#include <graze/octree/voxelizer.hpp>
#include <graze/support/threads.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

namespace graze::octree {

struct parallel_options {
  int threads = 0; ///< 0: one a core
  /// Asked now and then; once true the voxelization is given up.
  const std::atomic<bool>* stop = nullptr;
  /// Told how many of how many parts are done, from one thread at a time.
  std::function<void(std::size_t done, std::size_t parts)> progress;
};

namespace detail {
/// The octree above the level at which it is divided, and the parts below. Each thread builds its
/// parts one behind the other in a builder of its own, so that a part allocates nothing.
template <ChildrenJudge J> class divided_voxelization {
public:
  using octant = typename J::octant;
  using inner = sparse_octree::builder::inner;

  divided_voxelization(const J& judge, const root_cube& root)
      : judge_(judge), root_(root), divided_at_(std::min(root.level() - 1, 4)) {
    [[maybe_unused]] const typename J::scope scope;
    divide(octant(root.root_octant()), 0);
  }
  [[nodiscard]] std::size_t count() const { return parts_.size(); }

  /// Different parts at the same time.
  void build(std::size_t i) {
    [[maybe_unused]] const typename J::scope scope;
    sparse_octree::builder& to = own_builder();
    part p{};
    p.from = &to;
    p.first_node = to.next_node();
    p.first_leaf = to.next_leaf();
    p.top = voxelize_below(judge_, octants_[i], divided_at_, root_.level(), to);
    p.nodes = to.next_node() - p.first_node;
    p.leaves = to.next_leaf() - p.first_leaf;
    if (to.full())
      full_.store(true, std::memory_order_relaxed);
    parts_[i] = p;
  }

  /// Where each part goes; call it once all are built. False if there is no room.
  [[nodiscard]] bool arrange() {
    if (full_.load(std::memory_order_relaxed))
      return false;
    places_.reserve(parts_.size());
    const position top = arrange_below(0);
    if (nodes_ > most || leaves_ > most)
      return false;
    out_.emplace(root_, nodes_ + 1, leaves_); // zeroes them: what one thread does, 7 % at level 12
    for (const auto& [at, n] : above_)
      out_->set(at, n.as_inner());
    out_->set(nodes_, top.as_inner());
    return true;
  }
  /// Different parts at the same time.
  void place(std::size_t i) {
    out_->place(parts_[i], divided_at_, places_[i].node, places_[i].leaf);
  }
  sparse_octree finish() { return std::move(*out_).finish(); }

private:
  using part = sparse_octree::assembly::part;
  static constexpr std::size_t most = 0xffff'ffff - 8;
  struct place_of_part {
    std::uint32_t node, leaf;
  };
  struct position {
    std::uint8_t mask;
    std::size_t first_child;
    [[nodiscard]] inner as_inner() const { return {mask, static_cast<std::uint32_t>(first_child)}; }
  };

  /// This thread's.
  sparse_octree::builder& own_builder() {
    const std::lock_guard lock(making_);
    return builders_.try_emplace(std::this_thread::get_id(), root_).first->second;
  }

  void divide(octant o, int level) {
    if (level == divided_at_) {
      octants_.push_back(o);
      parts_.emplace_back();
      return;
    }
    const std::uint8_t open = judge_.open(o);
    open_.push_back(open);
    for (unsigned i = 0; i < 8; ++i)
      if ((open >> i & 1) != 0)
        divide(o.child(i), level + 1);
  }

  /// The order in which voxelization adds nodes.
  position arrange_below(int level) {
    if (level == divided_at_) {
      const part& p = parts_[places_.size()];
      places_.push_back({static_cast<std::uint32_t>(nodes_), static_cast<std::uint32_t>(leaves_)});
      const bool above_leaves = level + 1 == root_.level();
      const std::size_t first = above_leaves ? leaves_ + (p.top.first_child - p.first_leaf)
                                             : nodes_ + (p.top.first_child - p.first_node);
      nodes_ += p.nodes;
      leaves_ += p.leaves;
      return {p.top.mask, first};
    }
    position found[8];
    unsigned count = 0, mask = 0;
    const std::uint8_t open = open_[next_open_++];
    for (unsigned i = 0; i < 8; ++i) {
      if ((open >> i & 1) == 0)
        continue;
      const position n = arrange_below(level + 1);
      if (n.mask == 0)
        continue;
      found[count++] = n;
      mask |= 1u << i;
    }
    const position r{static_cast<std::uint8_t>(mask), nodes_};
    for (unsigned i = 0; i < count; ++i)
      above_.emplace_back(nodes_++, found[i]);
    return r;
  }

  const J& judge_;
  root_cube root_;
  int divided_at_;
  std::vector<std::uint8_t> open_; ///< of the octants above, in pre-order
  std::vector<octant> octants_;
  std::vector<part> parts_;
  std::vector<place_of_part> places_;
  std::mutex making_;
  std::map<std::thread::id, sparse_octree::builder> builders_;
  std::atomic<bool> full_{false};
  std::size_t next_open_ = 0, nodes_ = 0, leaves_ = 0;
  std::vector<std::pair<std::size_t, position>> above_;
  std::optional<sparse_octree::assembly> out_;
};
} // namespace detail

/// voxelize_by on several threads: the same octree, byte for byte. The judge is used by all of them
/// at once. Refuses an octree of more than 2^32 nodes, a negative number of threads, and, with
/// "interrupted", to go on once `stop` is set. Peak memory: the octree and its parts, at most twice
/// the octree beside the vectors' slack. May throw std::bad_alloc, and what says
/// that no thread could be started.
template <ChildrenJudge J>
[[nodiscard]] expected<sparse_octree> voxelize_parallel(const J& judge, const root_cube& root,
                                                        const parallel_options& options = {}) {
  if (options.threads < 0)
    return unexpected{"the number of threads is negative"};
  const unsigned wanted = options.threads > 0 ? static_cast<unsigned>(options.threads)
                                              : std::thread::hardware_concurrency();
  detail::divided_voxelization<J> division(judge, root);
  const auto stopped = [&] {
    return options.stop != nullptr && options.stop->load(std::memory_order_relaxed);
  };
  const auto each_part = [&](auto&& task) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    const auto take_parts = [&] {
      for (std::size_t i = next++; i < division.count() && !failed; i = next++)
        task(i);
    };
    const auto threads = static_cast<unsigned>(std::min<std::size_t>(wanted, division.count()));
    support::thread_group(threads, take_parts, [&failed] { failed = true; }).join();
  };
  std::size_t done = 0;
  std::atomic<bool> telling{false};
  std::atomic<std::size_t> built{0};
  each_part([&](std::size_t i) {
    if (stopped())
      return;
    division.build(i);
    const std::size_t now = built.fetch_add(1) + 1;
    if (options.progress && !telling.exchange(true, std::memory_order_acquire)) {
      if (now > done)
        options.progress(done = now, division.count());
      telling.store(false, std::memory_order_release);
    }
  });
  if (stopped())
    return unexpected{"interrupted"};
  if (!division.arrange())
    return unexpected{detail::too_many_nodes};
  each_part([&](std::size_t i) { division.place(i); });
  return division.finish();
}

} // namespace graze::octree
