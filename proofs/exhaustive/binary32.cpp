// graze-binary32: every float as an argument of every function of one argument,
// judged by MPFR.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstdint>
#include <graze/interval.hpp>
#include <graze/oracle/binary32.hpp>
#include <graze/support/program.hpp>
#include <graze/support/progress.hpp>
#include <graze/support/threads.hpp>
#include <mutex>
#include <string>
#include <vector>

namespace {

namespace binary32 = graze::oracle::binary32;
namespace support = graze::support;
using interval = graze::float_interval<>;

struct function {
  const char* name;
  interval (*under_test)(const interval&);
};
#define GRAZE_FUNCTION(name) {#name, [](const interval& x) { return interval(graze::name(x)); }}
const function functions[] = {
    GRAZE_FUNCTION(recip),
    GRAZE_FUNCTION(sqr),
    GRAZE_FUNCTION(sqrt),
    GRAZE_FUNCTION(abs),
    GRAZE_FUNCTION(sign),
    GRAZE_FUNCTION(ceil),
    GRAZE_FUNCTION(floor),
    GRAZE_FUNCTION(trunc),
    GRAZE_FUNCTION(round_ties_to_even),
    GRAZE_FUNCTION(round_ties_to_away),
    GRAZE_FUNCTION(exp),
    GRAZE_FUNCTION(exp2),
    GRAZE_FUNCTION(exp10),
    GRAZE_FUNCTION(expm1),
    GRAZE_FUNCTION(log),
    GRAZE_FUNCTION(log2),
    GRAZE_FUNCTION(log10),
    GRAZE_FUNCTION(logp1),
    GRAZE_FUNCTION(sin),
    GRAZE_FUNCTION(cos),
    GRAZE_FUNCTION(tan),
    GRAZE_FUNCTION(asin),
    GRAZE_FUNCTION(acos),
    GRAZE_FUNCTION(atan),
    GRAZE_FUNCTION(sinh),
    GRAZE_FUNCTION(cosh),
    GRAZE_FUNCTION(tanh),
    GRAZE_FUNCTION(asinh),
    GRAZE_FUNCTION(acosh),
    GRAZE_FUNCTION(atanh),
    GRAZE_FUNCTION(cbrt),
    GRAZE_FUNCTION(cot),
    GRAZE_FUNCTION(sec),
    GRAZE_FUNCTION(csc),
    GRAZE_FUNCTION(acot),
    GRAZE_FUNCTION(coth),
    GRAZE_FUNCTION(sech),
    GRAZE_FUNCTION(csch),
    GRAZE_FUNCTION(acoth),
};
#undef GRAZE_FUNCTION

graze::oracle::mpfr_function judge_of(std::string_view name) {
  for (const binary32::unary& f : binary32::unary_functions())
    if (name == f.name)
      return f.function;
  return nullptr;
}

struct tally {
  std::uint64_t judged = 0, unsound = 0, loose = 0;
  std::string first; ///< the first results that are not the tightest, a line each

  void add(const tally& other) {
    judged += other.judged, unsound += other.unsound, loose += other.loose;
    if (std::ranges::count(first, '\n') < 5)
      first += other.first;
  }
};

std::string to_text(const binary32::set& x) {
  return x ? fmt::format("[{:a}, {:a}]", x->lo, x->hi) : "empty";
}

void judge(const function& f, graze::oracle::mpfr_function exact, float x, tally& sum) {
  const binary32::set expected = binary32::enclosed(exact, x);
  const interval result = f.under_test(interval(x, x, true));
  const binary32::set got =
      empty(result) ? std::nullopt : binary32::set(binary32::ends{result.lower(), result.upper()});
  ++sum.judged;
  if (got == expected)
    return;
  const bool sound = !expected || (got && got->lo <= expected->lo && expected->hi <= got->hi);
  ++(sound ? sum.loose : sum.unsound);
  if (sum.unsound + sum.loose <= 5)
    sum.first +=
        fmt::format("{}({:a}) is {}, not {}\n", f.name, x, to_text(got), to_text(expected));
}

/// The floats of first, first + step, ... up to last, as bit patterns.
struct range {
  std::uint64_t first, last, step;
  [[nodiscard]] std::uint64_t count() const { return (last - first) / step + 1; }
};

float with_bits(std::uint64_t bits) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

/// Where a step might leap over what matters: each power of two and its
/// neighbours, zeros, the subnormal numbers' ends, infinities, NaN.
void judge_edges(const function& f, graze::oracle::mpfr_function exact, tally& sum) {
  for (std::uint64_t power = 0; power < 512; ++power)
    for (std::uint64_t beside = 0; beside < 9; ++beside)
      judge(f, exact, with_bits((power << 23) + beside - 4), sum);
}

struct options {
  unsigned threads = support::default_threads();
  bool json = false, progress = false;
};

struct outcome {
  tally sum;
  double seconds = 0;
  std::uint64_t next; ///< every pattern of the range before it has been judged
};

outcome run(const function& f, const range& r, const options& o) {
  constexpr std::uint64_t block = 1 << 16;
  const auto exact = judge_of(f.name);
  const std::uint64_t count = r.count();
  outcome result{.sum = {}, .next = r.first};
  std::mutex guard;
  std::atomic<std::uint64_t> given{0}, done{0};
  const auto started = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  };
  if (r.step > 1)
    judge_edges(f, exact, result.sum);
  std::atomic<bool> failed{false};
  support::progress_line line("floats", o.progress);
  support::thread_group workers(
      o.threads,
      [&] {
        // a block that was begun is ended, so that those before `given` are whole
        for (std::uint64_t at;
             !support::stop_wanted && !failed && (at = given.fetch_add(block)) < count;) {
          tally sum;
          const std::uint64_t end = std::min(at + block, count);
          for (std::uint64_t k = at; k < end; ++k)
            judge(f, exact, with_bits(r.first + k * r.step), sum);
          done += end - at;
          const std::lock_guard lock(guard);
          result.sum.add(sum);
        }
        mpfr_free_cache();
      },
      [&failed] { failed = true; });
  while (!workers.wait_for(std::chrono::milliseconds(100)))
    line.show({done.load(), count, seconds()}, std::string(f.name) + ": ");
  workers.join();
  line.clear();
  result.next = r.first + std::min(done.load(), count) * r.step;
  result.seconds = seconds();
  return result;
}

