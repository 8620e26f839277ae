/// --reproducer as its users meet it.
#include "../support/program.hpp"
#include <nlohmann/json.hpp>

namespace {

using support::outcome, support::scratch, support::content;

/// The one file of the folder with this ending.
std::string only(const std::string& folder, const std::string& ending) {
  std::string found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ending && !entry.path().string().ends_with("_test.cpp")) {
      CHECK(found.empty());
      found = entry.path().string();
    }
  return found;
}

} // namespace

TEST_CASE("graze-fuzz run: --reproducer writes what replay takes", "[unit]") {
  const scratch dir;
  const outcome o = support::call(GRAZE_FUZZ, "run --rays 20000 --traversal gargantini "
                                              "--reproducer " +
                                                  (dir / "out"));
  CHECK(o.code == 1);
  CHECK(o.out.find("reproducer: ") != std::string::npos);
  for (const char* ending : {".json", ".txt", ".cpp", ".svg"})
    CHECK_FALSE(content(only(dir / "out", ending)).empty());
  const std::string line = only(dir / "out", ".json");
  const outcome again =
      support::call(GRAZE_FUZZ, "replay " + line + " --traversal gargantini --json --reproducer " +
                                    (dir / "again"));
  CHECK(again.code == 1);
  const std::string worst = nlohmann::json::parse(again.out)["findings"][0];
  CHECK((worst == "crossed-miss" || worst == "gross-miss"));
  // what is as small as it gets stays what it is
  CHECK(content(only(dir / "again", ".json")) == content(line));
}

TEST_CASE("graze-fuzz replay: --reproducer writes nothing where nothing is found", "[unit]") {
  const scratch dir;
  const outcome o = support::call(GRAZE_FUZZ, "replay " GRAZE_CORPUS "/numerics.jsonl "
                                              "--reproducer " +
                                                  (dir / "out"));
  CHECK(o.code == 0);
  CHECK(std::filesystem::is_empty(dir / "out"));
}

TEST_CASE("graze-fuzz: a reproducer's folder that cannot be made is one line and exit code 2",
          "[unit]") {
  const std::string within_a_file = GRAZE_CORPUS "/numerics.jsonl/out";
  support::refused(GRAZE_FUZZ, "run --reproducer " + within_a_file, "cannot make the folder");
  support::refused(GRAZE_FUZZ,
                   "replay " GRAZE_CORPUS "/numerics.jsonl --reproducer " + within_a_file,
                   "cannot make the folder");
}
