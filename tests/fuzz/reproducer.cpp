/// What a maintainer is handed: the files are whole, say what replay says, compile, and show it.
#include "../support/program.hpp"
#include "campaign_of.hpp"
#include <boost/property_tree/xml_parser.hpp>
#include <cstdio>
#include <functional>
#include <optional>
#include <report/reproducer/reproducer.hpp>
#include <set>
#include <shrink/small_witness.hpp>
#include <traversal/list.hpp>
#include <trial/number.hpp>

using namespace graze::fuzz;
using support::content, support::scratch;

namespace {

const std::array<const char*, 4> endings{".json", ".txt", ".cpp", ".svg"};

/// The recorded miss of "published" at level 50 whose numbers have 53 bits.
reproduction recorded() {
  const auto cases = read_replay_file(GRAZE_CORPUS "/numerics.jsonl");
  REQUIRE(cases);
  return reproduction_of((*cases)[0].at, *find_traversal("published")->make(),
                         finding::crossed_miss);
}

/// The first finding of each kind by each generator.
std::vector<std::pair<trial, finding>> findings_of(traversal& under_test, int level,
                                                   unsigned rays_each) {
  std::vector<std::pair<trial, finding>> all;
  for (const generator& g : generators()) {
    finding_set seen = 0;
    for (unsigned k = 0; k < rays_each; ++k) {
      const trial t = make_trial(g, 41, k, level);
      const finding_set found = judge(t, under_test).findings & ~seen;
      for (unsigned kind = 0; kind < finding_kinds; ++kind)
        if ((found >> kind & 1) != 0)
          all.emplace_back(t, static_cast<finding>(kind));
      seen |= found;
    }
  }
  return all;
}

bool compiler_is_there() {
  if (std::system("command -v g++ >/dev/null 2>&1") == 0) // NOLINT: a test may ask the shell
    return true;
  std::puts("graze: skipped, no g++");
  return false;
}

support::outcome syntax(const std::string& file) {
  return support::call("g++", "-std=c++17 -Wall -Wextra -Wpedantic -Wshadow -Werror "
                              "-Wno-unused -fsyntax-only " +
                                  file);
}

using boost::property_tree::ptree;

/// Every element of the picture, in order.
void each(const ptree& tree, const std::function<void(const std::string&, const ptree&)>& see) {
  for (const auto& [name, child] : tree) {
    see(name, child);
    each(child, see);
  }
}

/// Reads the picture as XML, which throws if it is not, and checks what every picture has.
void check_picture(const std::string& svg) {
  INFO(svg);
  std::istringstream in(svg);
  ptree tree;
  REQUIRE_NOTHROW(boost::property_tree::read_xml(in, tree));
  CHECK(tree.get<std::string>("svg.<xmlattr>.width") == "600");
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf\"") == std::string::npos);
  unsigned missed = 0;
  each(tree, [&](const std::string& name, const ptree& element) {
    missed += element.get<std::string>("<xmlattr>.id", "") == "missed" ? 1 : 0;
    if (name == "text" && element.get<std::string>("<xmlattr>.text-anchor", "").empty()) {
      const auto& text = element.data(); // left-aligned text ends within the picture
      CHECK(static_cast<double>(text.size()) * 6.7 + element.get<double>("<xmlattr>.x") < 620);
    }
  });
  CHECK(missed == 1);
}

} // namespace

TEST_CASE("fuzz.reproducer: five files, each whole, and the line replays to the same finding",
          "[unit]") {
  for (const char* name : {"published", "plain", "gargantini", "mutant-drops", "mutant-reversed",
                           "mutant-everything", "mutant-exact", "mutant-inexact", "mutant-twice"}) {
    const auto under_test = find_traversal(name)->make();
    for (const auto& [t, kind] : findings_of(*under_test, 10, 20)) {
      const scratch dir;
      const auto path = write_reproducer(reproduction_of(t, *under_test, kind), dir / "deep/out");
      INFO(name << " " << name_of(kind) << " " << path.reason());
      REQUIRE(path);
      for (const char* ending : endings)
        CHECK_FALSE(content(path->path + ending).empty());
      CHECK_FALSE(content(path->test).empty());
      unsigned files = 0;
      for ([[maybe_unused]] const auto& entry :
           std::filesystem::directory_iterator(dir / "deep/out"))
        ++files;
      CHECK(files == endings.size() + 1); // and the test; no part of a file is left
      const auto cases = read_replay_file(path->path + ".json");
      REQUIRE(cases);
      REQUIRE(cases->size() == 1);
      CHECK((*cases)[0].at == t);
      CHECK((replay((*cases)[0].at, *under_test).findings & bit(kind)) != 0);
      check_picture(content(path->path + ".svg"));
    }
  }
}

