/// The product's grids and boxes under test: voxel sets in lanes on the path that is in use, and the exact
/// decisions voxel by voxel.
#include <graze/octree/voxel_rays.hpp>
#include <traversal/list.hpp>

namespace graze::fuzz {

namespace {

using octree::convention;
using octree::exactness;

/// The product's own grid of a trial's planes; the same for trials in a row that share one.
class grid_of_trial {
public:
  /// Null where it is none.
  const octree::grid* operator()(const trial& t) {
    if (planes_ != t.grid) {
      const grid_planes& g = *t.grid;
      auto made = g.rule == plane_rule::given
                      ? octree::grid::make({g.given[0], g.given[1], g.given[2]})
                      : octree::grid::make(g.origin, g.spacing, g.count, g.rule);
      grid_ = made ? std::optional(*std::move(made)) : std::nullopt;
      planes_ = t.grid;
    }
    return grid_ ? &*grid_ : nullptr;
  }

private:
  std::shared_ptr<const grid_planes> planes_;
  std::optional<octree::grid> grid_;
};

std::array<std::uint32_t, 3> index_of(const trial& t, octant_number v) {
  return {static_cast<std::uint32_t>(t.base[0] + (v & 3u)),
          static_cast<std::uint32_t>(t.base[1] + (v >> 2 & 3u)),
          static_cast<std::uint32_t>(t.base[2] + (v >> 4))};
}
octant_number number_of(const trial& t, const octree::voxel& v) {
  return octant_at(v.index(0) - static_cast<unsigned>(t.base[0]),
                   v.index(1) - static_cast<unsigned>(t.base[1]),
                   v.index(2) - static_cast<unsigned>(t.base[2]));
}

octree::exact_line exact_line_of(const trial& t) {
  if (t.end)
    return {*octree::segment::make(t.origin, *t.end)};
  return {*octree::ray::make(t.origin, t.direction)};
}

class grid_traversal : public traversal {
public:
  grid_traversal(std::string_view name, promise p) : name_(name), promise_(p) {}
  [[nodiscard]] std::string_view name() const final { return name_; }
  [[nodiscard]] promise promises() const final { return promise_; }
  [[nodiscard]] bool takes(cell_kind cells, bool) const override {
    return cells == cell_kind::grid;
  }
  void visit(const trial& t, visited& out) final {
    if (const octree::grid* grid = grid_(t))
      visit(t, *grid, out);
    else // the planes are a grid, by judgeable()
      out.fail(fault::malformed);
  }

protected:
  virtual void visit(const trial& t, const octree::grid& g, visited& out) = 0;
  [[nodiscard]] static octree::voxel_set set_of(const trial& t, const octree::grid& g) {
    std::vector<std::array<std::uint32_t, 3>> block;
    append_block(t, block);
    return *octree::voxel_set::make(g, block);
  }
  static void append_block(const trial& t, std::vector<std::array<std::uint32_t, 3>>& voxels) {
    for (octant_set left = t.all(); left != 0; left &= left - 1)
      voxels.push_back(index_of(t, static_cast<octant_number>(std::countr_zero(left))));
  }
  const octree::grid* grid_of(const trial& t) { return grid_(t); }

private:
  std::string_view name_;
  promise promise_;
  grid_of_trial grid_;
};

constexpr promise promise_of(convention c, exactness e) {
  if (e == exactness::exact)
    return c == convention::owned ? promise::exactly_owned : promise::exactly_touched;
  return c == convention::owned ? promise::owned : promise::touched;
}

/// All voxels on the line, by lanes.
class grid_walk final : public grid_traversal {
public:
  grid_walk(std::string_view name, convention c, exactness e)
      : grid_traversal(name, promise_of(c, e)), convention_(c), exactness_(e) {}

  /// Trials in a row that share a grid share a set, of all their voxels: a set over a large grid takes long
  /// to make. Each is told of its own voxels.
  std::size_t visit_some(std::span<const trial> trials, std::span<visited> out) override {
    const octree::grid* const g = trials[0].grid ? grid_of(trials[0]) : nullptr;
    if (g == nullptr)
      return traversal::visit_some(trials.first(1), out);
    std::size_t some = 1;
    while (some < trials.size() && trials[some].grid == trials[0].grid)
      ++some;
    std::vector<std::array<std::uint32_t, 3>> voxels;
    for (const trial& t : trials.first(some))
      append_block(t, voxels);
    const octree::voxel_set set = *octree::voxel_set::make(*g, voxels);
    for (std::size_t i = 0; i < some; ++i) {
      out[i].clear();
      walk(trials[i], set, out[i]);
    }
    return some;
  }

protected:
  void visit(const trial& t, const octree::grid& g, visited& out) override {
    walk(t, set_of(t, g), out);
  }

private:
  void walk(const trial& t, const octree::voxel_set& set, visited& out) const {
    const auto take = [&](const octree::voxel& v) {
      bool own = true;
      for (unsigned a = 0; a < 3; ++a)
        own = own && v.index(a) >= t.base[a] && v.index(a) < t.base[a] + t.extent[a];
      if (own)
        out.push(number_of(t, v));
      return false;
    };
    if (t.end)
      octree::visit_voxels(set, *octree::segment::make(t.origin, *t.end), convention_, exactness_,
                           take);
    else
      octree::visit_voxels(set, *octree::ray::make(t.origin, t.direction), convention_, exactness_,
                           {}, take);
  }

