/// Reproducers as tests, in each language whose tools are there: they fail on the adapter that has the fault, and
/// pass on one that is right.
#include "../support/program.hpp"
#include "campaign_of.hpp"
#include <cstdio>
#include <fmt/format.h>
#include <judge/replay.hpp>
#include <report/reproducer/test_file.hpp>
#include <traversal/list.hpp>
#include <trial/replay_line.hpp>

using namespace graze::fuzz;
using support::content, support::outcome, support::scratch;

namespace {

constexpr std::array all_languages{language::rust,       language::go,     language::java,
                                   language::javascript, language::python, language::cpp};

/// The command that runs a test, in its folder; empty where its tools are not there.
std::string runner(language l, const std::string& file) {
  const auto is_there = [](const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0; // NOLINT
  };
  switch (l) {
  case language::rust: {
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    const std::string rustc = is_there("rustc") ? "rustc" : home + "/.cargo/bin/rustc";
    return is_there(rustc) ? rustc + " -D warnings --test " + file + " -o t && ./t" : std::string();
  }
  case language::go:
    return is_there("go") ? "go vet " + file + " && go test " + file : std::string();
  case language::java:
    return is_there("java") && is_there("javac") ? "java " + file : std::string();
  case language::javascript:
    return is_there("node") ? "node --test " + file : std::string();
  case language::python:
    return is_there("python3") ? "python3 " + file : std::string();
  default:
    return is_there("g++")
               ? "g++ -std=c++17 -Wall -Wextra -Wpedantic -Werror " + file + " -o t && ./t"
               : std::string();
  }
}

/// A reproduction of each kind that a mutant has to show, asked of a command.
reproduction of_kind(const char* name, finding kind, const std::string& command) {
  const auto under_test = find_traversal(name)->make();
  for (unsigned k = 0; k < 3000; ++k) {
    const trial t = make_trial(generators()[k % generators().size()], 12, k, 10);
    if ((judge(t, *under_test).findings & bit(kind)) == 0)
      continue;
    reproduction r = reproduction_of(t, *under_test, kind);
    if (!command.empty()) {
      r.external.emplace();
      r.external->command = command;
    }
    return r;
  }
  FAIL("no ray of this kind");
  return {};
}

/// What was compiled for the same text is run again.
outcome run_test(const scratch& dir, const reproduction& r, language l) {
  const std::string file = test_file_name(r, l), text = test_file(r, l);
  std::string command = runner(l, file);
  if (content(dir / file) == text && command.ends_with(" && ./t"))
    command = "./t";
  std::ofstream(dir / file) << text;
  command.insert(0, "cd " + (dir / "") + " && ");
  std::ofstream(dir / "run.sh") << command << "\n";
  return support::call("sh", dir / "run.sh");
}

/// No compiler has refused it, and no interpreter.
bool is_compiled(const std::string& said) {
  for (const char* refusal : {": error:", "\nerror: ", "error[E", "SyntaxError", "[build failed]"})
    if (said.find(refusal) != std::string::npos)
      return false;
  return !said.starts_with("error: ");
}

/// What the adapter answers: a file's lines, whatever it is asked.
std::string answers(const scratch& dir, const std::string& text) {
  std::ofstream(dir / "answers.txt") << text;
  return "cat >/dev/null; cat '" + (dir / "answers.txt") + "'";
}

std::string voxels(const reproduction& r, octant_set set, bool plain = false) {
  std::string text;
  for (octant_set left = set; left != 0; left &= left - 1) {
    const int v = std::countr_zero(left);
    std::string place;
    for (unsigned a = 0; a < 3; ++a) {
      place += a == 0 ? "" : plain ? " " : ",";
      place += std::to_string(r.answered.base[a] + (static_cast<unsigned>(v) >> (2 * a) & 3u));
    }
    text += text.empty() ? "" : plain ? " " : ",";
    text += plain ? "" : "[";
    text += place;
    text += plain ? "" : "]";
  }
  return text;
}

/// As an answer in JSON.
std::string list(const std::string& text) {
  std::string line = "[";
  line += text;
  line += "]\n";
  return line;
}

} // namespace

