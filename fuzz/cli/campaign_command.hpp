#pragma once
/// `graze-fuzz campaign` and `graze-fuzz summary` as the command line sees them.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace graze::fuzz {

struct campaign_options;

/// The two subcommands of an application.
class campaign_commands {
public:
  explicit campaign_commands(CLI::App& app);
  ~campaign_commands();
  campaign_commands(const campaign_commands&) = delete;
  campaign_commands& operator=(const campaign_commands&) = delete;

  /// Runs the one that was parsed and returns the exit code; nothing when it was neither.
  [[nodiscard]] std::optional<int> run() const;

private:
  std::unique_ptr<campaign_options> options_;
};

} // namespace graze::fuzz
