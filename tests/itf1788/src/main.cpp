/// The command line of graze-itf1788. Exit codes: 0 every statement passed, 1 some did not, 2 bad
/// input.
#include <graze/itf1788/report.hpp>
#include <graze/support/program.hpp>

namespace {

using namespace graze::itf1788;
using namespace graze::support;

const char* const examples = R"(
Examples:
  graze-itf1788 ITF1788/itl                  the public suite, once you have cloned it
  graze-itf1788 --verbose mine.itl           every statement with its verdict
  graze-itf1788 --json ITF1788/itl | jq .total

A statement passes if every result is the stated one: the same bounds (0 ulp), the same decoration,
the same sign of a zero number, and the stated signal (none if none is stated). A result of a reverse
operation that is tighter than stated passes if MPFR proves that what it leaves out holds no solution;
it is printed, and fails with --strict. A statement is unsupported if Graze has no such operation for
operands of these kinds. Folders are read with their subfolders.

The last line is: total: N passed, N failed, N unsupported
With --json one object is printed instead, and nothing else.

Exit code: 0 every statement passed, 1 some failed or are unsupported, 2 bad input (no such path, no
.itl file in a folder, a syntax error) or another failure, 130 interrupted.)";

int start(int argc, char** argv) {
  CLI::App app("Runs the statements of .itl files (the ITF1788 framework's) on graze::interval");
  app.name("graze-itf1788");
  app.footer(examples);
  std::vector<std::string> paths;
  bool json = false, verbose = false, only_stated = false;
  app.add_option("path", paths, "Folders or .itl files")->required();
  app.add_flag("--json", json, "Print one JSON object");
  app.add_flag("--strict", only_stated, "Count results that are tighter than stated as failed");
  app.add_flag("--verbose", verbose, "Print passed and unsupported statements too");
  if (const auto code = parse_arguments(app, argc, argv))
    return *code;
  listen_for_interrupts();

  std::vector<file_report> reports;
  for (const std::string& path : paths) {
    const auto files = files_of(path);
    if (!files)
      return bad_input(files.reason());
    for (const std::string& file : *files) {
      if (stop_wanted)
        return ended_by_signal;
      auto report = run_file(file);
      if (!report)
        return bad_input(report.reason());
      reports.push_back(*std::move(report));
    }
  }
  if (only_stated)
    reports = strict(std::move(reports));
  print_text(json ? to_json(reports) + "\n" : to_text(reports, verbose));
  const totals all = total_of(reports);
  return all.failed == 0 && all.unsupported == 0 ? done : found;
}

} // namespace

int main(int argc, char** argv) { return run_program("graze-itf1788", argc, argv, start); }
