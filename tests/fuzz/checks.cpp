/// graze-fuzz in other people's CI: several files, baselines, JUnit, SARIF, annotations, --version.
#include "../support/program.hpp"
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>
#include <report/checks/baseline.hpp>
#include <set>

using namespace graze::fuzz;
using nlohmann::json;
using support::content, support::outcome, support::scratch;

namespace {

outcome call(const std::string& arguments) { return support::call(GRAZE_FUZZ, arguments); }

const std::string corpus = GRAZE_CORPUS "/numerics.jsonl";

/// The lines of the recorded cases, each in a file of its own: b.json, a.jsonl, ...
void write_rays(const scratch& dir) {
  std::filesystem::create_directories(dir / "rays/deeper");
  std::istringstream lines(content(corpus));
  std::string line;
  for (const char* name : {"b.json", "a.jsonl", "c.jsonl"}) {
    std::getline(lines, line);
    std::ofstream(dir / (std::string("rays/") + name)) << line << "\n";
  }
  std::getline(lines, line);
  std::ofstream(dir / "more.jsonl") << "\n" << line << "\n";
  std::ofstream(dir / "rays/notes.txt") << "no rays\n";
}

/// Every element, in order.
using boost::property_tree::ptree;
ptree xml(const std::string& text) {
  INFO(text);
  std::istringstream in(text);
  ptree tree;
  REQUIRE_NOTHROW(boost::property_tree::read_xml(in, tree));
  return tree;
}

const std::string run = "run --traversal gargantini --level 10 --rays 4000 --seed 3 ";

} // namespace

TEST_CASE("graze-fuzz: --version, of subcommands too", "[unit]") {
  const std::string version = call("--version").out;
  CHECK(version.starts_with("graze-fuzz "));
  for (const char* subcommand : {"run", "replay", "campaign", "summary", "self", "list"}) {
    const outcome o = call(std::string(subcommand) + " --version");
    CHECK(o.code == 0);
    CHECK(o.out == version);
  }
}

TEST_CASE("graze-fuzz replay: files and folders, each line by its place", "[unit]") {
  const scratch dir;
  write_rays(dir);
  const outcome o = call("replay " + (dir / "rays") + " " + (dir / "more.jsonl") +
                         " --traversal published --json");
  CHECK(o.code == 1);
  std::istringstream lines(o.out);
  std::vector<std::string> places;
  for (std::string line; std::getline(lines, line);) {
    const json object = json::parse(line);
    places.push_back(object["file"].get<std::string>().substr((dir / "").size()) + ":" +
                     std::to_string(object["line"].get<int>()));
  }
  CHECK(places == std::vector<std::string>{"rays/a.jsonl:1", "rays/b.json:1", "rays/c.jsonl:1",
                                           "more.jsonl:2"});
  CHECK(call("replay " + (dir / "rays")).code == 0); // sound
  CHECK(
      call("replay " + (dir / "rays") + " --traversal published").out.find("a.jsonl:1: touches") !=
      std::string::npos);
  // one file is told as ever
  CHECK(call("replay " + (dir / "more.jsonl")).out.starts_with("line 2: touches"));

  support::refused(GRAZE_FUZZ, "replay " + (dir / "rays/deeper"), "holds no replay file");
  support::refused(GRAZE_FUZZ, "replay " + (dir / "rays") + " " + (dir / "none.jsonl"),
                   "none.jsonl");
  std::ofstream(dir / "rays/z.json") << "{}\n";
  support::refused(GRAZE_FUZZ, "replay " + (dir / "rays"), "z.json:1");
  // but a baseline that lies there is none of the rays
  CHECK(call("replay " + corpus + " --write-baseline " + (dir / "rays/z.json")).code == 0);
  CHECK(call("replay " + (dir / "rays")).code == 0);
}

TEST_CASE("graze-fuzz replay: a campaign's folder, and its findings", "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign";
  CHECK(call("campaign " + folder + " --traversal gargantini --level 10 --rays 3000 --piece 1000")
            .code == 1);
  const outcome whole = call("replay " + folder + " --traversal gargantini");
  const outcome findings = call("replay " + folder + "/findings --traversal gargantini");
  CHECK(whole.code == 1);
  CHECK(whole.out == findings.out);
  CHECK(std::count(whole.out.begin(), whole.out.end(), '\n') >= 3);
  CHECK(call("replay " + folder).code == 0);
}

