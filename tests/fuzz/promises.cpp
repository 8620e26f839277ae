/// Each promise about each kind of cells, asked through the protocol in each form: an exact peer is not
/// accused, one that is wrong is found.
#include "../support/program.hpp"
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace {

nlohmann::json run(const std::string& peer, const std::string& more = "--rays 1500") {
  const auto o = support::call(GRAZE_FUZZ, "run --level 10 --json --no-shrink " + more +
                                               " --command \"'" + EXACT_PEER + "' " + peer + "\"");
  INFO(peer << ": " << o.err);
  CHECK(o.err.empty()); // no notice: the numbers were given back
  REQUIRE((o.code == 0 || o.code == 1));
  return nlohmann::json::parse(o.out);
}

} // namespace

TEST_CASE(
    "fuzz.external: an exact peer is not accused under any promise, of any cells, in any form",
    "[property]") {
  for (const char* cells : {"cube", "grid", "boxes"})
    for (const char* rays : {"rays", "segments"})
      for (const char* promised :
           {"exactly-touched", "exactly-owned", "first", "first-touched", "any", "count"}) {
        if (cells == std::string("boxes") && promised == std::string("exactly-owned"))
          continue; // says nothing of boxes
        for (const char* format : {"plain", "json"}) {
          const std::string peer = std::string(promised) + " " + cells + " " + rays + " " + format;
          const auto said =
              run(peer, promised == std::string("first") ? "--rays 1500 --tame" : "--rays 1500");
          INFO(peer << "\n" << said.dump(1));
          CHECK(said["finding"].is_null());
          CHECK(said["rays"] == 1500);
          CHECK(said["faults"] == 0);
          CHECK(said["declined"] < (promised == std::string("count") ? 1400 : 1));
        }
      }
}

TEST_CASE("fuzz.external: a first hit that is told too late, or not at all, is found",
          "[property]") {
  for (const char* cells : {"cube", "grid", "boxes"})
    for (const char* rays : {"rays", "segments"}) {
      const std::string what = std::string(cells) + " " + rays + " json ";
      CHECK(run("first " + what + "late")["finding"] == "distance");
      CHECK(run("first " + what + "none")["finding"] == "gross-miss");
      CHECK(run("any " + what + "none")["crossed_missed"] > 0);
    }
}

TEST_CASE("graze-fuzz run --cells: what the adapter says is asked where the user does not say",
          "[unit]") {
  const std::string boxes = std::string("run --rays 50 --level 5 --command \"'") + EXACT_PEER +
                            "' first boxes rays json\"";
  CHECK(support::call(GRAZE_FUZZ, boxes).code == 0);
  CHECK(support::call(GRAZE_FUZZ, boxes + " --cells boxes").code == 0);
  support::refused(GRAZE_FUZZ, boxes + " --cells grid",
                   "says cells boxes in its first line, against --cells grid");
  support::refused(GRAZE_FUZZ, boxes + " --segments", "says no segments");
  support::refused(GRAZE_FUZZ, boxes + " --grid /no/such/file", "/no/such/file");
  support::refused(GRAZE_FUZZ, "run --cells spheres", "--cells");
  const std::string owned =
      std::string("run --rays 50 --command \"'") + EXACT_PEER + "' exactly-owned boxes rays json\"";
  support::refused(GRAZE_FUZZ, owned, "says nothing of boxes");
}
