/// The rational reference for each promise, two textbook methods for grids and boxes in double, and
/// references that are wrong on purpose.
#include <algorithm>
#include <cmath>
#include <judge/exact_cells.hpp>
#include <limits>
#include <traversal/list.hpp>

namespace graze::fuzz {

namespace {

namespace rational = oracle::rational;

class reference : public traversal {
public:
  reference(std::string_view name, promise p) : name_(name), promise_(p) {}
  [[nodiscard]] std::string_view name() const final { return name_; }
  [[nodiscard]] promise promises() const final { return promise_; }
  [[nodiscard]] bool takes(cell_kind cells, bool) const override {
    return cells != cell_kind::boxes || !promises_owned(promise_);
  }

private:
  std::string_view name_;
  promise promise_;
};

/// All cells for which `holds` is true.
template <class Holds> void visit_each(const trial& t, visited& out, Holds holds) {
  for (octant_set left = t.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    if (holds(v))
      out.push(v);
  }
}

class all_touched : public reference {
public:
  all_touched() : reference("rational", promise::exactly_touched) {}
  void visit(const trial& t, visited& out) override {
    const auto line = rational_line(t);
    visit_each(t, out,
               [&](octant_number v) { return rational::touches(line, rational_cell(t, v)); });
  }
};

/// In the order of t: of two cells that own points one owns all of its before the other.
class all_owned : public reference {
public:
  all_owned() : reference("rational-owned", promise::exactly_owned) {}
  void visit(const trial& t, visited& out) override {
    const auto line = rational_line(t);
    std::vector<std::pair<mpq_class, octant_number>> owners;
    for (octant_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<octant_number>(std::countr_zero(left));
      const auto cell = rational_cell(t, v);
      if (!rational::owns(line, cell, far_faces_of(t, v)))
        continue;
      const auto range = rational::range_in(line, cell);
      owners.emplace_back(range->first + range->second, v); // twice the middle
    }
    std::sort(owners.begin(), owners.end());
    for (const auto& [middle, v] : owners)
      out.push(v);
  }
};

/// The t at which the line comes into a cell that it touches.
struct entry_of_cell {
  mpq_class t;
  octant_number cell;
};
std::vector<entry_of_cell> entries(const trial& t) {
  std::vector<entry_of_cell> all;
  const auto line = rational_line(t);
  for (octant_set left = t.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    if (const auto range = rational::range_in(line, rational_cell(t, v)))
      all.push_back({range->first, v});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const entry_of_cell& x, const entry_of_cell& y) { return x.t < y.t; });
  return all;
}

void say_entry(const trial& t, const entry_of_cell& e, remarks& said) {
  // GMP does not say what a number beyond the doubles becomes
  const auto nearest = [](const auto& x) {
    constexpr double most = std::numeric_limits<double>::max();
    return x > most ? std::numeric_limits<double>::infinity() : x.get_d();
  };
  said.t = nearest(e.t);
  const auto line = rational_line(t);
  const auto cell = rational_cell(t, e.cell);
  mpq_class square = 0;
  said.no_face = true;
  for (unsigned a = 0; a < 3; ++a) {
    const mpq_class &o = line.origin[a], &d = line.velocity[a];
    square += d * d;
    if (e.t == 0 || d == 0)
      continue;
    const bool upper = d < 0;
    const mpq_class& near = upper ? cell.hi[a] : cell.lo[a];
    if (o + e.t * d == near) {
      said.entered = face{static_cast<std::uint8_t>(a), upper};
      said.no_face = false;
    }
  }
  const mpf_class length = sqrt(mpf_class(square, 2400)) * mpf_class(e.t, 2400);
  said.distance = nearest(length);
}

/// `place`-th of the cells in the order in which they are entered.
class nth_touched : public reference {
public:
  nth_touched(std::string_view name, promise p, std::size_t place)
      : reference(name, p), place_(place) {}
  void visit(const trial& t, visited& out) override {
    const auto all = entries(t);
    if (all.size() <= place_)
      return;
    out.push(all[place_].cell);
    say_entry(t, all[place_], out.said());
    change(out.said());
  }

protected:
  virtual void change(remarks&) {}

private:
  std::size_t place_;
};

class first_too_far final : public nth_touched {
public:
  first_too_far() : nth_touched("mutant-distance", promise::first_touched, 0) {}

protected:
  void change(remarks& said) override {
    *said.t *= 1 + 0x1p-30;
    *said.distance *= 1 + 0x1p-30;
  }
};

class first_by_other_face final : public nth_touched {
public:
  first_by_other_face() : nth_touched("mutant-face", promise::first_touched, 0) {}

protected:
  void change(remarks& said) override {
    if (said.entered)
      said.entered->upper = !said.entered->upper;
  }
};

class hit_or_not : public reference {
public:
  hit_or_not(std::string_view name, bool wrong) : reference(name, promise::any), wrong_(wrong) {}
  void visit(const trial& t, visited& out) override {
    const auto all = entries(t);
    out.said().hit = wrong_ ? all.size() > 1 : !all.empty();
  }

private:
  bool wrong_;
};

/// Between one event and the next the line is in a box or in none: by a point half way.
class crossings final : public reference {
public:
  crossings() : reference("rational-count", promise::count) {}
  void visit(const trial& t, visited& out) override {
    const auto line = rational_line(t);
    std::vector<rational::box> boxes;
    for (octant_set left = t.all(); left != 0; left &= left - 1)
      boxes.push_back(rational_cell(t, static_cast<octant_number>(std::countr_zero(left))));
    std::vector<mpq_class> events{0};
    for (const rational::box& b : boxes)
      if (const auto range = rational::range_in(line, b))
        events.insert(events.end(), {range->first, range->second});
    std::sort(events.begin(), events.end());
    events.push_back(line.last ? mpq_class(1) : mpq_class(events.back() + 1));
    const auto inside = [&](const mpq_class& when) {
      for (const rational::box& b : boxes) {
        bool in = true;
        for (unsigned a = 0; a < 3 && in; ++a) {
          const mpq_class x = line.origin[a] + when * line.velocity[a];
          in = b.lo[a] <= x && x <= b.hi[a];
        }
        if (in)
          return true;
      }
      return false;
    };
    std::uint64_t number = 0;
    std::optional<bool> before;
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      if (events[i] == events[i + 1])
        continue;
      const bool now = inside((events[i] + events[i + 1]) / 2);
      number += before && *before != now ? 1 : 0;
      before = now;
    }
    out.said().crossings = number;
  }
};

