#pragma once
/// Which scene a program is asked for: the same options, parser and refusals in all.
#include <CLI/CLI.hpp>
#include <graze/render/scene.hpp>
#include <graze/render/scene_text.hpp>
#include <string>
#include <vector>

namespace graze::render {

/// --scene, or --formula with --domain; --set of the formulas of either.
struct scene_options {
  std::string scene, formula, domain;
  std::vector<std::string> set;

  /// How many scenes are named.
  [[nodiscard]] int count() const { return int{!scene.empty()} + int{!formula.empty()}; }
  std::vector<CLI::Option*> declare(CLI::App& app);
  /// Whether they can be given together.
  [[nodiscard]] support::status check() const;
  /// The scene, one being named. The reason names the option, or the file and the key; `where`, if
  /// given, is the formula's text in which something is wrong.
  [[nodiscard]] expected<render::scene> read(formula_mark* where = nullptr) const;
};

} // namespace graze::render
