/// The traversals that are written here from their papers (fuzz/peers), driven through a trial's block.
#include <peers/list.hpp>
#include <traversal/list.hpp>
#include <traversal/method_traversal.hpp>

namespace graze::fuzz {

namespace {

/// The peers promise nothing about an octant that the ray only touches (the paper's strict overlap
/// leaves it out on purpose): a miss is an octant whose interior the ray crosses.
template <class Peer> class peer_traversal : public traversal {
public:
  [[nodiscard]] std::string_view name() const final { return Peer::name; }
  [[nodiscard]] promise promises() const final { return promise::crossed; }
};

/// Asks a ray/box test for each octant of the block, by the exact corners, for t from 0 to infinity.
/// It is made once a ray, from its origin and direction as they are, in double.
template <class Test> class box_traversal final : public peer_traversal<Test> {
public:
  void visit(const trial& t, visited& out) override {
    const Test hits(t.origin, t.direction);
    for (octant_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<octant_number>(std::countr_zero(left));
      const cube box = t.octant(v);
      if (hits(box.lo, {box.hi(0), box.hi(1), box.hi(2)}))
        out.push(v);
    }
  }
};

/// Walks a grid. Up to level 10 it is the whole grid of the trial's level; below, where there are
/// too many cells, the block alone.
template <class Walk> class grid_traversal final : public peer_traversal<Walk> {
public:
  void visit(const trial& t, visited& out) override {
    const bool whole = t.level <= 10;
    peers::cell_grid grid{{}, t.size(), {}};
    std::array<int, 3> block{};
    for (unsigned a = 0; a < 3; ++a) {
      grid.cells[a] = whole ? 1 << t.level : t.extent[a];
      block[a] = whole ? static_cast<int>(t.base[a]) : 0;
      grid.lo[a] = whole ? t.root.lo[a] : t.plane(static_cast<int>(a), 0);
    }
    Walk::walk(grid, t.origin, t.direction, [&](const std::array<int, 3>& at) {
      bool inside = true, behind = false; // behind the block no later cell is of it
      for (unsigned a = 0; a < 3; ++a) {
        const int in = at[a] - block[a];
        inside = inside && in >= 0 && in < t.extent[a];
        behind = behind || (t.direction[a] < 0 ? in < 0 : in >= t.extent[a]);
      }
      if (inside)
        out.push(octant_at(static_cast<unsigned>(at[0] - block[0]),
                           static_cast<unsigned>(at[1] - block[1]),
                           static_cast<unsigned>(at[2] - block[2])));
      return behind;
    });
  }
};

template <class Peer> std::unique_ptr<traversal> made() {
  if constexpr (octree::Method<Peer>)
    return std::make_unique<method_traversal<Peer>>(Peer::name, promise::crossed);
  else if constexpr (peers::BoxTest<Peer>)
    return std::make_unique<box_traversal<Peer>>();
  else
    return std::make_unique<grid_traversal<Peer>>();
}

template <class... Peer> std::vector<traversal_entry> entries(peers::list<Peer...>) {
  return {{Peer::name, Peer::summary, made<Peer>}...};
}

} // namespace

std::vector<traversal_entry> baselines_of_2005() { return entries(peers::paper2005{}); }

const std::vector<traversal_entry>& adapters() {
  static const std::vector<traversal_entry> all = [] {
    std::vector<traversal_entry> list = entries(peers::papers{});
    for (const traversal_entry& e : rational_references())
      list.push_back(e);
    return list;
  }();
  return all;
}

} // namespace graze::fuzz
