#pragma once
/// A campaign on one subject of our own code: trials in processes of their own, so that a crash or
/// an endless loop is a finding and not the campaign's end.
#include <campaign/schedule.hpp>
#include <graze/expected.hpp>
#include <self/subject.hpp>

namespace graze::fuzz::self {

/// The workers are processes.
struct plan : trial_plan {
  const subject* under_test = nullptr;
  double seconds_a_trial = 60; ///< until a trial counts as a hang
};

/// The first trial (lowest number) of a part that showed a kind of flaw.
struct finding {
  flaw kind;
  std::string part;
  std::uint64_t trial;
  std::string what;
};

struct part_counts {
  std::uint64_t trials = 0;
  std::array<std::uint64_t, flaw_kinds> flawed{}; ///< trials that showed each kind
};

struct result {
  std::vector<part_counts> parts; ///< as in the subject
  std::vector<finding> findings;  ///< most serious first, then by trial
  std::uint64_t trials = 0;
  double seconds = 0;
  bool interrupted = false;
};

/// Runs until a budget is used up or `stop` is true; trials in work are finished and counted. A
/// plan with `trials` counts and finds the same with any number of processes. Call it from a
/// program of one thread: it forks. Refuses where the system gives no process or memory.
[[nodiscard]] expected<result> run(const plan& p, const std::atomic<bool>& stop,
                                   const progress_listener& progress = {});

/// The command that repeats a finding alone.
std::string command_of(const plan& p, const finding& f);
/// For people: a row a part, and the findings, each with the command that repeats it.
std::string to_text(const plan& p, const result& r);
/// One JSON object on one line: subject, seed, trials, seconds, trials_per_second, interrupted,
/// parts, findings.
std::string to_json(const plan& p, const result& r);

} // namespace graze::fuzz::self
