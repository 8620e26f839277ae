/// graze-fuzz as its users meet it: output, exit codes, bad input.
#include "../support/program.hpp"
#include <array>
#include <nlohmann/json.hpp>

namespace {

using support::outcome, support::scratch, support::content;

outcome call(const std::string& arguments, const std::string& before = "timeout 600 ") {
  return support::call(GRAZE_FUZZ, arguments, before);
}

void refused(const std::string& arguments, const std::string& reason) {
  support::refused(GRAZE_FUZZ, arguments, reason);
}

std::string file_with(const scratch& dir, const std::string& text) {
  std::ofstream(dir / "rays.jsonl") << text;
  return dir / "rays.jsonl";
}

const std::string good =
    R"({"origin":["0x1p-2","0x1p-2","0x0p+0"],"direction":["0x0p+0","0x0p+0","0x1p+0"],"octant":{"lo":["0x0p+0","0x0p+0","0x0p+0"],"size":"0x1p-1"}})";

} // namespace

TEST_CASE("graze-fuzz run: nothing found on sound, exit code 0", "[unit]") {
  const outcome o = call("run --rays 20000");
  CHECK(o.code == 0);
  CHECK(o.out.find("nothing found") != std::string::npos);
  CHECK(o.out.find("mid-plane") != std::string::npos);
  CHECK(o.err.empty());
}

TEST_CASE("graze-fuzz run: --json prints one object with what is promised", "[unit]") {
  const outcome o = call("run --rays 20000 --level 50 --traversal gargantini --seed 9 --json");
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["traversal"] == "gargantini");
  CHECK(object["level"] == 50);
  CHECK(object["seed"] == 9);
  CHECK(object["rays"] == 20000);
  for (const char* key : {"touched", "misses", "gaps"})
    CHECK(object[key] > 0);
  CHECK(object["spurious"].is_number());
  CHECK(object["order_errors"].is_number());
  CHECK(object["rays_per_second"] > 0);
  CHECK(object["first_miss_seconds"] >= 0);
  CHECK(object["counterexample"].contains("octant"));
  CHECK(object["generators"].size() == 19);
  for (const auto& counted : object["generators"])
    CHECK(counted.contains("spurious_rate"));
  const auto clean =
      nlohmann::json::parse(call("run --rays 2000 --json --generator vertex,random").out);
  CHECK(clean["counterexample"].is_null());
  CHECK(clean["first_miss_seconds"].is_null());
  CHECK(clean["generators"].size() == 2);
}

TEST_CASE("graze-fuzz run: the saved counterexample replays", "[unit]") {
  const scratch dir;
  const std::string file = dir / "miss.jsonl";
  CHECK(call("run --rays 20000 --traversal published --save " + file).code == 1);
  const outcome o = call("replay " + file + " --traversal published --json");
  CHECK(o.code == 1);
  const auto replayed = nlohmann::json::parse(o.out);
  CHECK(replayed["touches"] == true);
  CHECK(replayed["crosses"] == true);
  CHECK(replayed["visited"] == false);
  CHECK(call("replay " + file).code == 0);
  CHECK_FALSE(std::filesystem::exists(file + ".part"));
}

TEST_CASE("graze-fuzz run: bad input is one line and exit code 2", "[unit]") {
  refused("run --traversal nobody", "no traversal is called \"nobody\"");
  refused("run --generator nothing", "no generator is called \"nothing\"");
  refused("run --level 0", "level 0 is outside 1..53");
  refused("run --level 54", "level 54 is outside 1..53");
  refused("run --level x", "level x is outside 1..53");
  for (const char* range : {"5-4", "0-4", "4-54", "4-", "-4", "1-2-3", "1-x"})
    refused(std::string("run --level=") + range, "is outside 1..53");
  refused("run --seconds nan", "--seconds");
  refused("run --seconds -1", "--seconds");
  refused("run --rays -5", "--rays");
  refused("run --seed -1", "--seed");
  refused("run --threads 0", "--threads");
  for (const char* size : {"0", "-1", "nan"})
    refused(std::string("run --scene map.npy --voxel-size=") + size,
            "--voxel-size is not a length above 0");
  refused("run --save /no/such/folder/miss.jsonl", "cannot write");
  refused("run --nonsense", "nonsense");
  refused("", "subcommand");
  refused("walk", "");
}

TEST_CASE("graze-fuzz run: a climb is reported, saved and replayed as any search", "[unit]") {
  const scratch dir;
  const std::string file = dir / "miss.jsonl";
  const std::string random =
      "run --traversal plain --level 10 --generator random --rays 5000 --json ";
  CHECK(call(random).code == 0);
  const outcome o = call(random + "--search climb --until-finding --save " + file);
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["search"] == "climb");
  CHECK(object["rays"] <= 5000);
  CHECK(object["generators"][0]["generator"] == "random");
  CHECK(call("replay " + file + " --traversal plain").code == 1);
  CHECK(call("run --traversal plain --generator random --search climb --rays 2000")
            .out.find("(random):") != std::string::npos);
  refused("run --search walk", "--search");
  // a campaign keeps it in its plan
  const std::string folder = dir / "campaign";
  CHECK(call("campaign " + folder +
             " --traversal plain --level 10 --search climb --rays 5000 --piece "
             "1000")
            .code == 1);
  CHECK(call("campaign " + folder).code == 1);
  refused("campaign " + folder + " --search generators", "search is \"climb\", not \"generators\"");
  refused("campaign " + (dir / "other") + " --search walk", "no search is called");
}