TEST_CASE("fuzz.test_files: the language is that of the command's words", "[unit]") {
  const std::array<std::pair<const char*, language>, 18> commands{
      {{"cargo run --release", language::rust},
       {"./target/release/walk --plain", language::rust},
       {"rust-script walk.rs", language::rust},
       {"go run ./cmd/walk", language::go},
       {"java -cp x Walk", language::java},
       {"/usr/bin/java Walk.java", language::java},
       {"node walk.mjs", language::javascript},
       {"/opt/walk.js", language::javascript},
       {"deno run walk.ts", language::javascript},
       {"python3 walk.py", language::python},
       {"python3.11 -m walk", language::python},
       {"'./walk.py' x", language::python},
       {"cd x && PYTHONPATH=. python walk", language::python},
       {"./walk", language::cpp},
       {"", language::cpp},
       {"gopher --java", language::cpp},
       {"sh -c 'node walk'", language::javascript},
       {"./algo.so", language::cpp}}};
  for (const auto& [command, l] : commands) {
    INFO(command);
    CHECK(language_of_command(command) == l);
  }
  for (const language l : all_languages)
    CHECK(language_of(name_of(l)) == l);
  CHECK_FALSE(language_of("cobol"));
}

TEST_CASE("fuzz.test_files: each language's test fails on the fault, and passes without it",
          "[unit]") {
  for (const language l : all_languages) {
    const scratch dir;
    INFO(name_of(l));
    reproduction r = of_kind("gargantini", finding::crossed_miss, "");
    if (runner(l, test_file_name(r, l)).empty()) {
      std::printf("graze: %s skipped: its tools are not there\n", std::string(name_of(l)).c_str());
      continue;
    }
    const truth exact = truth_of(r.answered);
    const auto with = [&](const std::string& text) {
      r.external.emplace();
      r.external->command = answers(dir, text);
      const outcome o = run_test(dir, r, l);
      return std::pair(o.code, o.out + o.err);
    };
    // the right answer, as each form, after a greeting
    for (const std::string& right :
         {list(voxels(r, exact.touched)),
          fmt::format("{{\"promise\":\"crossed\"}}\n{{\"id\":0,\"visited\":[{}],\"received\":"
                      "{{\"origin\":[0.5,1,2],\"direction\":[1,2,3]}}}}\n",
                      voxels(r, exact.touched)),
          fmt::format("promise crossed\n{} received 0x1p-3 1 2 3 4 5\n",
                      voxels(r, exact.touched, true)),
          "{\"float\":false,\"batch\":1}\n" + list(voxels(r, exact.touched)),
          fmt::format("echo true\n{}\n", voxels(r, exact.touched, true))}) {
      const auto [code, said] = with(right);
      INFO(right << said);
      CHECK(code == 0);
    }
    for (const std::string& wrong : {list(voxels(r, r.answer.set())), std::string("[]\n"),
                                     std::string("{\"skip\":true}\n"), std::string("\n")}) {
      const auto [code, said] = with(wrong);
      INFO(wrong << said);
      CHECK(code != 0);
      CHECK(is_compiled(said));
      CHECK(said.find("{voxel:?}") == std::string::npos); // as of Rust before 2021
    }
    const auto [code, said] = with("");
    CHECK(code != 0);
    INFO(said);
    CHECK(said.find("the program ended before it answered") != std::string::npos);
    // nothing to ask: a function is left to be filled in
    r.external.reset();
    const outcome empty = run_test(dir, r, l);
    CHECK(empty.code != 0);
    CHECK((empty.out + empty.err).find("put your traversal into visited") != std::string::npos);
  }
}

TEST_CASE("fuzz.test_files: every kind of finding is a test that holds by the right answer alone",
          "[unit]") {
  struct example {
    const char* name;
    finding kind;
  };
  for (const auto& [name, kind] :
       {example{"gargantini", finding::gross_miss}, example{"gargantini", finding::gap},
        example{"gargantini", finding::seam}, example{"mutant-exact", finding::miss},
        example{"mutant-reversed", finding::order}, example{"mutant-twice", finding::revisit},
        example{"mutant-everything", finding::far_spurious},
        example{"mutant-inexact", finding::spurious}}) {
    const scratch dir;
    reproduction r = of_kind(name, kind, "");
    INFO(name << " " << name_of(kind));
    const language l = language::python;
    if (runner(l, "x").empty())
      return;
    const auto sound =
        find_traversal(promises_owned(r.promises) ? "exact" : "exact-closed")->make();
    const auto line_of = [&](const visited& answer, bool twice) {
      std::string text;
      for (unsigned i = 0; i < answer.size(); ++i)
        text += fmt::format("{}{}", text.empty() ? "" : ",", voxels(r, octant_set{1} << answer[i]));
      return list(twice ? fmt::format("{0},{0}", text) : text);
    };
    visited right;
    ask(*sound, r.answered, right);
    r.external.emplace();
    r.external->command = answers(dir, line_of(right, false));
    const outcome good = run_test(dir, r, l);
    INFO(good.err);
    CHECK(good.code == 0);
    r.external->command = answers(dir, line_of(r.answer, kind == finding::revisit));
    CHECK(run_test(dir, r, l).code != 0);
  }
}