/// Each face that the line meets counts, those of an edge twice.
class faces_met final : public reference {
public:
  faces_met() : reference("mutant-parity", promise::count) {}
  void visit(const trial& t, visited& out) override {
    const auto line = rational_line(t);
    std::uint64_t number = 0;
    const auto count = [&](rational::box face) { number += rational::touches(line, face) ? 1 : 0; };
    const auto faces = [&](const rational::box& b) {
      for (unsigned a = 0; a < 3; ++a) {
        rational::box face = b;
        face.hi[a] = b.lo[a];
        count(face);
        face.lo[a] = face.hi[a] = b.hi[a];
        count(face);
      }
    };
    if (t.boxes)
      for (octant_set left = t.all(); left != 0; left &= left - 1)
        faces(rational_cell(t, static_cast<octant_number>(std::countr_zero(left))));
    else
      faces(rational_block(t));
    out.said().crossings = number;
  }
};

/// A segment without its end.
class open_ended final : public reference {
public:
  open_ended() : reference("mutant-open-end", promise::exactly_touched) {}
  void visit(const trial& t, visited& out) override {
    const auto line = rational_line(t);
    visit_each(t, out, [&](octant_number v) {
      const auto range = rational::range_in(line, rational_cell(t, v));
      return range && !(line.last && range->first == 1);
    });
  }
};

/// The slab test in double, as in textbooks: (lo - o) / d.
class slab_tests : public reference {
public:
  slab_tests(std::string_view name, bool first)
      : reference(name, first ? promise::first : promise::crossed), first_(first) {}
  void visit(const trial& t, visited& out) override {
    double soonest = std::numeric_limits<double>::infinity();
    std::optional<octant_number> cell;
    std::optional<face> entered;
    for (octant_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<octant_number>(std::countr_zero(left));
      const octree::box b = t.cell(v);
      double enter = 0, leave = t.end ? 1 : std::numeric_limits<double>::infinity();
      std::optional<face> by;
      for (unsigned a = 0; a < 3; ++a) {
        double near = (b.lo[a] - t.origin[a]) / t.direction[a];
        double far = (b.hi[a] - t.origin[a]) / t.direction[a];
        const bool upper = near > far;
        if (upper)
          std::swap(near, far);
        if (near > enter) {
          enter = near;
          by = face{static_cast<std::uint8_t>(a), upper};
        }
        leave = far < leave ? far : leave;
      }
      if (!(enter <= leave))
        continue;
      if (!first_) {
        out.push(v);
      } else if (enter < soonest) {
        soonest = enter;
        cell = v;
        entered = by;
      }
    }
    if (!cell)
      return;
    out.push(*cell);
    out.said().t = soonest;
    out.said().entered = entered;
    out.said().no_face = !entered;
  }

private:
  bool first_;
};

/// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing" (1987), from voxel to voxel of the
/// block by the nearest plane, in double.
class nearest_plane_walk final : public reference {
public:
  nearest_plane_walk() : reference("grid-amanatides-woo", promise::crossed) {}
  [[nodiscard]] bool takes(cell_kind cells, bool) const override {
    return cells == cell_kind::grid;
  }
  void visit(const trial& t, visited& out) override {
    const double longest = t.end ? 1 : std::numeric_limits<double>::infinity();
    double now = 0, leave = longest;
    for (unsigned a = 0; a < 3; ++a) { // into the block
      const double o = t.origin[a], d = t.direction[a];
      const double lo = t.plane(static_cast<int>(a), 0),
                   hi = t.plane(static_cast<int>(a), t.extent[a]);
      if (d == 0) {
        if (o < lo || hi < o)
          return;
        continue;
      }
      now = std::max(now, std::min((lo - o) / d, (hi - o) / d));
      leave = std::min(leave, std::max((lo - o) / d, (hi - o) / d));
    }
    if (!(now <= leave))
      return;
    std::array<int, 3> at{}, step{};
    vec3 next;
    for (unsigned a = 0; a < 3; ++a) {
      const double d = t.direction[a], x = t.origin[a] + now * d;
      while (at[a] + 1 < t.extent[a] &&
             t.plane(static_cast<int>(a), static_cast<unsigned>(at[a]) + 1) <= x)
        ++at[a];
      step[a] = d > 0 ? 1 : (d < 0 ? -1 : 0);
      next[a] = when(t, a, at[a] + (step[a] > 0 ? 1 : 0));
    }
    while (true) {
      out.push(octant_at(static_cast<unsigned>(at[0]), static_cast<unsigned>(at[1]),
                         static_cast<unsigned>(at[2])));
      unsigned a = next[0] < next[1] ? 0 : 1;
      a = next[a] < next[2] ? a : 2;
      if (step[a] == 0 || next[a] > longest)
        return;
      at[a] += step[a];
      if (at[a] < 0 || at[a] >= t.extent[a])
        return;
      next[a] = when(t, a, at[a] + (step[a] > 0 ? 1 : 0));
    }
  }

private:
  static double when(const trial& t, unsigned a, int plane) {
    return t.direction[a] == 0
               ? std::numeric_limits<double>::infinity()
               : (t.plane(static_cast<int>(a), static_cast<unsigned>(plane)) - t.origin[a]) /
                     t.direction[a];
  }
};

template <class T, class... Arguments>
std::function<std::unique_ptr<traversal>()> maker(Arguments... arguments) {
  return [arguments...] { return std::unique_ptr<traversal>(new T(arguments...)); };
}

} // namespace

const std::vector<traversal_entry>& rational_references() {
  static const std::vector<traversal_entry> all{
      {"rational", "exact rationals, cell by cell: the reference, for any cells and segments",
       maker<all_touched>()},
      {"rational-owned", "the same: cells that own a point, front to back", maker<all_owned>()},
      {"rational-first", "the same: the first cell, its t, distance and face",
       maker<nth_touched>("rational-first", promise::first_touched, std::size_t{0})},
      {"rational-any", "the same: whether there is one", maker<hit_or_not>("rational-any", false)},
      {"rational-count", "the same: crossings of the surface", maker<crossings>()},
      {"slabs", "the textbook's slab test in double, cell by cell",
       maker<slab_tests>("slabs", false)},
      {"slabs-first", "the same, of which the soonest", maker<slab_tests>("slabs-first", true)},
      {"grid-amanatides-woo", "Amanatides and Woo's walk in double, on any planes",
       maker<nearest_plane_walk>()},
  };
  return all;
}

std::vector<traversal_entry> wrong_references() {
  return {
      {"mutant-second", "the second cell in place of the first",
       maker<nth_touched>("mutant-second", promise::first, std::size_t{1})},
      {"mutant-distance", "the first cell, its t off by 2^-30", maker<first_too_far>()},
      {"mutant-face", "the first cell, by the face across", maker<first_by_other_face>()},
      {"mutant-hit", "a hit where two cells are touched", maker<hit_or_not>("mutant-hit", true)},
      {"mutant-parity", "crossings, those at an edge once a face", maker<faces_met>()},
      {"mutant-open-end", "segments without their ends", maker<open_ended>()},
  };
}

} // namespace graze::fuzz