void report(const function& f, const range& r, const outcome& got, bool json) {
  const bool whole = got.next > r.last;
  if (json) {
    std::string findings, rest = got.sum.first;
    for (std::size_t end; (end = rest.find('\n')) != std::string::npos; rest.erase(0, end + 1))
      findings += fmt::format("{}\"{}\"", findings.empty() ? "" : ",", rest.substr(0, end));
    support::print("{{\"function\":\"{}\",\"first\":{},\"last\":{},\"step\":{},"
                   "\"judged\":{},"
                   "\"unsound\":{},\"loose\":{},\"seconds\":{:.3f},\"interrupted\":"
                   "{},\"next\":{},"
                   "\"findings\":[{}]}}\n",
                   f.name, r.first, r.last, r.step, got.sum.judged, got.sum.unsound, got.sum.loose,
                   got.seconds, !whole, got.next, findings);
  } else {
    support::print("{:<18} {:>10} floats in {:.1f} s, {:.3g} M/s: {} unsound, {} "
                   "loose\n{}",
                   f.name, got.sum.judged, got.seconds,
                   static_cast<double>(got.sum.judged) / got.seconds / 1e6, got.sum.unsound,
                   got.sum.loose, got.sum.first);
    if (!whole)
      support::print("interrupted; the rest: graze-binary32 {} --first {:#x} "
                     "--last {:#x} --step {}\n",
                     f.name, got.next, r.last, r.step);
  }
  support::flush_output();
}

int start(int argc, char** argv) {
  CLI::App app{"Every float as an argument of the functions of float "
               "intervals, judged by MPFR"};
  app.footer(R"(
Examples:
  graze-binary32 --step 65537               65,536 floats of all, and those about powers of two
  graze-binary32 exp sin                    all 2^32: about an hour a function on two cores
  graze-binary32 exp --first 0x3f800000 --last 0x40000000 --json

An interrupted run prints the command of the rest.
Exit code: 0 each result is the tightest, 1 one is not, 2 bad input or a failure.)");
  options o;
  range r{0, 0xffffffff, 1};
  std::vector<std::string> names;
  app.add_option("functions", names, "Names of functions (default: all, one after the other)");
  const CLI::Range patterns(std::uint64_t{0}, std::uint64_t{0xffffffff});
  app.add_option("--first", r.first, "Bit pattern of the first float")->check(patterns);
  app.add_option("--last", r.last, "Bit pattern of the last float")->check(patterns);
  app.add_option("--step", r.step,
                 "From one bit pattern to the next; beyond 1, also those about "
                 "each power of two")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{0xffffffff}));
  app.add_option("--threads", o.threads, "Threads")->check(CLI::Range(1u, 1024u));
  app.add_flag("--json", o.json, "Print one JSON object a function, on a line");
  app.add_flag("--progress", o.progress, "Show progress even if stderr is not a terminal");
  if (const auto code = support::parse_arguments(app, argc, argv))
    return *code;
  if (r.last < r.first)
    return support::bad_input("--last is before --first");
  const bool all = names.empty();
  std::vector<const function*> chosen;
  for (const function& f : functions)
    if (all || std::erase(names, f.name) != 0)
      chosen.push_back(&f);
  if (!names.empty())
    return support::bad_input(fmt::format("no function is called \"{}\"", names.front()));
  support::listen_for_interrupts();
  bool found = false;
  for (const function* f : chosen) {
    if (support::stop_wanted)
      break;
    const outcome got = run(*f, r, o);
    report(*f, r, got, o.json);
    found = found || got.sum.unsound + got.sum.loose != 0;
  }
  return found ? support::found : support::done;
}

} // namespace

int main(int argc, char** argv) {
  return support::run_program("graze-binary32", argc, argv, start);
}
