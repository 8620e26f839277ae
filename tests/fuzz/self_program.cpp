/// `graze-fuzz self` as its users meet it.
#include "../support/program.hpp"
#include <nlohmann/json.hpp>

namespace {

using support::outcome;

outcome call(const std::string& arguments, const std::string& before = "timeout 600 ") {
  return support::call(GRAZE_FUZZ, "self " + arguments, before);
}

} // namespace

TEST_CASE("graze-fuzz self: nothing found, exit code 0, a row a part", "[unit]") {
  const outcome o = call("functions --trials 500");
  CHECK(o.code == 0);
  CHECK(o.out.find("functions, seed 1: 500 trials") != std::string::npos);
  CHECK(o.out.find("  atan2 ") != std::string::npos);
  CHECK(o.out.find("nothing found") != std::string::npos);
  CHECK(o.err.empty());
}

TEST_CASE("graze-fuzz self: --json prints one object a subject", "[unit]") {
  const outcome o = call("loaders batches --trials 300 --seed 7 --first 12 --json --threads 3");
  CHECK(o.code == 0);
  std::istringstream lines(o.out);
  std::string line;
  for (const char* name : {"loaders", "batches"}) {
    REQUIRE(std::getline(lines, line));
    const auto object = nlohmann::json::parse(line);
    CHECK(object["subject"] == name);
    CHECK(object["seed"] == 7);
    CHECK(object["first"] == 12);
    CHECK(object["trials"] == 300);
    CHECK(object["trials_per_second"] > 0);
    CHECK(object["interrupted"] == false);
    CHECK(object["findings"].empty());
    CHECK(object["parts"].size() > 3);
  }
}

TEST_CASE("graze-fuzz self: --list names subjects and parts", "[unit]") {
  const outcome o = call("--list");
  CHECK(o.code == 0);
  for (const char* name : {"intervals", "functions", "voxelizer", "loaders", "batches"})
    CHECK(o.out.find(name) != std::string::npos);
}

TEST_CASE("graze-fuzz self: an interrupt ends it, with its summary", "[unit]") {
  const support::scratch dir;
  // interrupted once it says that trials were done, however long that takes
  const std::string command = "'" GRAZE_FUZZ "' self functions --seconds 1000 --json --progress >" +
                              (dir / "out") + " 2>" + (dir / "err") +
                              " & pid=$!; until grep -q ': [1-9][0-9.]* [kM]*trials  ' " +
                              (dir / "err") + "; do sleep 0.02; done; kill -INT $pid; wait $pid";
  CHECK(std::system(command.c_str()) == 0);
  const auto object = nlohmann::json::parse(support::content(dir / "out"));
  CHECK(object["interrupted"] == true);
  CHECK(object["trials"] > 0);
}

TEST_CASE("graze-fuzz self: bad input is one line and exit code 2", "[unit]") {
  const auto refused = [](const std::string& arguments, const std::string& reason) {
    support::refused(GRAZE_FUZZ, "self " + arguments, reason);
  };
  refused("nobody", "no subject is called \"nobody\"");
  refused("functions --seconds nan", "--seconds");
  refused("functions --trials -5", "--trials");
  refused("functions --threads 0", "--threads");
  refused("functions --timeout 0", "--timeout");
  refused("functions --first 18446744073709551615 --trials 5", "--first");
  refused("--nonsense", "nonsense");
}
