#pragma once
/// What is under test: anything that says which octants of a block a ray visits, in order.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <trial/trial.hpp>

namespace graze::fuzz {

/// Which octants a traversal promises to report; its misses are judged by this promise.
/// `touched`: every octant whose closed box the ray meets. `owned`: every octant that owns a point
/// of the ray, front to back. `crossed`: only those whose open interior the ray meets.
/// `exactly_touched`, `exactly_owned`: the same octants as the first two, and no others.
/// `first`: one cell, touched and entered no later than the first crossed one; none only where none is
/// crossed. `first_touched`: one of the cells touched soonest; none only where none is touched.
/// `any`: whether there is such a cell. `count`: how often the ray crosses the closed surface of all
/// occupied cells together.
enum class promise {
  touched,
  owned,
  crossed,
  exactly_touched,
  exactly_owned,
  first,
  first_touched,
  any,
  count
};

constexpr bool is_exact(promise p) {
  return p == promise::exactly_touched || p == promise::exactly_owned;
}
/// The owning octants are promised, front to back.
constexpr bool promises_owned(promise p) {
  return p == promise::owned || p == promise::exactly_owned;
}

std::string_view name_of(promise p);
/// By the names of name_of().
std::optional<promise> promise_of(std::string_view name);

/// Why there is no answer to judge: the traversal ended, did not end, threw, or answered something
/// that is not an answer or that holds a NaN.
enum class fault : std::uint8_t { none, crash, hang, exception, malformed, not_a_number };

/// The ray that a traversal really works on, where it is not the one it was given; of a segment its
/// far end; the boxes, where they are others.
struct received_ray {
  vec3 origin, direction;
  std::optional<vec3> end{};
  std::shared_ptr<const std::vector<octree::box>> boxes{};
};

/// A face of a box: axis and side.
struct face {
  std::uint8_t axis; ///< 0, 1, 2
  bool upper;
  friend bool operator==(const face&, const face&) = default;
};

/// What a traversal says beside the cells: of the first one, for promise::first; whether there is one;
/// a number of crossings. What it does not say is not judged.
struct remarks {
  std::optional<double> t;        ///< entry into the first cell, in the ray's parameter
  std::optional<double> distance; ///< the same as a length
  std::optional<face> entered;
  bool no_face = false; ///< it says that no face is entered: the origin is in the cell
  std::optional<bool> hit;
  std::optional<std::uint64_t> crossings;
};

/// The octants that a traversal reported, in its order; repetitions are kept.
class visited {
public:
  void clear() {
    count_ = 0;
    set_ = 0;
    repeated_ = outside_ = declined_ = false;
    fault_ = fault::none;
    received_.reset();
    elsewhere_.reset();
    said_ = {};
    thrown_.clear();
  }
  void push(octant_number v) {
    const octant_set bit = octant_set{1} << v;
    if ((set_ & bit) != 0) {
      repeated_ = true; // its first place in the order stands
      return;
    }
    set_ |= bit;
    order_[count_++] = v;
  }
  /// An octant that is not of the block was reported.
  void push_outside() { outside_ = true; }
  /// The one cell that was reported is a voxel outside of the block that is occupied in the trial's map.
  void push_elsewhere(const voxel_index& v) { elsewhere_ = v; }
  /// Leaves out what is not of the set.
  void keep(octant_set set) {
    unsigned kept = 0;
    for (unsigned i = 0; i < count_; ++i)
      if ((set >> order_[i] & 1) != 0)
        order_[kept++] = order_[i];
    count_ = kept;
    set_ &= set;
  }
  /// There is no answer.
  void fail(fault f) { fault_ = f; }
  /// There is no answer but an exception, and `what` it says.
  void fail_by_exception(std::string what) {
    fail(fault::exception);
    thrown_ = std::move(what);
  }
  /// What was answered is no answer, and `why`: a line of ASCII.
  void fail_by_form(std::string why) {
    fail(fault::malformed);
    thrown_ = std::move(why);
  }
  /// The traversal does not take this trial (it cannot represent it): nothing is judged.
  void decline() { declined_ = true; }
  /// The answer is for this ray: it is judged on it. One that is not a ray (a direction that became
  /// zero, a component that became infinite) counts as declined.
  void receive(const received_ray& r) { received_ = r; }
  /// What is said beside the cells.
  remarks& said() { return said_; }
  [[nodiscard]] const remarks& said() const { return said_; }

  [[nodiscard]] octant_set set() const { return set_; }
  [[nodiscard]] unsigned size() const { return count_; }
  [[nodiscard]] octant_number operator[](unsigned i) const { return order_[i]; }
  [[nodiscard]] bool repeated() const { return repeated_; }
  [[nodiscard]] bool outside() const { return outside_; }
  [[nodiscard]] const std::optional<voxel_index>& elsewhere() const { return elsewhere_; }
  [[nodiscard]] fault failed() const { return fault_; }
  /// What the exception says, or what is malformed, where that is the fault: a line of ASCII.
  [[nodiscard]] const std::string& thrown() const { return thrown_; }
  [[nodiscard]] bool declined() const { return declined_; }
  [[nodiscard]] const std::optional<received_ray>& received() const { return received_; }

private:
  std::array<octant_number, 64> order_;
  unsigned count_ = 0;
  octant_set set_ = 0;
  bool repeated_ = false, outside_ = false, declined_ = false;
  fault fault_ = fault::none;
  std::optional<received_ray> received_;
  std::optional<voxel_index> elsewhere_;
  remarks said_;
  std::string thrown_;
};

/// One traversal under test. visit() may be called from one thread at a time; a campaign makes one
/// for each thread. Adapters to other people's code implement this interface.
struct traversal {
  virtual ~traversal() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual promise promises() const = 0;
  /// Whether it takes trials of these cells, and segments; others are declined, it is not asked.
  [[nodiscard]] virtual bool takes(cell_kind cells, bool segment) const {
    return cells == cell_kind::cube && !segment;
  }
  /// By how many ulps of double t and distance may be off; nothing where nobody has said so.
  [[nodiscard]] virtual std::optional<double> tolerance() const { return std::nullopt; }
  /// It works in float, on rays and boxes that were rounded to it before they were sent.
  [[nodiscard]] virtual bool in_float() const { return false; }
  /// So many trials at a time suit it.
  [[nodiscard]] virtual std::size_t at_once() const { return 64; }
  /// Appends to `out` (cleared by the caller) the octants of t's block that the ray visits, in
  /// order. `t` has passed judgeable(). What it throws is told as fault::exception by ask().
  virtual void visit(const trial& t, visited& out) = 0;
  /// Answers the first n >= 1 of the trials (at least one is given), clearing out[0] to out[n-1]
  /// first, and returns n. A traversal in another process answers many at once.
  virtual std::size_t visit_some(std::span<const trial> trials, std::span<visited> out);
};

/// Clears `out` and asks about one trial; voxels that are not occupied in its map are left out of the answer.
/// An exception is the trial's fault, whatever was answered before it.
void ask(traversal& under_test, const trial& t, visited& out);

} // namespace graze::fuzz
