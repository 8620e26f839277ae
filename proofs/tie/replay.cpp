/// Replays lines that the extracted model has answered: every backend must give every bound bit for
/// bit and every verdict. Built with many compilers and flags, and with mutants in place of headers.
///
///   replay FILE           exit 0: all agree; 1: not (the first lines are printed); 2: bad input
///   replay --flush FILE   the same with FTZ and DAZ set outside of the backends' scopes, which must
///                         turn them off; and graze::rounding::refusal must refuse
///   replay --show B       answers the lines of the standard input in full, with backend B
#include "answer.hpp"
#include "lanes.hpp"
#include <cstring>
#include <fstream>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <iostream>
#if defined(__x86_64__)
#include <graze/rounding/split.hpp>
#endif

namespace {

using namespace graze;
using namespace graze::tie;

struct entry {
  const char* name;
  answers (*answer)(const line&, bool);
  bool clears_flushing;
  bool planes_down; ///< the code's own sums may round down in its scope
};

constexpr entry backends[] = {
    {"upward", &answer<rounding::upward>, true, false},
#if !defined(GRAZE_TIE_UPWARD_ALONE)
    {"switching", &answer<rounding::switching>, false, false},
    {"nearest", &answer<rounding::nearest>, false, false},
#if defined(__x86_64__)
    {"split", &answer<rounding::split>, true, true},
#endif
#endif
};

unsigned long wrong = 0, of_lanes = 0;

void complain(const char* name, const std::string& text, const std::string& got) {
  if (++wrong <= 3)
    std::printf("%s: %s\n  answers  %s\n", name, text.c_str(), got.c_str());
}

/// What a path's lanes say against ray_bounds<upward> and the model's verdicts.
void check_lanes(const lane_path& path, const line& l, const std::string& text) {
  using namespace octree;
  using bounds = ray_bounds<rounding::upward>;
  const auto r = ray::make(l.o, l.d);
  if (!r)
    return;
  for (const point& p : {l.lo, l.hi, l.mid})
    for (const double x : p)
      if ((std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) == 0x7ff)
        return;
  lane_question q{l.kind, l.lo, l.mid, l.size, {}, {}};
  double enter[3], leave[2][3];
  {
    const rounding::upward::scope scope;
    const auto axes = bounds::prepare(l.o, l.d);
    const cube cell{l.lo, l.size};
    for (std::size_t i = 0; i < 3; ++i) {
      const int axis = static_cast<int>(i);
      if (l.kind != 'b')
        q.mid[i] = cell.mid(axis);
      const auto at = bounds::within<convention::closed>(axes[i], l.lo[i],
                                                         l.kind == 'b' ? l.hi[i] : cell.hi(axis));
      q.enter[i] = at.enter, q.leave[i] = at.leave;
      enter[i] = bounds::enter_at(axes[i], q.mid[i]);
      leave[0][i] = bounds::leave_at<convention::closed>(axes[i], q.mid[i]);
      leave[1][i] = bounds::leave_at<convention::owned>(axes[i], q.mid[i]);
    }
  }
  lane_answer a{};
  path.ask(*r, q, a);
  ++of_lanes;
  bool same = true;
  for (unsigned c = 0; c < 2; ++c)
    for (unsigned i = 0; i < 3; ++i)
      same = same && pattern(a.leave[c][i]) == pattern(leave[c][i]) &&
             pattern(a.minus_enter[c][i]) == pattern(-enter[i]);
  if (!same)
    return complain(path.name, text, "bounds at the mid-planes differ");
  // the model's verdicts, but for the first two and the fold
  std::string verdicts = std::to_string(a.origin_side[0]) + ' ' + mask_text(a.children[0]) + ' ' +
                         mask_text(a.children[1]) + ' ';
  if (l.kind != 'b') {
    verdicts += a.entered[0] ? "1 " : "0 ";
    for (unsigned c = 0; c < 2; ++c) {
      std::string order;
      for (unsigned i = 0; i < a.count[c]; ++i)
        order += static_cast<char>('0' + a.order[c][i]);
      verdicts += (order.empty() ? "-" : order) + ' ';
    }
  }
  if (l.kind == 't')
    for (unsigned c = 0; c < 2; ++c)
      verdicts += visits_text(a.visited[c], a.visits[c]) + ' ';
  const std::string_view wanted = l.answers.substr(4, l.answers.size() - 4 - 16);
  if (verdicts != wanted || a.origin_side[0] != a.origin_side[1] || a.entered[0] != a.entered[1])
    complain(path.name, text, verdicts);
}

int show(const char* name) {
  for (const entry& b : backends)
    if (std::strcmp(b.name, name) == 0) {
      for (std::string text; std::getline(std::cin, text);) {
        std::puts(text.c_str());
        const auto l = parse(text);
        if (!l) {
          std::fprintf(stderr, "replay: not a line: %s\n", text.c_str());
          return 2;
        }
        std::printf("%s\n", b.answer(*l, true).text().c_str());
      }
      return 0;
    }
  std::fprintf(stderr, "replay: no backend %s\n", name);
  return 2;
}

} // namespace

int main(int count, char** arguments) {
  if (count == 3 && std::strcmp(arguments[1], "--show") == 0)
    return show(arguments[2]);
  const bool flush = count == 3 && std::strcmp(arguments[1], "--flush") == 0;
  std::ifstream file(arguments[count - 1]);
  if (count < 2 || (count == 3 && !flush) || count > 3 || !file) {
    std::fprintf(stderr, "replay: usage: replay [--flush] FILE, or replay --show BACKEND\n");
    return 2;
  }
#if defined(__x86_64__)
  if (flush) {
    rounding::hardware::set_mxcsr(rounding::hardware::mxcsr() |
                                  rounding::hardware::mxcsr_flush_to_zero);
    if (!rounding::refusal() || !rounding::refusal_for_nearest())
      complain("refusal", "FTZ is set", "nothing to complain of");
    rounding::hardware::set_mxcsr(0x1f80 | rounding::hardware::mxcsr_denormals_zero);
    if (!rounding::refusal() || !rounding::refusal_for_nearest())
      complain("refusal", "DAZ is set", "nothing to complain of");
    rounding::hardware::set_mxcsr(0x1f80 | rounding::hardware::mxcsr_denormals_zero |
                                  rounding::hardware::mxcsr_flush_to_zero);
  }
#endif
  unsigned long lines = 0;
  for (std::string text; std::getline(file, text);) {
    if (text.empty() || text[0] == '#')
      continue;
    const auto l = parse(text);
    if (!l || l->answers.empty()) {
      std::fprintf(stderr, "replay: not an answered line: %s\n", text.c_str());
      return 2;
    }
    ++lines;
    for (const entry& b : backends)
      if (!flush || b.clears_flushing)
        if (const std::string got = b.answer(*l, false).text();
            got != l->answers && !(b.planes_down && got == l->answers_down))
          complain(b.name, text, got);
    for (const lane_path* p : lane_paths)
      if (p->runs_here() && (!flush || p->clears_flushing))
        check_lanes(*p, *l, text);
  }
  if (lines == 0) {
    std::fprintf(stderr, "replay: no lines\n");
    return 2;
  }
  std::printf("%lu lines, %lu answers of lanes, %lu wrong\n", lines, of_lanes, wrong);
  return wrong == 0 ? 0 : 1;
}