TEST_CASE("graze-fuzz replay: with a baseline only what is new fails", "[unit]") {
  const scratch dir;
  write_rays(dir);
  const std::string replay = "replay --traversal published " + (dir / "rays");
  const std::string known = dir / "known.json";
  CHECK(call(replay).code == 1);
  CHECK(call(replay + " --write-baseline " + known).code == 0);
  const outcome same = call(replay + " --baseline " + known);
  CHECK(same.code == 0);
  CHECK(same.out.find(" known, 0 new, 0 more, 0 gone") != std::string::npos);
  // a line more
  const outcome one_more = call(replay + " " + (dir / "more.jsonl") + " --baseline " + known);
  CHECK(one_more.code == 1);
  CHECK(one_more.out.find("\nnew: ") != std::string::npos);
  CHECK(one_more.out.find("more.jsonl:2: ") != std::string::npos);
  // another kind on a line that is known
  json object = json::parse(content(known));
  for (auto& kind : object["lines"][0]["findings"])
    kind = "order";
  std::ofstream(known) << object;
  const outcome other = call(replay + " --baseline " + known);
  CHECK(other.code == 1);
  CHECK(other.out.find("\ngone: ") != std::string::npos);
  // what is mended is gone, and does not fail
  CHECK(call(replay + " --write-baseline " + known).code == 0);
  const outcome mended =
      call("replay --traversal sound " + (dir / "rays") + " --baseline " + known);
  CHECK(mended.code == 0);
  CHECK(mended.out.find("baseline: 0 known, 0 new, 0 more") != std::string::npos);
  CHECK(mended.out.find("\ngone: ") != std::string::npos);
  const outcome as_json =
      call("replay --json --traversal sound " + (dir / "rays") + " --baseline " + known);
  CHECK(json::parse(as_json.out.substr(as_json.out.rfind("{\"baseline\"")))["baseline"]["gone"]
            .size() > 0);
}

TEST_CASE("graze-fuzz run: with a baseline a new kind fails, and more rays than were known",
          "[unit]") {
  const scratch dir;
  const std::string known = dir / "known.json";
  CHECK(call(run + "--write-baseline " + known).code == 0);
  const outcome same = call(run + "--baseline " + known);
  CHECK(same.code == 0);
  CHECK(same.out.find(" known, 0 new, 0 more, 0 gone") != std::string::npos);
  const json baseline = json::parse(content(known));
  CHECK(baseline["campaign"]["rays"] == 4000);
  CHECK(baseline["lines"].size() >= 1);

  const auto with = [&](const auto& change) {
    json changed = baseline;
    change(changed["campaign"]);
    std::ofstream(dir / "changed.json") << changed;
    return call(run + "--json --baseline " + (dir / "changed.json"));
  };
  const auto standing = [](const outcome& o) { return json::parse(o.out)["baseline"]; };
  const outcome fresh = with([](json& c) { c["rays_with"].erase("gross-miss"); });
  CHECK(fresh.code == 1);
  CHECK(standing(fresh)["new"] ==
        json::parse(R"([{"check":"gross-miss","finding":"gross-miss"}])"));
  const outcome more =
      with([](json& c) { c["rays_with"]["gap"] = c["rays_with"]["gap"].get<int>() - 1; });
  CHECK(more.code == 1);
  CHECK(standing(more)["more"][0]["finding"] == "gap");
  const outcome fewer =
      with([](json& c) { c["rays_with"]["gap"] = c["rays_with"]["gap"].get<int>() + 1; });
  CHECK(fewer.code == 0);
  const outcome gone = with([](json& c) { c["rays_with"]["crash"] = 7; });
  CHECK(gone.code == 0);
  CHECK(standing(gone)["gone"][0]["finding"] == "crash");
  // another number of rays: the share counts, and chance is allowed for
  CHECK(with([](json& c) { c["rays"] = 4100; }).code == 0);
  CHECK(with([](json& c) { c["rays"] = 40000; }).code == 1);
  // another plan: kinds alone
  const outcome other = with([](json& c) {
    c["rays_with"]["gap"] = 1;
    c["plan"]["seed"] = 99;
  });
  CHECK(other.code == 0);
  CHECK(other.err.find("seed is 3, not 99") != std::string::npos);
}

