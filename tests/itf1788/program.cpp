/// graze-itf1788 as its users meet it: output, exit codes, bad input; and the samples.
#include "../support/program.hpp"
#include <nlohmann/json.hpp>

namespace {

using support::outcome, support::scratch;

const std::string samples = GRAZE_ITF1788 "/samples";
constexpr int statements = 348; // of the samples
const std::string wrong = GRAZE_ITF1788 "/wrong/statements.itl";

outcome call(const std::string& arguments) {
  return support::call(GRAZE_ITF1788_PROGRAM, arguments);
}
void refused(const std::string& arguments, const std::string& reason) {
  support::refused(GRAZE_ITF1788_PROGRAM, arguments, reason);
}

std::string last_line(const std::string& text) {
  REQUIRE(!text.empty());
  REQUIRE(text.back() == '\n');
  const std::size_t begin = text.find_last_of('\n', text.size() - 2);
  return text.substr(begin + 1, text.size() - begin - 2);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("graze-itf1788: every sample passes, exit code 0", "[mpfr]") {
  const outcome o = call(samples);
  INFO(o.out << o.err);
  CHECK(o.code == 0);
  CHECK(o.err.empty());
  for (const char* file : {"arithmetic", "constructor", "elementary", "reverse", "set"})
    CHECK(holds(o.out, samples + "/" + file + ".itl: "));
  const std::string total = last_line(o.out);
  CHECK(holds(total, " passed, 0 failed, 0 unsupported"));
  int passed = 0;
  CHECK(std::sscanf(total.c_str(), "total: %d passed", &passed) == 1);
  CHECK(passed == statements);
}

TEST_CASE("graze-itf1788: wrong statements fail, each with its line; exit code 1", "[unit]") {
  const outcome o = call(wrong);
  INFO(o.out << o.err);
  CHECK(o.code == 1);
  CHECK(o.err.empty());
  CHECK(last_line(o.out) == "total: 2 passed, 18 failed, 4 unsupported");
  CHECK(holds(o.out, wrong + ": 2 passed, 18 failed, 4 unsupported\n"));
  CHECK(holds(o.out, wrong + ":4: failed: add [0.1, 0.1] [0.7, 0.7] = [0x1.9999999999998p-1, "
                             "0x1.999999999999ap-1]\n"
                             "  expected [0x1.9999999999998p-1, 0x1.999999999999ap-1]\n"
                             "  got      [0x1.9999999999999p-1, 0x1.999999999999ap-1]\n"));
  CHECK(holds(o.out, wrong + ":27: failed: "));
  CHECK(holds(o.out, wrong + ": unsupported: frobnicate(interval) (1 statement)\n"));
  CHECK_FALSE(holds(o.out, "passed: add"));
}

TEST_CASE("graze-itf1788 --verbose: every statement with its verdict", "[unit]") {
  const outcome o = call("--verbose " + wrong);
  CHECK(o.code == 1);
  CHECK(holds(o.out, wrong + ":31: passed: sup [-0.25, -0.0] = 0.0\n"));
  CHECK(holds(o.out, wrong + ":34: unsupported: frobnicate [1.5, 2.0] = [1.5, 2.0]: no "
                             "frobnicate(interval)\n"));
  CHECK(last_line(o.out) == "total: 2 passed, 18 failed, 4 unsupported");
}

TEST_CASE("graze-itf1788 --json: one object", "[unit]") {
  const outcome o = call("--json " + wrong + " " + samples);
  CHECK(o.code == 1);
  CHECK(std::count(o.out.begin(), o.out.end(), '\n') == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["total"]["passed"] == statements + 2);
  CHECK(object["total"]["failed"] == 18);
  CHECK(object["total"]["unsupported"] == 4);
  CHECK(object["files"].size() == 6);
  CHECK(object["files"][0]["file"] == wrong);
  CHECK(object["files"][0]["failed"] == 18);
  CHECK(object["failures"].size() == 18);
  CHECK(object["failures"][0]["line"] == 4);
  CHECK(object["failures"][1]["expected"] == "[0x1.9999999999999p-1, 0x1.9999999999999p-1]");
  CHECK(object["failures"][1]["got"] == "[0x1.9999999999999p-1, 0x1.999999999999ap-1]");
  CHECK(object["failures"][1]["statement"].get<std::string>().substr(0, 4) == "add ");
  CHECK(object["unsupported"].size() == 4);
  CHECK(object["unsupported"][0]["missing"] == "frobnicate(interval)");
}

TEST_CASE("graze-itf1788 --strict: tighter results are told, and fail", "[mpfr]") {
  const scratch dir;
  const std::string file = dir / "wide.itl";
  std::ofstream(file) << "testcase t {\n cosRevBin [-1.0, -1.0] [2.5, 4.5] = [2.5, 4.5];\n}";
  const outcome lenient = call(file);
  CHECK(lenient.code == 0);
  CHECK(holds(lenient.out, file + ":2: passed, tighter than stated: cosRevBin "));
  CHECK(holds(lenient.out, "  got      [0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1]\n"));
  CHECK(last_line(lenient.out) == "total: 1 passed, 0 failed, 0 unsupported");
  const outcome strict = call("--strict " + file);
  CHECK(strict.code == 1);
  CHECK(holds(strict.out, file + ":2: failed: cosRevBin "));
  CHECK(last_line(strict.out) == "total: 0 passed, 1 failed, 0 unsupported");
  const auto object = nlohmann::json::parse(call("--json " + file).out);
  CHECK(object["tighter"].size() == 1);
  CHECK(object["total"]["passed"] == 1);
}

TEST_CASE("graze-itf1788: unsupported statements alone are exit code 1 too", "[unit]") {
  const scratch dir;
  std::filesystem::create_directories(dir / "deep/er");
  std::ofstream(dir / "deep/er/a.itl") << "testcase t { frobnicate 1.0 = 1.0; }";
  std::ofstream(dir / "deep/b.txt") << "not read";
  const outcome o = call(dir / "deep");
  CHECK(o.code == 1);
  CHECK(last_line(o.out) == "total: 0 passed, 0 failed, 1 unsupported");
}

TEST_CASE("graze-itf1788: an unknown token leaves the other statements", "[regression]") {
  const scratch dir;
  std::ofstream(dir / "a.itl") << "testcase t {\n add [inf, 1.0] [1.0, 2.0] = [1.0, 2.0];\n"
                                  " add [1.0, 1.0] [1.0, 2.0] = [2.0, 3.0];\n}";
  const outcome o = call(dir / "a.itl");
  CHECK(o.code == 1);
  CHECK(last_line(o.out) == "total: 1 passed, 0 failed, 1 unsupported");
}

TEST_CASE("graze-itf1788: bad input is one line and exit code 2", "[unit]") {
  const scratch dir;
  refused("", "path");
  refused("/no/such/folder", "no such file or folder: /no/such/folder");
  refused(dir / "", "no .itl file in ");
  refused("--nonsense " + samples, "nonsense");
  refused(GRAZE_ITF1788 "/wrong/syntax.itl",
          GRAZE_ITF1788 "/wrong/syntax.itl:5: expected a literal, found 'sub'");
  // nothing is printed of the good files before
  refused(samples + " " GRAZE_ITF1788 "/wrong/syntax.itl", "syntax.itl:5: ");
  std::ofstream(dir / "unreadable.itl") << "testcase t { f = 1.0; }";
  std::filesystem::permissions(dir / "unreadable.itl", std::filesystem::perms::none);
  if (geteuid() != 0)
    refused(dir / "unreadable.itl", "cannot read ");
}

TEST_CASE("graze-itf1788: help has examples", "[unit]") {
  const outcome o = call("--help");
  CHECK(o.code == 0);
  CHECK(holds(o.out, "graze-itf1788 ITF1788/itl"));
  CHECK(holds(o.out, "--json"));
  CHECK(holds(o.out, "Exit code: 0"));
}