TEST_CASE("graze-fuzz run: an interrupt ends it early, with its summary", "[unit]") {
  const scratch dir;
  // interrupted once it says that rays were done, however long that takes
  const std::string command = "'" GRAZE_FUZZ "' run --seconds 1000000 --json --progress >" +
                              (dir / "out") + " 2>" + (dir / "err") +
                              " & pid=$!; until grep -q '[1-9][0-9.]* [kM]*rays  ' " +
                              (dir / "err") + "; do sleep 0.02; done; kill -INT $pid; wait $pid";
  CHECK(std::system(command.c_str()) == 0);
  const auto object = nlohmann::json::parse(support::content(dir / "out"));
  CHECK(object["interrupted"] == true);
  CHECK(object["rays"] > 0);
}

TEST_CASE("graze-fuzz run: each kind of finding names the whole command that repeats it",
          "[unit]") {
  for (const char* search : {"generators", "climb"}) {
    const outcome found =
        call(std::string("run --traversal published --level 10-50 --rays 4000 --seed 3 "
                         "--generator vertex,edge-1 --search ") +
             search);
    CHECK(found.code == 1);
    std::istringstream lines(found.out);
    int commands = 0;
    for (std::string line; std::getline(lines, line);) {
      const std::string before = "also ", between = ": again: graze-fuzz ";
      if (!line.starts_with(before))
        continue;
      const auto end = line.find(between);
      REQUIRE(end != std::string::npos);
      const outcome again = call(line.substr(end + between.size()));
      CHECK(again.code == 1);
      CHECK(again.out.find(line.substr(before.size(), end - before.size())) != std::string::npos);
      ++commands;
    }
    CHECK(commands > 0);
  }
}

TEST_CASE("graze-fuzz replay: the recorded cases, line by line", "[unit]") {
  const outcome o = call("replay " GRAZE_CORPUS "/numerics.jsonl --json");
  CHECK(o.code == 0);
  std::istringstream lines(o.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto object = nlohmann::json::parse(line);
    CHECK(object["touches"] == true);
    CHECK(object["visited"] == true);
    CHECK(object["line"] == count + 1);
  }
  CHECK(count == 7);
}

TEST_CASE("graze-fuzz replay: of boxes it is not said who owns a point", "[unit]") {
  const scratch dir;
  const std::string file = dir / "flat.jsonl";
  std::ofstream(file)
      << R"({"box":{"lo":[-1,-1,1],"hi":[1,1,1]},"origin":[0,0,0],"direction":[0.1,0.1,1]})"
      << "\n";
  const outcome o = call("replay --json " + file + " --traversal boxes");
  const auto replayed = nlohmann::json::parse(o.out);
  CHECK(replayed["crosses"] == true);
  CHECK(replayed["owns"].is_null());
  CHECK(call("replay " + file + " --traversal boxes").out.find("owns") == std::string::npos);
}

TEST_CASE("graze-fuzz replay: a corrupt file is one line with its number, and nothing half",
          "[unit]") {
  const scratch dir;
  const auto with_second = [&](const std::string& line) {
    return "replay " + file_with(dir, good + "\n" + line + "\n");
  };
  CHECK(call("replay " + file_with(dir, good + "\n\n" + good)).code == 0);
  refused(with_second("{\"origin\":"), ":2: not JSON");
  refused(with_second("{}"), ":2: no \"origin\"");
  refused(
      with_second(R"({"origin":["nan",0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1}})"),
      ":2: \"origin\"");
  refused(with_second(R"({"origin":[0,0,0],"direction":[0,0,0],"octant":{"lo":[0,0,0],"size":1}})"),
          ":2: ray direction is zero");
  refused(
      with_second(R"({"origin":[0,0,0],"direction":["inf",0,0],"octant":{"lo":[0,0,0],"size":1}})"),
      ":2: \"direction\"");
  refused(with_second(
              R"({"origin":[0,0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":"0x1p-54"}})"),
          ":2: octant size");
  refused("replay " + file_with(dir, ""), "rays.jsonl");
  refused("replay /no/such/file", "/no/such/file");
  refused("replay " + file_with(dir, good) + " --traversal nobody", "nobody");
}

TEST_CASE("graze-fuzz: help has examples, list has names", "[unit]") {
  const outcome help = call("--help");
  CHECK(help.code == 0);
  CHECK(help.out.find("graze-fuzz run --traversal published") != std::string::npos);
  const outcome list = call("list");
  CHECK(list.code == 0);
  for (const char* name :
       {"sound", "published", "plain", "gargantini", "vertex", "mid-plane", "mutant-drops"})
    CHECK(list.out.find(name) != std::string::npos);
}

TEST_CASE("graze-fuzz run --command: what a command that fails writes is shown once",
          "[regression]") {
  const outcome o = call("run --rays 10 --command 'echo it is broken >&2; exit 3'");
  INFO(o.err);
  CHECK(o.code == 2);
  const std::size_t at = o.err.find("it is broken\n"); // the line that refuses has the command
  REQUIRE(at != std::string::npos);
  CHECK(o.err.find("it is broken\n", at + 1) == std::string::npos);
}

TEST_CASE("graze-fuzz run --command: a reader that is an ulp off is told of serde_json's feature",
          "[regression]") {
  support::refused(GRAZE_FUZZ,
                   "run --rays 10 --command 'while read l; do echo \"{\\\"visited\\\":[],"
                   "\\\"echo\\\":[-0.0,0.1,2.0,5e-324,2.2250738585072014e-308,"
                   "1.7976931348623157e308,1e23,9007199254740994.0,0.3333333333333333,"
                   "-0.9836237133425473,0.00010678500163828601,-0.00036151356901086603,"
                   "101.21016800070727,1.0671009529491235e-297,-7.164384684239564e289,"
                   "11354724370.048637]}\"; done'",
                   "float_roundtrip");
}
