/// --reproducer as its users meet it.
#include "../support/program.hpp"
#include <fstream>
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

TEST_CASE("graze-fuzz run --grid: what asks again names the grid, and shrinking keeps it",
          "[regression]") {
  const scratch dir;
  const std::string grid =
      R"({"origin":["0x1.9p+3","-0x1.4p+2","0x0p+0"],"spacing":["0x1.999999999999ap-4",)"
      R"("0x1.999999999999ap-4","0x1.999999999999ap-3"],"count":[30,40,20],"planes":"multiplied"})";
  std::ofstream(dir / "my grid.json") << grid;
  const std::string command = "--promise crossed --command 'while read l; do echo \"[]\"; done'";
  const outcome o = support::call(
      GRAZE_FUZZ, "run --rays 300 --seconds 30 " + command + " --grid '" + (dir / "my grid.json") +
                      "' --save-all " + (dir / "all") + " --junit " + (dir / "junit"));
  INFO(o.out << o.err);
  CHECK(o.code == 1);
  CHECK(o.out.find("also crossed-miss: again: graze-fuzz run ") != std::string::npos);
  CHECK(o.out.find(" --grid '" + (dir / "my grid.json") + "'") != std::string::npos);
  CHECK(o.out.find("level") == std::string::npos);
  CHECK(content(dir / "junit").find("my grid.json") != std::string::npos);
  const auto line = nlohmann::json::parse(content(dir / "all/gross-miss.jsonl"));
  CHECK(line["grid"] == nlohmann::json::parse(grid));
  CHECK(o.out.find("\nanswered no cell; missed [") != std::string::npos);
}

TEST_CASE("graze-fuzz: what was answered is told, and what is right; long lists of boxes are cut",
          "[regression]") {
  const scratch dir;
  const std::string boxes = "--command 'while read l; do echo none; done' --promise first "
                            "--cells boxes ";
  const outcome o = support::call(GRAZE_FUZZ, "run --rays 2000 --tame --no-shrink --seconds 30 " +
                                                  boxes + "--reproducer " + (dir / "out"));
  INFO(o.out << o.err);
  CHECK(o.code == 1);
  CHECK(o.out.find("\nanswered first none; right: ") != std::string::npos);
  CHECK(o.out.find("shrunk:") == std::string::npos);
  CHECK(o.out.find(" judged") != std::string::npos);
  CHECK(o.err.find("no test") == std::string::npos);
  const std::string text = content(only(dir / "out", ".txt"));
  CHECK(text.find("\nanswer     answered first none; right: ") != std::string::npos);
  CHECK(o.out.find("_test.cpp") != std::string::npos);
  const std::string line = only(dir / "out", ".json");
  const outcome again =
      support::call(GRAZE_FUZZ, "replay " + line + " " + boxes.substr(0, boxes.find("--cells")));
  INFO(again.out << again.err);
  CHECK(again.out.find("; answered first none; right: ") != std::string::npos);
  std::string many = R"({"origin":[0,0.5,0.5],"direction":[1,0,0],"boxes":[)";
  for (int i = 0; i < 47; ++i)
    many += (i == 0 ? "" : ",") + std::string(R"({"lo":[1,0,0],"hi":[2,1,1]})");
  std::ofstream(dir / "many.jsonl") << many << "]}\n";
  const outcome wide = support::call(GRAZE_FUZZ, "replay " + (dir / "many.jsonl") + " " +
                                                     boxes.substr(0, boxes.find("--cells")));
  CHECK(wide.out.find("... 35 more or none") == std::string::npos);
  CHECK(wide.out.size() < 400);
}

TEST_CASE("graze-fuzz: a reproducer's folder that cannot be made is one line and exit code 2",
          "[unit]") {
  const std::string within_a_file = GRAZE_CORPUS "/numerics.jsonl/out";
  support::refused(GRAZE_FUZZ, "run --reproducer " + within_a_file, "cannot make the folder");
  support::refused(GRAZE_FUZZ,
                   "replay " GRAZE_CORPUS "/numerics.jsonl --reproducer " + within_a_file,
                   "cannot make the folder");
}
