#pragma once
/// `graze-fuzz self` as the command line sees it.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace graze::fuzz {

struct self_options;

/// The subcommand of an application.
class self_command {
public:
  explicit self_command(CLI::App& app);
  ~self_command();
  self_command(const self_command&) = delete;
  self_command& operator=(const self_command&) = delete;

  /// Runs it if it was parsed and returns the exit code; else nothing.
  [[nodiscard]] std::optional<int> run() const;

private:
  std::unique_ptr<self_options> options_;
};

} // namespace graze::fuzz