namespace {

/// Gives one answer, whatever it is asked.
struct set_answer final : traversal {
  promise promised = promise::first;
  std::vector<octant_number> cells;
  remarks told;
  [[nodiscard]] std::string_view name() const override { return "set"; }
  [[nodiscard]] promise promises() const override { return promised; }
  [[nodiscard]] bool takes(cell_kind /*cells*/, bool /*segment*/) const override { return true; }
  void visit(const trial& /*t*/, visited& out) override {
    for (const octant_number v : cells)
      out.push(v);
    out.said() = told;
  }
};

struct scene {
  const char *about, *line;
  promise promised;
  finding kind;
  std::vector<octant_number> cells; ///< the answer of the finding
  remarks told;
  std::vector<std::string> right, wrong;
};

std::vector<scene> scenes() {
  const char* boxes = R"({"origin":[0,0.5,0.5],"direction":[2,0,0],"boxes":[)"
                      R"({"lo":[3,0,0],"hi":[4,1,1]},{"lo":[1,0,0],"hi":[2,1,1]}]})";
  const char* grid = R"({"origin":[0.15,0.25,-1],"direction":[0,0,1],"grid":{"origin":[0,0,0],)"
                     R"("spacing":[0.1,0.1,0.1],"count":[5,5,9],"planes":"added"},)"
                     R"("voxel":[1,2,3],"extent":[1,1,2]})";
  const char* segment = R"({"origin":[0,0.5,0.5],"end":[5,0.5,0.5],"boxes":[)"
                        R"({"lo":[3,0,0],"hi":[4,1,1]},{"lo":[1,0,0],"hi":[2,1,1]}]})";
  remarks late, aside, yes, three;
  late.t = 0.75;
  aside.entered = face{1, false};
  yes.hit = false;
  three.crossings = 3;
  return {{"t of boxes",
           boxes,
           promise::first,
           finding::distance,
           {1},
           late,
           {R"({"id":0,"first":1,"t":0.5})", R"({"t":0.5,"first":1.0,"distance":1})",
            R"({"t":"0x1p-1","first":1,"echo":[0.1,2]})", R"({"t":"3fe0000000000000","first":1})",
            "1 t 0x1p-1 distance 1 face -x id 0", "1 distance 1.0"},
           {R"({"t":0.75,"first":1})", R"({"t":0.5,"first":0})", R"({"first":1})", "1 t 0x1.8p-1",
            R"({"t":0.5,"first":1,"distance":2})", R"({"t":null,"first":1})", "none"}},
          {"face of boxes",
           boxes,
           promise::first,
           finding::face,
           {1},
           aside,
           {R"({"face":"-x","first":1})", "1 face -x"},
           {R"({"face":"-y","first":1})", "1 face +x", R"({"first":1,"face":null})", "1"}},
          {"first of a grid",
           grid,
           promise::first,
           finding::crossed_miss,
           {},
           {},
           {R"({"id":0,"first":[1,2,3]})",
            R"({"first":[1,2,3],"received":{"origin":[0,8,9],)"
            R"("direction":[1,2,3]}})",
            "1 2 3 t 1.3 id 0", "[[1,2,3]]"},
           {R"({"first":null,"id":0})", "none id 0", R"({"first":[1,2,4]})", "1 2 8", "null",
            R"({"first":[1,2,3],"id":7})", R"({"first":[1,2,3],"near":1})"}},
          {"any of segments",
           segment,
           promise::any,
           finding::crossed_miss,
           {},
           yes,
           {R"({"hit":true})", "true", "1 id 0"},
           {R"({"hit":false})", "false", "0"}},
          {"count of segments",
           segment,
           promise::count,
           finding::count,
           {},
           three,
           {R"({"count":4,"id":0})", "4"},
           {"3", R"({"count":2})"}}};
}

} // namespace

TEST_CASE("fuzz.test_files: tests of grids, boxes and segments read each form of each promise",
          "[regression]") {
  for (const language l : all_languages) {
    if (runner(l, "x").empty())
      continue;
    for (const scene& s : scenes()) {
      INFO(name_of(l) << " " << s.about);
      const auto t = from_json_line(s.line);
      REQUIRE(t);
      set_answer under_test;
      under_test.promised = s.promised;
      under_test.cells = s.cells;
      under_test.told = s.told;
      reproduction r = reproduction_of(*t, under_test, s.kind);
      REQUIRE((r.judged.findings & bit(s.kind)) != 0);
      const scratch dir;
      r.external.emplace();
      const auto code = [&](const std::string& line) {
        r.external->command = answers(dir, "promise first cells boxes\n" + line + "\n");
        const outcome o = run_test(dir, r, l);
        INFO(line << "\n" << o.out << o.err);
        CHECK(is_compiled(o.out + o.err));
        return o.code;
      };
      for (const std::string& line : s.right) {
        INFO(line);
        CHECK(code(line) == 0);
      }
      for (const std::string& line : s.wrong) {
        INFO(line);
        CHECK(code(line) != 0);
      }
    }
  }
}

