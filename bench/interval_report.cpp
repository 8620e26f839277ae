// graze-interval-report [--count N] [--operation NAME]: how good the answers of graze::interval and
// its peers are, on the first N operands that interval_bench times (default 4096, all), on points
// and on N hard operands for each operation. MPFR judges. A JSON object a line: a library's verdict
// on an operation. The first line names the libraries that are missing. Time is interval_bench's.
#include "judged_intervals.hpp"
#include <charconv>
#include <cstdio>
#include <cstring>
#include <graze/rounding/environment.hpp>
#include <map>
#include <set>
#include <tuple>

namespace {

using namespace graze::bench;

std::string quoted(const std::string& s) {
  std::string r = "\"";
  for (const char c : s)
    r += c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ' ? '\'' : c;
  return r + '"';
}

std::string pair_of(double lower, double upper) {
  char text[96];
  std::snprintf(text, sizeof text, "[\"%a\", \"%a\"]", lower, upper);
  return text;
}

/// Operands and their tightest enclosures, found once for all libraries.
class truths {
public:
  explicit truths(std::size_t count) : count_(count) {}
  /// The set that is timed; once an operation and library, also its points and hard operands.
  std::vector<const operand_set*> sets_of(const contender& c) {
    const operand_set& timed = find(c, c.set, [&] { return timed_operands(c, count_); });
    if (!firsts_.insert({c.operation, c.library}).second)
      return {&timed};
    return {&timed, &find(c, "points", [&] { return points_of(timed); }),
            &find(c, "hard", [&] { return hard_operands_of(c.operation, count_); })};
  }
  const std::vector<graze::bounds>& tightest_of(const contender& c, const operand_set& set) {
    auto& truth = truths_[{c.operation, set.name, c.of_points}];
    if (truth.empty())
      truth = tightest(c.operation, set, c.of_points);
    return truth;
  }

private:
  template <class Make>
  const operand_set& find(const contender& c, const std::string& name, Make make) {
    operand_set& set = sets_[{c.operation, name}];
    if (set.x.empty())
      set = make();
    return set;
  }

  std::size_t count_;
  std::set<std::pair<std::string, std::string>> firsts_;
  std::map<std::pair<std::string, std::string>, operand_set> sets_;
  std::map<std::tuple<std::string, std::string, bool>, std::vector<graze::bounds>> truths_;
};

void report(const contender& c, const operand_set& set, const std::vector<graze::bounds>& truth) {
  const std::vector<enclosure> answers = c.answers(set.x, set.y, set.y);
  const verdict v = judge(answers, truth);
  std::printf("{\"library\": %s, \"operation\": %s, \"operands\": %s, \"count\": %zu, "
              "\"unsound\": %zu, \"unbounded\": %zu, \"tight\": %zu, \"mean_excess_ulps\": %.6g, "
              "\"median_excess_ulps\": %.6g, \"worst_excess_ulps\": %.6g",
              quoted(c.library).c_str(), quoted(c.operation).c_str(), quoted(set.name).c_str(),
              v.judged, v.unsound, v.unbounded, v.tight, v.mean_excess, v.median_excess,
              v.worst_excess);
  if (v.unsound) {
    const std::size_t i = v.example;
    const ends &x = set.x[i], &y = set.y[i];
    std::printf(", \"example\": {\"x\": %s, \"y\": %s, \"answer\": %s, \"tightest\": %s}",
                (c.of_points ? pair_of(x.point, x.point) : pair_of(x.lower, x.upper)).c_str(),
                (c.of_points ? pair_of(y.point, y.point) : pair_of(y.lower, y.upper)).c_str(),
                pair_of(answers[i].lower, answers[i].upper).c_str(),
                pair_of(truth[i].lo, truth[i].hi).c_str());
  }
  std::printf("}\n");
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-interval-report"))
    return 2;
  std::size_t count = size;
  std::string only;
  for (int i = 1; i < argc; ++i) {
    const bool has_value = i + 1 < argc;
    if (has_value && std::strcmp(argv[i], "--operation") == 0) {
      only = argv[++i];
    } else if (has_value && std::strcmp(argv[i], "--count") == 0) {
      const char* end = argv[i + 1] + std::strlen(argv[i + 1]);
      if (std::from_chars(argv[i + 1], end, count).ptr != end || count == 0 || count > size) {
        std::fprintf(stderr, "--count takes 1 to %zu\n", size);
        return 2;
      }
      ++i;
    } else {
      std::fprintf(stderr, "usage: graze-interval-report [--count N] [--operation NAME]\n");
      return 2;
    }
  }
  std::printf("{\"missing\": %s}\n", quoted(measure_all()).c_str());
  truths known(count);
  for (const contender& c : contenders()) {
    if ((!only.empty() && c.operation != only) || !has_judge(c.operation))
      continue;
    for (const operand_set* set : known.sets_of(c))
      report(c, *set, known.tightest_of(c, *set));
    std::fflush(stdout);
  }
  return 0;
}