TEST_CASE("fuzz.reproducer: a file that cannot be written is refused, and no part of it is left",
          "[unit]") {
  const scratch dir;
  const reproduction r = recorded();
  std::filesystem::create_directories(dir / (reproducer_name(r) + ".cpp/in the way"));
  const auto path = write_reproducer(r, dir / "");
  CHECK_FALSE(path);
  CHECK(path.reason().find(".cpp") != std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(dir / ""))
    CHECK(entry.path().filename().string()[0] != '.');
  CHECK_FALSE(std::filesystem::exists(dir / (reproducer_name(r) + ".json"))); // it is the last
  std::ofstream(dir / "file") << "x";
  CHECK(write_reproducer(r, dir / "file").reason().find("cannot make the folder") == 0);
}

TEST_CASE("fuzz.reproducer: the text says root, level, ray, octant, miss and judge", "[unit]") {
  const std::string text = reproducer_text(recorded());
  INFO(text);
  for (const char* part :
       {"crossed-miss by published", "level 50", "0x1.89629603723cep-1", "-0x1.2e3acaacf4b96p-1",
        "0x1.1fd52bb47c85p-2", "missed", "the ray crosses its interior", "ulps of", "judged by",
        "agrees", "graze-fuzz replay published-crossed-miss-"})
    CHECK(text.find(part) != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') <= 12);
}

TEST_CASE("fuzz.reproducer: a finding on the ray that was received is told about that ray",
          "[regression]") {
  struct in_floats final : traversal {
    [[nodiscard]] std::string_view name() const override { return "in-floats"; }
    [[nodiscard]] promise promises() const override { return promise::crossed; }
    void visit(const trial& t, visited& out) override {
      const auto rounded = [](const vec3& v) {
        return vec3{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
      };
      out.receive({rounded(t.origin), rounded(t.direction)}); // and visits nothing
    }
  } under_test;
  std::string all;
  unsigned counted = 0;
  for (const auto& [t, kind] : findings_of(under_test, 10, 20)) {
    const reproduction r = reproduction_of(t, under_test, kind);
    if (r.answered == t || (r.judged.touches >> r.subject & 1) == 0)
      continue;
    CHECK(reproducer_json(r).find(hex(t.origin[0])) != std::string::npos);
    CHECK(reproducer_text(r).find("given ") != std::string::npos);
    all += reproducer_snippet(r); // its claim is about r.answered
    ++counted;
  }
  CHECK(counted > 10);
  if (!compiler_is_there())
    return;
  const scratch dir;
  std::ofstream(dir / "all.cpp") << all;
  const auto compiled = syntax(dir / "all.cpp");
  INFO(compiled.err);
  CHECK(compiled.code == 0);
}

TEST_CASE("fuzz.reproducer: the snippet is the committed one, which is compiled with the tests",
          "[regression]") {
  CHECK(content(GRAZE_REPRODUCER_EXAMPLE) == reproducer_snippet(recorded()));
}

TEST_CASE("fuzz.reproducer: snippets compile, and their claim is false the other way round",
          "[property]") {
  if (!compiler_is_there())
    return; // the committed example is compiled in any case
  const scratch dir;
  unsigned asserted = 0;
  std::string all; // one file may hold many
  std::set<std::string> names;
  for (const char* name : {"published", "gargantini", "mutant-exact", "mutant-everything",
                           "mutant-inexact", "mutant-reversed"}) {
    const auto under_test = find_traversal(name)->make();
    for (const auto& [t, kind] : findings_of(*under_test, 30, 20)) {
      const reproduction r = reproduction_of(t, *under_test, kind);
      if (!names.insert(reproducer_name(r)).second)
        continue;
      const std::string snippet = reproducer_snippet(r);
      all += snippet;
      asserted += snippet.find("static_assert") != std::string::npos ? 1 : 0;
    }
  }
  CHECK(asserted >= 20);
  std::ofstream(dir / "all.cpp") << all;
  const auto good = syntax(dir / "all.cpp");
  INFO(good.err);
  CHECK(good.code == 0);
  // each assertion turned round is an error
  std::string wrong = all;
  for (std::size_t at = 0; (at = wrong.find("static_assert(", at)) != std::string::npos; at += 14)
    wrong.insert(at + 14, "!");
  std::ofstream(dir / "wrong.cpp") << wrong;
  const auto bad = syntax("-fno-diagnostics-show-caret " + (dir / "wrong.cpp"));
  CHECK(bad.code != 0);
  unsigned errors = 0;
  for (std::size_t at = 0; (at = bad.err.find("static assertion failed", at)) != std::string::npos;
       at += 10)
    ++errors;
  CHECK(errors == asserted);
}

TEST_CASE("fuzz.reproducer: the picture of a miss by less than an ulp has its magnified panel",
          "[unit]") {
  const std::string svg = reproducer_picture(recorded());
  check_picture(svg);
  CHECK(svg.find("magnified") != std::string::npos);
  CHECK(svg.find("ulps of") != std::string::npos);
}

TEST_CASE("fuzz.shrink: small witnesses lie in a grid of at most 8^3, and fail in the same way",
          "[property]") {
  const auto shipped = find_traversal("amanatides-woo")->make();
  traversal& walk = *shipped;
  std::vector<std::unique_ptr<traversal>> all;
  for (const char* name : {"published", "plain", "gargantini", "mutant-exact", "mutant-drops"})
    all.push_back(find_traversal(name)->make());
  std::vector<traversal*> under_tests{&walk};
  for (const auto& t : all)
    under_tests.push_back(t.get());
  for (traversal* under_test : under_tests) {
    const finding kind =
        under_test->name() == "mutant-exact" ? finding::miss : finding::crossed_miss;
    const auto small = small_witness(*under_test, kind);
    INFO(under_test->name());
    REQUIRE(small);
    INFO(to_json_line(*small));
    CHECK(small->level <= 3);
    CHECK((judge(*small, *under_test).findings & bit(kind)) != 0);
    CHECK(small_witness(*under_test, kind) == small);
  }
}

TEST_CASE("fuzz.shrink: there is no small witness against a traversal that is right", "[unit]") {
  const auto sound = find_traversal("sound")->make();
  CHECK_FALSE(small_witness(*sound, finding::miss));
  CHECK_FALSE(small_witness(*sound, finding::crossed_miss));
}

TEST_CASE("fuzz.reproducer: of segments, grids and boxes it tells the cells, and claims nothing of "
          "octants",
          "[unit]") {
  for (
      const char* line :
      {R"({"origin":[0.15,0.25,-1],"direction":[0,0,1],"grid":{"origin":[0,0,0],"spacing":[0.1,0.1,0],"count":[5,5,1],"planes":"added"},"voxel":[1,2,0]})",
       R"({"origin":[0,0,0],"end":[1,0,0],"octant":{"lo":[0,0,0],"size":0.5}})",
       R"({"origin":[0,0.5,0.5],"direction":[1,0,0],"boxes":[{"lo":[1,0,0],"hi":[1,1,1]},{"lo":[2,0,0],"hi":[3,1,1]}]})"}) {
    const auto t = from_json_line(line);
    REQUIRE(t);
    const auto under_test = find_traversal("mutant-second")->make();
    const reproduction r = reproduction_of(*t, *under_test, finding::crossed_miss);
    const std::string text = reproducer_text(r);
    INFO(text);
    CHECK(text.find("root") == std::string::npos);
    CHECK(text.find("margin") == std::string::npos);
    CHECK(text.find(t->boxes ? "box        ("
                             : (t->grid ? "grid       5 x 5 x 1 voxels"
                                        : "octant     [0, 0, 0] of level 1")) != std::string::npos);
    CHECK(text.find(t->end ? "end        (" : "direction  (") != std::string::npos);
    CHECK(text.find("reported") != std::string::npos);
    const std::string folder = std::string("scene_reproducer_") + std::string(name_of(t->cells()));
    const auto written = write_reproducer(r, folder);
    REQUIRE(written);
    CHECK_FALSE(content(written->test).empty());
    CHECK(std::filesystem::exists(written->path + ".json"));
    CHECK(std::filesystem::exists(written->path + ".txt"));
    CHECK_FALSE(std::filesystem::exists(written->path + ".cpp"));
    CHECK_FALSE(std::filesystem::exists(written->path + ".svg"));
    std::filesystem::remove_all(folder);
  }
}
