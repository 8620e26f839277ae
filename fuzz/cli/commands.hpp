#pragma once
/// The subcommands of graze-fuzz.
#include <array>
#include <campaign/schedule.hpp>
#include <functional>
#include <graze/support/program.hpp>
#include <graze/support/progress.hpp>

namespace graze::fuzz {

struct subcommand {
  CLI::App* app;
  std::function<int()> run; ///< once it was parsed; gives the exit code
};

/// Each adds itself to the application.
subcommand run_command(CLI::App& app);
subcommand replay_command(CLI::App& app);
subcommand campaign_command(CLI::App& app);
subcommand summary_command(CLI::App& app);
subcommand self_command(CLI::App& app);

/// Shows a plan's progress on the line, after this text; both outlive it.
inline progress_listener shown_on(support::progress_line& line, const trial_plan& p,
                                  const std::string& before = {}) {
  if (!line.is_shown())
    return {};
  return [&line, &p, before](std::uint64_t done, double seconds) {
    line.show({done, p.trials, seconds, p.seconds}, before);
  };
}

} // namespace graze::fuzz
