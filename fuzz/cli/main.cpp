/// The command line of graze-fuzz. Exit codes: 0 nothing found, 1 a finding, 2 bad input or a failure.
#include <cli/commands.hpp>
#include <external/libraries.hpp>
#include <generate/generators.hpp>

namespace {

using namespace graze::fuzz;
using namespace graze::support;

const char* const examples = R"(
Examples:
  graze-fuzz run                                        five seconds on the sound traversal
  graze-fuzz run --traversal published --level 50       finds a ray that misses an octant
  graze-fuzz run --traversal gargantini --save miss.jsonl
  graze-fuzz replay miss.jsonl --traversal gargantini   says again, by rationals, what is missed
  graze-fuzz run --command "python3 my_traversal.py"    a traversal of your own: docs/adapters.md
  graze-fuzz run --traversal published --reproducer out what a maintainer is handed: text, C++, SVG
  graze-fuzz list

Exit code: 0 nothing found, 1 a finding, 2 bad input or a failure (memory, files, output), 130 ended
by a signal before there was a result.)";

int list() {
  print("traversals\n");
  for (const traversal_entry& e : traversals())
    print("  {:<31} {}\n", e.name, e.summary);
  print("traversals of others\n");
  const std::vector<traversal_entry> libraries = library_traversals();
  for (const auto* entries : {&adapters(), &linked_traversals(), &libraries})
    for (const traversal_entry& e : *entries)
      print("  {:<31} {}\n", e.name, e.summary);
  print("references, by rationals, and textbooks' methods in double, for any cells and segments\n");
  for (const traversal_entry& e : rational_references())
    print("  {:<31} {}\n", e.name, e.summary);
  print("traversals that are wrong on purpose\n");
  for (const traversal_entry& e : mutants())
    print("  {:<31} {}\n", e.name, e.summary);
  print("generators\n");
  for (const generator& g : generators())
    print("  {:<31} {}\n", g.name, g.summary);
  return 0;
}

subcommand list_command(CLI::App& app) {
  return {app.add_subcommand("list", "Names of traversals and generators"), list};
}

int start(int argc, char** argv) {
  CLI::App app{"Finds octants that a ray traversal misses, with an exact oracle."};
  app.footer(examples);
  app.require_subcommand(1);
  const std::array commands{run_command(app),     replay_command(app), campaign_command(app),
                            summary_command(app), self_command(app),   list_command(app)};
  if (const auto code = parse_arguments(app, argc, argv))
    return *code;
  for (const subcommand& c : commands)
    if (c.app->parsed())
      return c.run();
  return refused;
}

} // namespace

int main(int argc, char** argv) { return run_program("graze-fuzz", argc, argv, start); }
