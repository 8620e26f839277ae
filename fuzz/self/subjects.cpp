#include <algorithm>
#include <self/batches.hpp>
#include <self/formula.hpp>
#include <self/interval_operations.hpp>
#include <self/loaders.hpp>
#if defined(__x86_64__)
#include <self/control_words.hpp>
#endif
#include <self/voxelizer.hpp>

namespace graze::fuzz::self {

std::string_view name_of(flaw f) {
  static constexpr std::array<std::string_view, flaw_kinds> names{
      "crash",    "hang",    "unsound",    "wrong-empty", "dropped", "control-word",
      "accepted", "meaning", "difference", "decoration",  "loose",   "no-reason"};
  return names[static_cast<unsigned>(f)];
}

/// The one list: a new subject is a function in a file of its own, and a line here.
const std::vector<subject>& subjects() {
  static const std::vector<subject> all{
      subject_of("intervals",
                 "Operations of IEEE 1788.1 and every backend's arithmetic, against MPFR",
                 interval_operations()),
      subject_of("functions", "Elementary functions of intervals, against MPFR",
                 elementary_operations()),
      batches_subject(),
      voxelizer_subject(),
      loaders_subject(),
      formula_subject(),
#if defined(__x86_64__)
      control_words_subject(),
#endif
  };
  return all;
}

const subject* find_subject(std::string_view name) {
  const auto found = std::find_if(subjects().begin(), subjects().end(),
                                  [name](const subject& s) { return s.name == name; });
  return found != subjects().end() ? &*found : nullptr;
}

} // namespace graze::fuzz::self
