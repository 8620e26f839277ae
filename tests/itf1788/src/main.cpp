/// The command line of graze-itf1788. Exit codes: 0 every statement passed, 1 some did not, 2 bad
/// input.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <graze/itf1788/report.hpp>
#include <graze/rounding/environment.hpp>

namespace {

using namespace graze::itf1788;

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
.itl file in a folder, a syntax error).)";

int bad_input(const std::string& why) {
  std::fprintf(stderr, "graze-itf1788: %s\n", why.c_str());
  return 2;
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-itf1788"))
    return 2;
  CLI::App app("Runs the statements of .itl files (the ITF1788 framework's) on graze::interval");
  app.name("graze-itf1788");
  app.footer(examples);
  std::vector<std::string> paths;
  bool json = false, verbose = false, only_stated = false;
  app.add_option("path", paths, "Folders or .itl files")->required();
  app.add_flag("--json", json, "Print one JSON object");
  app.add_flag("--strict", only_stated, "Count results that are tighter than stated as failed");
  app.add_flag("--verbose", verbose, "Print passed and unsupported statements too");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0)
      return app.exit(e);
    return bad_input(e.what());
  }

  std::vector<file_report> reports;
  for (const std::string& path : paths) {
    const auto files = files_of(path);
    if (!files)
      return bad_input(files.reason());
    for (const std::string& file : *files) {
      auto report = run_file(file);
      if (!report)
        return bad_input(report.reason());
      reports.push_back(*std::move(report));
    }
  }
  if (only_stated)
    reports = strict(std::move(reports));
  const std::string text = json ? to_json(reports) + "\n" : to_text(reports, verbose);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    return bad_input("cannot write to the standard output");
  const totals all = total_of(reports);
  return all.failed == 0 && all.unsupported == 0 ? 0 : 1;
}