TEST_CASE("graze-fuzz campaign: a baseline holds its kinds, and the lines of its findings",
          "[unit]") {
  const scratch dir;
  const std::string made = "campaign " + (dir / "one") +
                           " --traversal gargantini --level 10 --rays 3000 --piece 1000 --seed 8";
  const std::string known = dir / "known.json";
  CHECK(call(made + " --write-baseline " + known).code == 0);
  CHECK(call("campaign " + (dir / "one") + " --baseline " + known).code == 0);
  CHECK(call("summary " + (dir / "one") + " --baseline " + known).code == 0);
  CHECK(call("replay " + (dir / "one") + " --traversal gargantini --baseline " + known).code == 0);
  CHECK(
      call("run --traversal gargantini --level 10 --rays 3000 --seed 8 --baseline " + known).code ==
      0);
  json object = json::parse(content(known));
  object["campaign"]["rays_with"].erase("gap");
  std::ofstream(known) << object;
  const outcome fresh = call("campaign " + (dir / "one") + " --json --baseline " + known);
  CHECK(fresh.code == 1);
  CHECK(fresh.out.find("\"new\":[{\"check\":\"gap\"") != std::string::npos);
}

TEST_CASE("graze-fuzz: a baseline that is none is one line and exit code 2", "[unit]") {
  const scratch dir;
  const auto refused = [&](const std::string& text, const std::string& reason) {
    std::ofstream(dir / "b.json") << text;
    support::refused(GRAZE_FUZZ, run + "--baseline " + (dir / "b.json"), reason);
  };
  refused("", "is not JSON");
  refused("[]", "not a baseline");
  refused("{}", "not a baseline");
  refused(R"({"graze_baseline":2,"campaign":null,"lines":[]})", "not a baseline");
  refused(R"({"graze_baseline":1,"lines":[]})", "campaign");
  refused(R"({"graze_baseline":1,"campaign":null,"lines":[{"ray":{},"findings":[]}]})", "origin");
  refused(
      R"({"graze_baseline":1,"campaign":{"traversal":"x","plan":{},"rays":1,"rays_with":{"x":1}},"lines":[]})",
      "no finding is called \"x\"");
  refused(
      R"({"graze_baseline":1,"campaign":{"traversal":"x","plan":{},"rays":-1,"rays_with":{}},"lines":[]})",
      "rays");
  refused(
      R"({"graze_baseline":1,"campaign":{"traversal":"x","plan":7,"rays":1,"rays_with":{}},"lines":[]})",
      "plan");
  support::refused(GRAZE_FUZZ, run + "--baseline " + (dir / "none.json"), "none.json");
  for (const char* option : {"--write-baseline", "--junit", "--sarif"})
    support::refused(GRAZE_FUZZ, run + option + " /no/such/folder/file", "cannot write");
  support::refused(GRAZE_FUZZ, run + "--json --github", "--github");
}

TEST_CASE("graze-fuzz: JUnit's XML has a case for each kind or line, and fails where it fails",
          "[unit]") {
  const scratch dir;
  CHECK(call(run + "--junit " + (dir / "r.xml")).code == 1);
  const ptree suite = xml(content(dir / "r.xml")).get_child("testsuites.testsuite");
  unsigned cases = 0, failures = 0;
  for (const auto& [name, child] : suite)
    if (name == "testcase") {
      ++cases;
      failures += static_cast<unsigned>(child.count("failure"));
      CHECK(finding_of(child.get<std::string>("<xmlattr>.name")).has_value());
    }
  CHECK(cases == finding_kinds);
  CHECK(failures >= 4);
  CHECK(suite.get<unsigned>("<xmlattr>.failures") == failures);
  CHECK(suite.get<unsigned>("<xmlattr>.tests") == cases);
  // what is known is skipped, with a word
  CHECK(call(run + "--write-baseline " + (dir / "known.json")).code == 0);
  CHECK(call(run + "--baseline " + (dir / "known.json") + " --junit " + (dir / "k.xml")).code == 0);
  const ptree known = xml(content(dir / "k.xml")).get_child("testsuites.testsuite");
  CHECK(known.get<unsigned>("<xmlattr>.failures") == 0);
  CHECK(known.get<unsigned>("<xmlattr>.skipped") == failures);
  // lines of a file whose name is hostile
  write_rays(dir);
  const std::string odd = dir / "a<b>&\"c\x01.jsonl";
  std::filesystem::copy_file(corpus, odd);
  CHECK(call("replay '" + odd + "' --traversal published --junit " + (dir / "p.xml")).code == 1);
  const ptree lines = xml(content(dir / "p.xml")).get_child("testsuites.testsuite");
  CHECK(lines.get<unsigned>("<xmlattr>.tests") == 7);
  CHECK(lines.get<unsigned>("<xmlattr>.failures") >= 6);
}

