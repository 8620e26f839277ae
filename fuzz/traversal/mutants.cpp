/// Traversals that are wrong on purpose, each in one way; the harness is tested with them.
#include <graze/octree/sound.hpp>
#include <graze/rounding/upward.hpp>
#include <stdexcept>
#include <traversal/list.hpp>
#include <traversal/method_traversal.hpp>
#include <utility>

namespace graze::fuzz {

namespace {

using octree::branches;
using sound = octree::sound<rounding::upward, octree::convention::owned>;

/// The sound method with its children changed by Edit.
template <class Edit> class edited : sound {
public:
  using sound::enter;
  using sound::sound;
  using typename sound::scope;
  using typename sound::state;
  void split(const cube& cell, const state& at, branches<state>& out) const {
    branches<state> all;
    sound::split(cell, at, all);
    Edit::apply(all, out);
  }
};

/// Leaves out child 5, always.
struct drop_one_child {
  template <class B> static void apply(const B& all, B& out) {
    for (unsigned i = 0; i < all.size(); ++i)
      if (all[i].index != 5)
        out.push(all[i].index, all[i].state);
  }
};

/// Back to front.
struct reverse_order {
  template <class B> static void apply(const B& all, B& out) {
    for (unsigned i = all.size(); i-- > 0;)
      out.push(all[i].index, all[i].state);
  }
};

/// Leaves out what it only just passes: the interval on some two axes is a single value of t, which
/// is what happens when planes are hit at the same t to the last bit.
struct skip_exact_hit {
  template <class B> static void apply(const B& all, B& out) {
    for (unsigned i = 0; i < all.size(); ++i) {
      const auto& s = all[i].state;
      const double enter = std::max({0.0, s[0].enter, s[1].enter, s[2].enter});
      const double leave = std::min({s[0].leave, s[1].leave, s[2].leave});
      if (enter < leave)
        out.push(all[i].index, s);
    }
  }
};

/// Reports every octant of the block, whatever the ray.
class report_everything final : public traversal {
public:
  [[nodiscard]] std::string_view name() const override { return "mutant-everything"; }
  [[nodiscard]] promise promises() const override { return promise::touched; }
  void visit(const trial& t, visited& out) override {
    for (octant_set left = t.all(); left != 0; left &= left - 1)
      out.push(static_cast<octant_number>(std::countr_zero(left)));
  }
};

/// The sound answer, with its last octant reported twice.
class report_twice final : public traversal {
public:
  [[nodiscard]] std::string_view name() const override { return "mutant-twice"; }
  [[nodiscard]] promise promises() const override { return promise::owned; }
  void visit(const trial& t, visited& out) override {
    base_.visit(t, out);
    if (out.size() != 0)
      out.push(out[out.size() - 1]);
  }

private:
  method_traversal<sound> base_{"sound", promise::owned};
};

/// The sound answer, but for directions with x < 0 an exception, of one type or another; and after
/// one nothing that it says is right.
class throws final : public traversal {
public:
  [[nodiscard]] std::string_view name() const override { return "mutant-throws"; }
  [[nodiscard]] promise promises() const override { return promise::owned; }
  void visit(const trial& t, visited& out) override {
    if (std::exchange(broken_, t.direction[0] < 0)) {
      out.push_outside();
      return;
    }
    base_.visit(t, out);
    if (!broken_)
      return;
    if (t.direction[1] < 0)
      throw 7;
    throw std::runtime_error("a direction with x < 0");
  }

private:
  method_traversal<sound> base_{"sound", promise::owned};
  bool broken_ = false;
};

/// The sound answer, passed off as an exact one.
std::unique_ptr<traversal> make_inexact() {
  return std::make_unique<method_traversal<sound>>("mutant-inexact", promise::exactly_owned);
}

template <class Edit, const char* Name> std::unique_ptr<traversal> make_edited() {
  return std::make_unique<method_traversal<edited<Edit>>>(Name, promise::owned);
}
constexpr char drops[] = "mutant-drops";
constexpr char reversed[] = "mutant-reversed";
constexpr char exact[] = "mutant-exact";

} // namespace

const std::vector<traversal_entry>& mutants() {
  static const std::vector<traversal_entry> all = [] {
    std::vector<traversal_entry> list{
        {drops, "sound, but leaves out child 5", make_edited<drop_one_child, drops>},
        {reversed, "sound, but back to front", make_edited<reverse_order, reversed>},
        {"mutant-everything", "every octant of the block",
         [] { return std::unique_ptr<traversal>(new report_everything); }},
        {exact, "sound, but skips where planes are hit exactly",
         make_edited<skip_exact_hit, exact>},
        {"mutant-inexact", "sound, but promises to be exact", make_inexact},
        {"mutant-twice", "sound, but its last octant twice",
         [] { return std::unique_ptr<traversal>(new report_twice); }},
        {"mutant-throws", "sound, but throws where the direction has x < 0",
         [] { return std::unique_ptr<traversal>(new throws); }},
    };
    for (const traversal_entry& e : wrong_references())
      list.push_back(e);
    return list;
  }();
  return all;
}

} // namespace graze::fuzz
