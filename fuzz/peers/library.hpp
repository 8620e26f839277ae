#pragma once
/// A library's traversals, each behind the same three functions: built from occupied octants, asked
/// which ray it gets, and asked for the octants on it. Nothing here measures or judges, and no
/// library's header is included: the adapters' programs and the benchmarks drive the same code.
///
/// To add a library: libraries/NAME.cpp, which defines NAME_variants(), and a line in
/// CMakeLists.txt.
#include <graze/octree/ray.hpp>
#include <memory>
#include <peers/occupied_octants.hpp>

namespace graze::peers {

/// Octants in the library's own form. Not thread-safe: one a thread.
class structure {
public:
  structure() = default;
  structure(const structure&) = delete;
  structure& operator=(const structure&) = delete;
  virtual ~structure() = default;

  /// The ray that the library gets for r, and to which visit() is the answer. Nothing where there
  /// is none (a component that is infinite in float, a sum that loses the direction, an origin
  /// beyond the library's coordinates), or where it is no double.
  [[nodiscard]] virtual std::optional<octree::ray> received(const octree::ray& r) const = 0;

  /// Appends the occupied octants that the library reports, in its order, doubles included, and
  /// nothing of our own.
  virtual void visit(const octree::ray& r, std::vector<octant_key>& found) = 0;
};

/// When a variant is timed: what it does for a ray may grow with all octants, as that of a box test
/// in a loop does, and then it is only judged.
enum class timed : bool { no, yes };

/// One traversal of a library.
struct variant {
  const char* name;    ///< graze-fuzz's: the library's, and the variant's after a dash
  const char* promise; ///< which octants it will not leave out: `crossed` or `exactly-touched`
  timed in_benchmarks;
  const char* title;   ///< in benchmarks and reports
  const char* summary; ///< in `graze-fuzz list`
  /// Null where the library cannot hold these octants.
  std::unique_ptr<structure> (*build)(const occupied_octants& octants);
};

/// `build` of a structure that takes any octants, and of one that takes them as unit_cells.
template <class Structure> std::unique_ptr<structure> built(const occupied_octants& octants) {
  return std::make_unique<Structure>(octants);
}
template <class Structure>
std::unique_ptr<structure> built_in_cells(const occupied_octants& octants) {
  const auto cells = unit_cells::make(octants);
  return cells ? std::make_unique<Structure>(octants, *cells) : nullptr;
}

struct library {
  const char* name;
  std::vector<variant> variants;
};

/// Those that the program is linked to; CMake writes it from its list.
const std::vector<library>& libraries();

} // namespace graze::peers