TEST_CASE("graze-fuzz: SARIF has the members that its schema requires", "[unit]") {
  const scratch dir;
  write_rays(dir);
  CHECK(call("replay --traversal published " + (dir / "rays") + " --write-baseline " +
             (dir / "k.json"))
            .code == 0);
  CHECK(call("replay --traversal published " + (dir / "rays") + " " + (dir / "more.jsonl") +
             " --baseline " + (dir / "k.json") + " --sarif " + (dir / "r.sarif"))
            .code == 1);
  const json log = json::parse(content(dir / "r.sarif"));
  CHECK(log["version"] == "2.1.0");
  REQUIRE(log["runs"].size() == 1);
  const json& tool = log["runs"][0]["tool"]["driver"];
  CHECK(tool["name"] == "graze-fuzz");
  CHECK(call("--version").out == "graze-fuzz " + tool["version"].get<std::string>() + "\n");
  std::set<std::string> states, fingerprints;
  REQUIRE(log["runs"][0]["results"].size() > 4);
  for (const json& result : log["runs"][0]["results"]) {
    CHECK(tool["rules"][result["ruleIndex"].get<unsigned>()]["id"] == result["ruleId"]);
    CHECK_FALSE(result["message"]["text"].get<std::string>().empty());
    const json& place = result["locations"][0]["physicalLocation"];
    CHECK(place["artifactLocation"]["uri"].get<std::string>().starts_with("file:///"));
    CHECK(place["region"]["startLine"] >= 1);
    states.insert(result["baselineState"]);
    CHECK((result["level"] == "error") == (result["baselineState"] == "new"));
    fingerprints.insert(result["partialFingerprints"]["grazeFinding/v1"]);
  }
  CHECK(states == std::set<std::string>{"new", "unchanged"});
  CHECK(fingerprints.size() == log["runs"][0]["results"].size());
  // against the schema itself, where python3's jsonschema and a copy of it are there
  CHECK(call(run + "--sarif " + (dir / "run.sarif")).code == 1);
  CHECK(json::parse(content(dir / "run.sarif"))["runs"][0]["results"].size() >= 4);
  for (const char* file : {"r.sarif", "run.sarif"}) {
    const outcome checked = support::call("python3", SARIF_CHECK " " + (dir / file));
    INFO(checked.out << checked.err);
    CHECK(checked.code == 0);
  }
}

TEST_CASE("graze-fuzz: annotations point at the ray's line, and are escaped", "[unit]") {
  const scratch dir;
  write_rays(dir);
  const std::string odd = dir / "50%,a:b.jsonl";
  std::filesystem::copy_file(corpus, odd);
  const outcome o = call("replay --traversal published --github '" + odd + "'");
  CHECK(o.code == 1);
  CHECK(o.out.find("\n::error file=" + (dir / "50%25%2Ca%3Ab.jsonl") +
                   ",line=2,title=graze-fuzz%3A ") != std::string::npos);
  std::istringstream lines(o.out);
  unsigned errors = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("::")) {
      ++errors;
      CHECK(line.starts_with("::error file="));
      CHECK(line.find("%0Areplay: echo '{") != std::string::npos);
    }
  CHECK(errors >= 6);
  CHECK(call("replay --traversal published '" + odd + "' --write-baseline " + (dir / "k.json"))
            .code == 0);
  const outcome known =
      call("replay --traversal published --github '" + odd + "' --baseline " + (dir / "k.json"));
  CHECK(known.code == 0);
  CHECK(known.out.find("::notice file=") != std::string::npos);
  CHECK(known.out.find("::error") == std::string::npos);
  check_report hostile{"replay", "x"};
  hostile.checks.push_back({"a\n::error::b", {}});
  hostile.checks[0].problems.push_back(
      {finding::gap, standing::fresh, "a\r\n::set-output b", "c%\n"});
  const std::string text = to_annotations(hostile);
  CHECK(std::count(text.begin(), text.end(), '\n') == 1);
  CHECK(text == "::error title=graze-fuzz%3A gap::a%0D%0A::set-output b%0Ac%25%0A\n");
}
