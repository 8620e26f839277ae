/// Does the environment of the calling thread reach a bound? Every row of the library's operations
/// is asked at a program's start and in each environment, and the answers compared.
///   graze-environments               a line a row that is not as promised; exit code 1 if there is one
///   graze-environments --table       as Markdown, for docs/numerics.md
///   graze-environments --found       in the environment in which this process began, alone
///   graze-environments --thinning N  every N-th pair of operands (1: all of some 100,000)
#include "rows.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/hardware.hpp>
#include <thread>

#if !defined(__x86_64__)
#error "graze: these environments are those of x86-64"
#endif

namespace {

using namespace graze;
using namespace graze::environments;
namespace hardware = rounding::hardware;

struct environment {
  const char* name;
  unsigned mxcsr;
  unsigned short x87;
  bool in_thread; ///< asked in a thread that is started in it
};
constexpr environment known[] = {
    {"FTZ", 0x9f80, 0x037f, false},          {"DAZ", 0x1fc0, 0x037f, false},
    {"FTZ, DAZ", 0x9fc0, 0x037f, false},     {"down", 0x3f80, 0x077f, false},
    {"up", 0x5f80, 0x0b7f, false},           {"to 0", 0x7f80, 0x0f7f, false},
    {"up, FTZ, DAZ", 0xdfc0, 0x0b7f, false}, {"thread, FTZ, DAZ", 0x9fc0, 0x037f, true},
    {"thread, down", 0x3f80, 0x077f, true},  {"x87 53 bits", 0x1f80, 0x027f, false},
    {"x87 24 bits", 0x1f80, 0x007f, false},
};

void set(const environment& e) {
  hardware::set_x87_control(e.x87);
  hardware::set_mxcsr(e.mxcsr);
}
/// The environment must be as it was set, but for flags.
bool is_set(const environment& e) {
  return (hardware::mxcsr() & ~0x3fu) == e.mxcsr && hardware::x87_control() == e.x87;
}

struct observation {
  answers given;
  bool kept;                          ///< the environment is as it was
  std::optional<std::string> refused; ///< refusal_for_nearest()
};

/// Where nothing is promised, no more is asked than whether that is refused: a debug build asserts.
observation observe(const row& r, const environment& e, bool promised) {
  observation o;
  const auto ask_row = [&] {
    o.refused = rounding::refusal_for_nearest();
    if (promised)
      r.ask(o.given);
    o.kept = is_set(e);
  };
  // a thread has what its starter has: it sets nothing
  set(e);
  if (e.in_thread) {
    std::thread other(ask_row);
    rounding::set_default_environment();
    other.join();
    return o;
  }
  ask_row();
  rounding::set_default_environment();
  return o;
}

bool to_nearest(const environment& e) { return (e.mxcsr & 0x6000) == 0; }
bool promised(const row& r, const environment& e) {
  return r.promised == promise::immune || to_nearest(e);
}

struct tally {
  unsigned long answers = 0, unsound = 0, broken = 0;
};

/// The cell of a table: "=" the same answers, "refused", or what is wrong.
std::string verdict(const row& r, const environment& e, const answers& right, tally& all) {
  const observation o = observe(r, e, promised(r, e));
  all.answers += o.given.size();
  if (!o.kept) {
    ++all.broken;
    return "environment not kept";
  }
  if (promised(r, e)) {
    const answers::differences d = o.given.from(right);
    if (d.different == 0)
      return "=";
    ++all.broken;
    all.unsound += d.unsound;
    return std::to_string(d.unsound) + " unsound of " + std::to_string(d.different) + " others";
  }
  if (o.refused)
    return "refused";
  ++all.broken;
  return "not refused";
}

int usage() {
  std::fputs("graze-environments: --table, --found, --refusal or --thinning N are known\n", stderr);
  return 2;
}

} // namespace

int main(int argc, char** argv) {
#if defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    std::puts("graze: skipped, the processor lacks AVX2 or FMA");
    return 0;
  }
#endif
#if defined(__AVX512F__)
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512dq")) {
    std::puts("graze: skipped, the processor lacks AVX-512");
    return 0;
  }
#endif
  const environment found{"as found", hardware::mxcsr() & ~0x3fu, hardware::x87_control(), false};
  bool table = false, only_found = false;
  unsigned thinning = 97;
  for (int i = 1; i < argc; ++i) {
    const std::string_view option = argv[i];
    if (option == "--table")
      table = true;
    else if (option == "--found")
      only_found = true;
    else if (option == "--thinning" && i + 1 < argc && std::atoi(argv[i + 1]) > 0)
      thinning = static_cast<unsigned>(std::atoi(argv[++i]));
    else
      return usage();
  }
  if (!rounding::program_may_start("graze-environments"))
    return 2;
  if (only_found && found.mxcsr == 0x1f80)
    std::printf("this process began as a program should\n");

  std::vector<row> rows = rows_of_types(thinning);
#if !defined(GRAZE_TYPES_ALONE)
  for (std::vector<row> more : {rows_of_functions(thinning), rows_of_octrees()})
    rows.insert(rows.end(), more.begin(), more.end());
#endif
  std::vector<environment> environments(std::begin(known), std::end(known));
  if (only_found)
    environments = {found};

  std::string head = "| |", rule = "|---|";
  for (const environment& e : environments) {
    head += std::string(e.name) + '|';
    rule += "---|";
  }
  std::vector<std::pair<std::string, std::string>> lines; // cells, and the rows that have them
  tally all;
  for (const row& r : rows) {
    answers right;
    r.ask(right);
    std::string cells;
    for (const environment& e : environments) {
      const unsigned long before = all.broken;
      const std::string cell = verdict(r, e, right, all);
      cells += cell + '|';
      if (!table && all.broken != before) {
        std::printf("%s, %s: %s\n", r.name.c_str(), e.name, cell.c_str());
        std::fflush(stdout);
      }
    }
    const auto same = std::ranges::find(lines, cells, [](const auto& l) { return l.first; });
    if (same != lines.end())
      same->second += ", " + r.name;
    else
      lines.emplace_back(cells, r.name);
  }
  if (table) {
    std::printf("%s\n%s\n", head.c_str(), rule.c_str());
    for (const auto& [cells, names] : lines)
      std::printf("| %s |%s\n", names.c_str(), cells.c_str());
  }
  std::printf("%s%zu rows, %zu environments, %lu answers: %lu not as promised, %lu unsound\n",
              table ? "\n" : "", rows.size(), environments.size(), all.answers, all.broken,
              all.unsound);
  return all.broken != 0 ? 1 : 0;
}