TEST_CASE("fuzz.test_files: the adapter is asked as in a campaign", "[regression]") {
  const auto t = from_json_line(scenes()[0].line);
  set_answer under_test;
  reproduction r = reproduction_of(*t, under_test, finding::crossed_miss);
  r.external.emplace();
  r.external->command = "x";
  r.external->format = line_format::bits;
  r.external->echo = true;
  const std::string text = test_file(r, language::python);
  CHECK(text.find("REQUEST = \"0 boxes 0000000000000000 3fe0000000000000") != std::string::npos);
  CHECK(text.find("echo 8000000000000000") != std::string::npos);
  CHECK(text.find("BITS, NEEDS_RECEIVED = True, False") != std::string::npos);
  r.external->format = line_format::json;
  r.external->batch = 64;
  CHECK(test_file(r, language::python).find(R"(REQUEST = "{\"batch\":[{\"id\":0,)") !=
        std::string::npos);
  // what a campaign is started with has taken over the first line
  external_options options;
  options.command = "echo promise first cells boxes numbers bits; while read l; do echo none; done";
  const auto entry = external_traversal(options);
  REQUIRE(entry);
  REQUIRE(entry->external);
  CHECK(entry->external->format == line_format::bits);
  CHECK_FALSE(entry->external->echo);
}

TEST_CASE("fuzz.test_files: a hang is told as one, by its test and by its text", "[unit]") {
  reproduction r = of_kind("gargantini", finding::gross_miss, "cat >/dev/null; sleep 1000");
  r.external->seconds_a_ray = 0.1;
  for (const finding kind : {finding::hang, finding::crash, finding::exception, finding::malformed,
                             finding::not_a_number}) {
    r.kind = kind;
    r.subject = 0;
    for (const std::string& text :
         {reproducer_text(r), reproducer_snippet(r), test_file(r, language::cpp)}) {
      INFO(text);
      CHECK(text.find(sentence_of(kind)) != std::string::npos);
      CHECK(text.find("for nothing") == std::string::npos);
      CHECK(text.find("missed") == std::string::npos);
    }
  }
  r.kind = finding::hang;
  const scratch dir;
  for (const language l : all_languages) {
    if (runner(l, "x").empty())
      continue;
    const outcome o = run_test(dir, r, l);
    INFO(name_of(l) << o.out << o.err);
    CHECK(o.code != 0);
    CHECK((o.out + o.err).find("no answer within 2 s") != std::string::npos);
  }
}

TEST_CASE("fuzz.test_files: a hostile command stays within its string and its comment", "[unit]") {
  reproduction r = of_kind("gargantini", finding::gross_miss, "");
  const std::string hostile = "echo \"$0\" \\u0022; /* */ //\\\n'x' %s {} ?"
                              "?/ \t\x01 \xff `` ${x} #\"#";
  r.traversal = hostile;
  r.options = "--command " + shell_word(hostile);
  r.external.emplace();
  r.external->command = hostile;
  for (const language l : all_languages) {
    const scratch dir;
    INFO(name_of(l));
    if (runner(l, "x").empty())
      continue;
    const outcome o = run_test(dir, r, l);
    INFO(o.out << o.err);
    CHECK(o.code != 0);
    CHECK(is_compiled(o.out + o.err));
    CHECK(test_file_name(r, l).size() < 140);
  }
}

TEST_CASE("graze-fuzz: --language, and what is guessed of the command", "[unit]") {
  const scratch dir;
  const std::string command =
      "--command 'while read l; do echo \"[]\"; done # walk.mjs' --level 10 ";
  CHECK(support::call(GRAZE_FUZZ, "run --rays 40 --no-shrink --seconds 20 " + command +
                                      "--reproducer " + (dir / "a"))
            .code == 1);
  CHECK(support::call(GRAZE_FUZZ, "run --rays 40 --no-shrink --seconds 20 --language java " +
                                      command + "--reproducer " + (dir / "b"))
            .code == 1);
  const auto ending = [](const std::string& folder, const std::string& wanted) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().string().ends_with(wanted))
        return entry.path().string();
    return std::string();
  };
  CHECK(content(ending(dir / "a", ".test.mjs")).find("while read l") != std::string::npos);
  CHECK_FALSE(ending(dir / "b", ".java").empty());
  support::refused(GRAZE_FUZZ, "run --language cobol", "--language");
}
