#pragma once
/// Operations of intervals as campaigns see them: what is under test, which operands are hard for
/// it, and who judges. The subjects `intervals` and `functions` are lists of these; a test makes
/// one with a broken operation in it.
#include <graze/bounds.hpp>
#include <graze/decoration.hpp>
#include <self/subject.hpp>

namespace graze::fuzz::self {

/// Up to three operands, and an integer one.
struct interval_operands {
  std::array<bounds, 3> boxes{bounds::empty(), bounds::empty(), bounds::empty()};
  unsigned count = 1;
  int n = 0;
  bool has_n = false;
};

struct interval_operation {
  std::string name;
  /// Operands of a trial.
  std::function<interval_operands(std::uint64_t seed, std::uint64_t index)> generate;
  std::function<bounds(const interval_operands&)> value; ///< under test
  /// What is wrong with a value.
  std::function<void(const interval_operands&, const bounds& value, observations&)> judge;
  /// What the decoration should be, where there is a judge of it; and what it is.
  std::function<decoration(const interval_operands&)> right_local = {}, local = {};
  /// It is asked of numbers, each as [x, x], infinities and NaN among them; else of sets.
  bool of_numbers = false;
};

/// Arithmetic (by every backend too), sets and the reverse operations of IEEE 1788.1.
std::vector<interval_operation> interval_operations();
/// The elementary functions.
std::vector<interval_operation> elementary_operations();

/// One part an operation.
subject subject_of(std::string name, std::string summary, std::vector<interval_operation> list);

/// "[0x1p+0, 0x1.8p+0]", "[empty]".
std::string text_of(const bounds& x);
/// Adds what is wrong with `got` where `right` is the tightest enclosure; `operation` is what was
/// asked. A zero bound may be of either sign.
void compare(const std::string& operation, const bounds& right, const bounds& got,
             observations& out);

} // namespace graze::fuzz::self