  convention convention_;
  exactness exactness_;
};

void remark(const octree::passage& p, remarks& said) {
  said.t = p.enter.lo + (p.enter.hi - p.enter.lo) / 2;
  for (unsigned a = 0; a < 3; ++a)
    for (const bool upper : {false, true})
      if ((p.entered & octree::face_bit(a, upper)) != 0)
        said.entered = face{static_cast<std::uint8_t>(a), upper};
  said.no_face = p.entered == 0;
}

/// The first voxel, its entry and face.
class grid_first final : public grid_traversal {
public:
  grid_first() : grid_traversal("grid-first", promise::first) {}

protected:
  void visit(const trial& t, const octree::grid& g, visited& out) override {
    const octree::voxel_set set = set_of(t, g);
    const auto first = t.end ? octree::first_voxel(set, *octree::segment::make(t.origin, *t.end))
                             : octree::first_voxel(set, *octree::ray::make(t.origin, t.direction));
    if (!first)
      return;
    out.push(number_of(t, *first));
    if (const auto p = exact_line_of(t).through(set.cell(*first)))
      remark(*p, out.said());
  }
};

/// Exact decisions, voxel by voxel.
class grid_decisions final : public grid_traversal {
public:
  grid_decisions() : grid_traversal("grid-decisions", promise::exactly_touched) {}

protected:
  void visit(const trial& t, const octree::grid& g, visited& out) override {
    const octree::exact_line line = exact_line_of(t);
    for (octant_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<octant_number>(std::countr_zero(left));
      if (line.touches(g.voxel(index_of(t, v))))
        out.push(v);
    }
  }
};

/// Exact decisions, box by box.
class box_decisions final : public traversal {
public:
  [[nodiscard]] std::string_view name() const override { return "boxes"; }
  [[nodiscard]] promise promises() const override { return promise::exactly_touched; }
  [[nodiscard]] bool takes(cell_kind cells, bool) const override {
    return cells == cell_kind::boxes;
  }
  void visit(const trial& t, visited& out) override {
    const octree::exact_line line = exact_line_of(t);
    for (std::size_t i = 0; i < t.boxes->size(); ++i)
      if (line.touches((*t.boxes)[i]))
        out.push(static_cast<octant_number>(i));
  }
};

/// Hit or not, by crossing.
class box_hit final : public traversal {
public:
  [[nodiscard]] std::string_view name() const override { return "boxes-any"; }
  [[nodiscard]] promise promises() const override { return promise::any; }
  [[nodiscard]] bool takes(cell_kind cells, bool) const override {
    return cells == cell_kind::boxes;
  }
  void visit(const trial& t, visited& out) override {
    const octree::exact_line line = exact_line_of(t);
    bool hit = false;
    for (const octree::box& b : *t.boxes)
      hit = hit || line.crosses(b);
    out.said().hit = hit;
  }
};

template <class T, class... Arguments>
std::function<std::unique_ptr<traversal>()> maker(Arguments... arguments) {
  return [arguments...] { return std::unique_ptr<traversal>(new T(arguments...)); };
}

} // namespace

std::vector<traversal_entry> grid_traversals() {
  using enum convention;
  using enum exactness;
  return {
      {"grid", "voxels of a grid that own a point, no others, front to back (by lanes)",
       maker<grid_walk>("grid", owned, exact)},
      {"grid-closed", "voxels of a grid that are touched, no others",
       maker<grid_walk>("grid-closed", closed, exact)},
      {"grid-conservative", "as grid, at times one too many",
       maker<grid_walk>("grid-conservative", owned, conservative)},
      {"grid-conservative-closed", "as grid-closed, at times one too many",
       maker<grid_walk>("grid-conservative-closed", closed, conservative)},
      {"grid-first", "the first voxel of a grid, its entry and face", maker<grid_first>()},
      {"grid-decisions", "as grid-closed, by exact decisions voxel by voxel",
       maker<grid_decisions>()},
      {"boxes", "boxes that are touched, no others", maker<box_decisions>()},
      {"boxes-any", "whether a box is crossed", maker<box_hit>()},
  };
}

} // namespace graze::fuzz
