/// Traversals in another process: right ones are judged like those in this process, and each way of
/// going wrong is told, on the ray that brings it on.
#include "../support/program.hpp"
#include "campaign_of.hpp"
#include <adapters/adapter.hpp>
#include <campaign/hint.hpp>
#include <external/external.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <judge/exact_cells.hpp>
#include <judge/replay.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <trial/number.hpp>

using namespace graze::fuzz;

namespace {

external_options peer(const std::string& behaviour) {
  external_options options;
  options.command = std::string("'") + TEST_PEER + "' " + behaviour;
  options.promised = promise::owned;
  return options;
}

traversal_entry started(const external_options& options) {
  auto entry = external_traversal(options);
  INFO(entry.reason());
  REQUIRE(entry);
  return *entry;
}

campaign_result campaign(const traversal_entry& entry, std::uint64_t rays, unsigned threads = 2,
                         int level = 10) {
  campaign_plan plan = plan_of("sound", level, rays);
  plan.under_test = entry;
  plan.workers = threads;
  return run(plan);
}

/// No child is left, not even one that has ended, but for the keeper: the one that runs this very
/// program, and lives as long as this process does.
bool no_process_left() {
  namespace fs = std::filesystem;
  const fs::path self = fs::read_symlink("/proc/self/exe");
  int others = 0, keepers = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string text;
    if (!std::getline(stat, text) || text.rfind(')') == std::string::npos)
      continue;
    char state = 0;
    pid_t parent = 0;
    std::istringstream(text.substr(text.rfind(')') + 1)) >> state >> parent;
    if (parent != getpid())
      continue;
    std::error_code none; // of a child that has ended there is no program
    (fs::read_symlink(entry.path() / "exe", none) == self ? keepers : others) += 1;
  }
  return others == 0 && keepers <= 1;
}

/// Trials of many kinds, asked as a campaign asks them; what is found on each.
struct judged {
  trial at;
  verdict judgement;
};
std::vector<judged> ask(const traversal_entry& entry, std::size_t count) {
  const campaign_plan plan = plan_of("sound", 10, count);
  std::vector<trial> trials;
  for (std::size_t k = 0; k < count; ++k)
    trials.push_back(trial_of(plan, k));
  std::vector<visited> answers(count);
  const auto under_test = entry.make();
  for (std::size_t k = 0; k < count;) {
    const std::size_t some = std::min<std::size_t>(64, count - k);
    k += under_test->visit_some(std::span(trials).subspan(k, some), std::span(answers).subspan(k));
  }
  std::vector<judged> result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back({trials[k], judge_answer(trials[k], answers[k], under_test->promises())});
  return result;
}

/// The rays with direction x < 0 have this finding and no other; the rest have none.
void only_backwards(const external_options& options, finding kind, std::size_t count = 200) {
  std::size_t backwards = 0;
  for (const judged& j : ask(started(options), count)) {
    const bool expected = j.at.direction[0] < 0;
    backwards += expected ? 1 : 0;
    CHECK(j.judgement.findings == (expected ? bit(kind) : 0u));
  }
  CHECK(backwards > 5);
  CHECK(backwards < count - 5);
  CHECK(no_process_left());
}

std::string command(const std::string& behaviour) {
  return std::string("--command \"'") + TEST_PEER + "' " + behaviour + "\"";
}

} // namespace

TEST_CASE("fuzz.external: a right peer is judged as the traversal behind it, in either format",
          "[property]") {
  for (const int level : {1, 10, 53}) {
    const counts here = campaign(*find_traversal("sound"), 2000, 1, level).total;
    external_options plain = peer("right");
    plain.format = line_format::plain;
    external_options bits = plain, batch = plain;
    bits.format = line_format::bits;
    batch.batch = 30;
    for (const external_options& options :
         {peer("right"), plain, bits, batch, peer("around"), peer("hello-bits"),
          peer("hello-batch"), peer("hello-plain-batch")}) {
      INFO(options.command);
      const traversal_entry entry = started(options);
      CHECK(campaign(entry, 2000, 1, level).total == here);
      CHECK(campaign(entry, 2000, 3, level).total == here);
    }
  }
  CHECK(no_process_left());
}

TEST_CASE("fuzz.external: lines longer than a pipe holds do not lock the two up", "[unit]") {
  CHECK(campaign(started(peer("fat")), 300).total.findings == 0);
}

TEST_CASE("fuzz.external: an end in the middle is a crash of its ray", "[unit]") {
  only_backwards(peer("exit"), finding::crash);
  only_backwards(peer("abort"), finding::crash);
  only_backwards(peer("exit-unflushed"), finding::crash);
}

TEST_CASE("fuzz.external: silence is a hang of its ray", "[unit]") {
  external_options options = peer("hang");
  options.seconds_a_ray = 0.5; // a right answer takes a thousandth of it
  only_backwards(options, finding::hang, 20);
}

TEST_CASE("fuzz.external: what is no answer is malformed, NaN is told apart", "[unit]") {
  only_backwards(peer("garbage"), finding::malformed);
  only_backwards(peer("two-lines"), finding::malformed);
  only_backwards(peer("nan"), finding::not_a_number);
  only_backwards(peer("endless"), finding::malformed, 60);
}

TEST_CASE("fuzz.external: a crash that has nothing to do with a ray is told all the same",
          "[unit]") {
  std::size_t crashes = 0;
  for (const judged& j : ask(started(peer("once")), 500)) {
    crashes += j.judgement.findings != 0 ? 1 : 0;
    CHECK((j.judgement.findings & ~bit(finding::crash)) == 0u);
  }
  CHECK(crashes >= 3);
  CHECK(crashes <= 25);
}

TEST_CASE("fuzz.external: a ray that is declined is counted, and judged nothing", "[unit]") {
  std::size_t declined = 0;
  for (const judged& j : ask(started(peer("skip")), 200)) {
    CHECK(j.judgement.declined == (j.at.direction[0] < 0));
    CHECK(j.judgement.findings == 0u);
    declined += j.judgement.declined ? 1 : 0;
  }
  CHECK(declined > 5);
  CHECK(campaign(started(peer("skip")), 200).total.declined == declined);
}

TEST_CASE("fuzz.external: a voxel outside the grid is a finding", "[unit]") {
  for (const judged& j : ask(started(peer("outside")), 200))
    CHECK(((j.judgement.findings & bit(finding::outside)) != 0) == (j.at.direction[0] < 0));
}

TEST_CASE("fuzz.external: who rounds rays is judged on the ray that was received", "[property]") {
  CHECK(campaign(started(peer("float")), 3000).total.findings == 0);
  CHECK(campaign(started(peer("float-silent")), 3000).total.misses > 0);
  external_options options = peer("float-silent");
  options.as_float = true;
  const traversal_entry entry = started(options);
  const counts c = campaign(entry, 3000).total;
  CHECK(c.findings == 0);
  trial t;
  t.origin = {0.1, 0.2, 0.3};
  t.direction = {0.7, 0x1.000001p-3, 1.1};
  visited out;
  const auto under_test = entry.make();
  under_test->visit(t, out);
  REQUIRE(out.received());
  for (unsigned a = 0; a < 3; ++a) { // strtof rounds for itself
    CHECK(out.received()->origin[a] == std::strtof(hex(t.origin[a]).c_str(), nullptr));
    CHECK(out.received()->direction[a] == std::strtof(hex(t.direction[a]).c_str(), nullptr));
  }
  t.direction = {0, 0x1p-501, 0x1p-251}; // no direction in float
  out.clear();
  under_test->visit(t, out);
  CHECK(out.declined());
  CHECK(c.declined < c.rays / 4);
}

TEST_CASE("fuzz.external: the promise is the peer's first word, or the user's", "[unit]") {
  external_options options = peer("hello");
  options.promised.reset();
  CHECK(started(options).make()->promises() == promise::owned);
  options = peer("hello-plain");
  options.promised.reset();
  CHECK(started(options).make()->promises() == promise::exactly_owned);
  options.promised = promise::touched;
  CHECK(started(options).make()->promises() == promise::touched);
  CHECK(campaign(started(peer("hello")), 500).total.findings == 0);
  options = peer("right");
  options.promised.reset();
  CHECK(started(options).make()->promises() == promise::crossed);
}

TEST_CASE("fuzz.external: a first line that comes late still says what is asked", "[unit]") {
  CHECK(campaign(started(peer("hello-late")), 100, 1).total.findings == 0);
}

TEST_CASE("fuzz.external: a command that answers nothing is refused with the reason", "[unit]") {
  const auto text_sleeps = [](const std::string& text) { return text.starts_with("sleep"); };
  const auto why = [&](std::string text) {
    external_options options;
    options.command = std::move(text);
    // none but the one that sleeps takes it
    options.start_seconds = options.seconds_a_ray = text_sleeps(options.command) ? 0.2 : 30;
    return external_traversal(options).reason();
  };
  CHECK(why("exit 3").find("(exit code 3)") != std::string::npos);
  CHECK(why("/no/such/program 2>/dev/null").find("(exit code 127)") != std::string::npos);
  CHECK(why("kill -9 $$").find("(signal 9)") != std::string::npos);
  CHECK(why("cat").find("what is no answer") != std::string::npos);
  CHECK(why("head -c 20000000 /dev/zero").find("a line without end") != std::string::npos);
  CHECK(why("echo hello").find("\"hello\"") != std::string::npos);
  CHECK(why("sleep 1000").find("does it flush") != std::string::npos);
  CHECK(why(peer("hello-wrong").command).find("\"the moon\"") != std::string::npos);
  CHECK(why(peer("hello-unknown").command).find("\"speed\"") != std::string::npos);
  CHECK(why(peer("misspells").command).find("the member \"visted\" is unknown") !=
        std::string::npos);
  CHECK(no_process_left());
}

TEST_CASE("fuzz.external: answers are read in every spelling, and wrong ones refused", "[unit]") {
  trial t;
  t.level = 3;
  t.base = {2, 4, 6};
  t.extent = {2, 2, 2};
  const auto read = [&](std::string_view line) {
    visited out;
    read_answer(line, t, 7, {}, out);
    return out;
  };
  const octant_set two = octant_set{1} << octant_at(0, 0, 0) | octant_set{1} << octant_at(1, 1, 0);
  for (const char* line :
       {"[[2,4,6],[3,5,6]]", " [[2.0,4,6],[3,5e0,6]]", R"({"visited":[[2,4,6],[3,5,6]]})",
        R"({"id":7,"visited":[[2,4,6],[7,7,7],[3,5,6]]})", "2 4 6 3 5 6", " 2 4 6  3 5 6.0 ",
        "2 4 6 3 5 6 received 0 0 0 0x1p+0 -1 1e-3"}) {
    INFO(line);
    CHECK(read(line).failed() == fault::none);
    CHECK(read(line).set() == two);
    CHECK_FALSE(read(line).outside());
  }
  for (const char* line : {"[]", "", R"({"visited":[]})"}) {
    CHECK(read(line).failed() == fault::none);
    CHECK(read(line).set() == 0);
  }
  for (const char* line :
       {R"({"visted":[]})",
        R"({"visited":[],"hit":true})",
        R"({"first":[2,4,6]})",
        R"({"visited":[],"received":{"origin":[0,0,0],"direction":[1,0,0],"up":1}})",
        "true",
        "t 1",
        "[",
        "[1]",
        "[[1,2]]",
        "[[1,2,3,4]]",
        R"([["1",2,3]])",
        "[[0.5,1,1]]",
        "{}",
        "1 2",
        "a",
        "null",
        "2 4 6 3",
        "2 4 6 received 1 2 3",
        "2 4 6 received 1 2 3 4 5 6 7",
        R"({"id":8,"visited":[]})",
        R"({"visited":7})",
        R"({"visited":[],"received":[1,2]})",
        R"({"visited":[],"received":{"origin":[0,0,0],"direction":["x",0,0]}})",
        "[[1e999,0,0]]"}) {
    INFO(line);
    CHECK(read(line).failed() == fault::malformed);
    CHECK_FALSE(read(line).thrown().empty());
  }
  for (const char* line :
       {"[[NaN,1,1]]", "[[null,1,1]]", "nan 1 1",
        R"({"visited":[],"received":{"origin":["nan",0,0],"direction":[1,0,0]}})"})
    CHECK(read(line).failed() == fault::not_a_number);
  for (const char* line : {"[[-1,4,6]]", "[[8,4,6]]", "2 4 1e300", "[[18446744073709551615,4,6]]"})
    CHECK(read(line).outside());
  CHECK(read("skip").declined());
  CHECK(read("skip id 7").declined());
  CHECK(read("skip 1 2 3").failed() == fault::malformed);
  CHECK(read(R"({"skip":true})").declined());
  const visited ray =
      read(R"({"visited":[],"received":{"origin":[0,"0x1p-1",0],"direction":[1,0,-1]}})");
  REQUIRE(ray.received());
  CHECK(ray.received()->origin == vec3{0, 0.5, 0});
  CHECK(ray.received()->direction == vec3{1, 0, -1});
  // the ray that was received has no direction: nothing to judge
  CHECK(judge_answer(t, read("received 0 0 0 0 0 0"), promise::touched).declined);
  CHECK(judge_answer(t, read("received 0 0 0 inf 0 0"), promise::touched).declined);
}

namespace {

trial three_boxes() {
  trial t;
  t.boxes = std::make_shared<const std::vector<graze::octree::box>>(std::vector<graze::octree::box>{
      {{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}, {{-1, -1, 1}, {1, 1, 1}}});
  return t;
}

visited answered(std::string_view line, const trial& t, const answer_form& form) {
  visited out;
  out.clear();
  read_answer(line, t, 7, form, out);
  INFO(line << ": " << out.thrown());
  CHECK((out.failed() == fault::malformed) == !out.thrown().empty());
  return out;
}

} // namespace

TEST_CASE("fuzz.external: boxes are told by their places", "[unit]") {
  const trial t = three_boxes();
  for (const char* line : {"[2,0]", R"({"visited":[2,0]})", "2 0", " 2  0.0 "}) {
    const visited out = answered(line, t, {});
    CHECK(out.failed() == fault::none);
    CHECK(out.set() == 5u);
    CHECK(out[0] == 2);
  }
  for (const char* line : {"[3]", "-1", "3"})
    CHECK(answered(line, t, {}).outside());
  for (const char* line : {"[[0,0,0]]", "[0.5]", R"(["0"])"})
    CHECK(answered(line, t, {}).failed() == fault::malformed);
  CHECK(answered("[null]", t, {}).failed() == fault::not_a_number);
}

TEST_CASE("fuzz.external: a first hit, its distance and face, whether there is one, a count",
          "[unit]") {
  const trial t = three_boxes();
  const answer_form first{promise::first, true, false};
  for (const char* line : {R"({"first":1,"t":0.5,"distance":"0x1p+1","face":"-x","id":7})",
                           "1 t 0x1p-1 distance 2 face -x id 7",
                           "1 t 3fe0000000000000 distance 4000000000000000 face -x"}) {
    const visited out = answered(line, t, first);
    CHECK(out.failed() == fault::none);
    CHECK(out.set() == 2u);
    CHECK(out.said().t == 0.5);
    CHECK(out.said().distance == 2.0);
    CHECK(out.said().entered == face{0, false});
    CHECK_FALSE(out.said().no_face);
  }
  for (const char* line : {R"({"first":null,"t":null,"face":null})", "none", "null", "", "[]"}) {
    const visited out = answered(line, t, first);
    CHECK(out.failed() == fault::none);
    CHECK(out.size() == 0);
    CHECK_FALSE(out.said().t);
  }
  CHECK(answered(R"({"first":0,"face":null})", t, first).said().no_face);
  CHECK(answered("0 face none", t, first).said().no_face);
  CHECK(answered("[2,1,0]", t, first).set() == 4u); // of a list the first
  for (const char* line : {R"({"first":0,"t":null})", "0 t nan", "0 distance NaN"})
    CHECK(answered(line, t, first).failed() == fault::not_a_number);
  for (const char* line : {R"({"t":1})", R"({"first":0,"hit":true})", R"({"first":0,"face":"x"})",
                           "0 face up", "0 speed 3", "0 t", R"({"first":[0,0,0]})"})
    CHECK(answered(line, t, first).failed() == fault::malformed);

  const answer_form any{promise::any, false, false}, count{promise::count, false, false};
  for (const char* line : {"true", "1", R"({"hit":true})", "true id 7"})
    CHECK(answered(line, t, any).said().hit == true);
  for (const char* line : {"false", "0", R"({"hit":false})"})
    CHECK(answered(line, t, any).said().hit == false);
  for (const char* line : {"3", R"({"count":3})", "3 id 7"})
    CHECK(answered(line, t, count).said().crossings == std::uint64_t{3});
  for (const char* line : {"[]", "", "2", "maybe", R"({"hit":1})", R"({"count":1})"})
    CHECK(answered(line, t, any).failed() == fault::malformed);
  for (const char* line : {"[]", "", "true", "-1", "0.5", R"({"count":"x"})"})
    CHECK(answered(line, t, count).failed() == fault::malformed);
}

TEST_CASE("fuzz.external: what was received of a segment is its ends, and may be asked for",
          "[unit]") {
  trial t;
  t.end = vec3{1, 2, 4};
  const answer_form form{promise::crossed, false, true};
  for (const char* line :
       {"0 0 0 received 0 0 0 1 2 3.5",
        R"({"visited":[[0,0,0]],"received":{"origin":[0,0,0],"end":[1,2,"400c000000000000"]}})"}) {
    const visited out = answered(line, t, form);
    REQUIRE(out.received());
    CHECK(out.received()->end == vec3{1, 2, 3.5});
    CHECK(out.received()->direction == vec3{1, 2, 3.5});
  }
  CHECK(answered("0 0 0", t, form).thrown().find("--received") != std::string::npos);
  CHECK(answered("[[0,0,0]]", t, form).failed() == fault::malformed);
  CHECK(answered("skip", t, form).failed() == fault::none);
  CHECK(answered(R"({"visited":[],"received":{"origin":[0,0,0],"direction":[1,0,0]}})", t, form)
            .failed() == fault::malformed);
}

TEST_CASE("fuzz.external: a request says all doubles as decimals and as bits", "[unit]") {
  const auto text = [](const trial& t, line_format format) {
    std::string line;
    append_request(line, t, 3, format);
    CHECK(line.back() == '\n');
    line.pop_back();
    return line;
  };
  trial t = three_boxes();
  t.origin = {0.1, -0.0, 1};
  CHECK(text(t, line_format::json) ==
        R"({"id":3,"origin":[0.1,-0.0,1.0],"direction":[1.0,0.0,0.0],"boxes":[)"
        R"({"lo":[0.0,0.0,0.0],"hi":[1.0,1.0,1.0]},{"lo":[1.0,0.0,0.0],"hi":[2.0,1.0,1.0]},)"
        R"({"lo":[-1.0,-1.0,1.0],"hi":[1.0,1.0,1.0]}],"bits":{"origin":)"
        R"(["3fb999999999999a","8000000000000000","3ff0000000000000"],"direction":)"
        R"(["3ff0000000000000","0000000000000000","0000000000000000"],"boxes":[)"
        R"({"lo":["0000000000000000","0000000000000000","0000000000000000"],"hi":)"
        R"(["3ff0000000000000","3ff0000000000000","3ff0000000000000"]},)"
        R"({"lo":["3ff0000000000000","0000000000000000","0000000000000000"],"hi":)"
        R"(["4000000000000000","3ff0000000000000","3ff0000000000000"]},)"
        R"({"lo":["bff0000000000000","bff0000000000000","3ff0000000000000"],"hi":)"
        R"(["3ff0000000000000","3ff0000000000000","3ff0000000000000"]}]}})");
  CHECK(text(t, line_format::plain) == "3 boxes 0x1.999999999999ap-4 -0x0p+0 0x1p+0 0x1p+0 0x0p+0 "
                                       "0x0p+0 3 0x0p+0 0x0p+0 0x0p+0 0x1p+0 "
                                       "0x1p+0 0x1p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+1 0x1p+0 0x1p+0 "
                                       "-0x1p+0 -0x1p+0 0x1p+0 0x1p+0 0x1p+0 "
                                       "0x1p+0");
  t.boxes.reset();
  graze::fuzz::grid_planes grid;
  grid.spacing = {0.1, 0.5, 2};
  grid.count = {3, 4, 5};
  grid.rule = graze::octree::plane_rule::rounded;
  t.grid = std::make_shared<const grid_planes>(grid);
  t.base = {1, 2, 3};
  t.end = vec3{1, 2, 3};
  CHECK(
      text(t, line_format::json) ==
      R"({"id":3,"origin":[0.1,-0.0,1.0],"end":[1.0,2.0,3.0],"grid":{"origin":[0.0,0.0,0.0],)"
      R"("spacing":[0.1,0.5,2.0],"count":[3,4,5],"planes":"rounded"},"base":[1,2,3],"extent":[1,1,1],)"
      R"("bits":{"origin":["3fb999999999999a","8000000000000000","3ff0000000000000"],"end":)"
      R"(["3ff0000000000000","4000000000000000","4008000000000000"],"grid":{"origin":)"
      R"(["0000000000000000","0000000000000000","0000000000000000"],"spacing":)"
      R"(["3fb999999999999a","3fe0000000000000","4000000000000000"]}}})");
  CHECK(text(t, line_format::bits) ==
        "3 grid rounded 1 2 3 1 1 1 3fb999999999999a 8000000000000000 3ff0000000000000 "
        "3ff0000000000000 "
        "4000000000000000 4008000000000000 0000000000000000 0000000000000000 0000000000000000 "
        "3fb999999999999a 3fe0000000000000 4000000000000000 3 4 5");
  grid.rule = graze::octree::plane_rule::given;
  grid.count = {1, 1, 1};
  grid.given = {{{0, 1}, {0.5}, {0, 0.1}}};
  t.grid = std::make_shared<const grid_planes>(grid);
  CHECK(
      text(t, line_format::json).find(R"("grid":{"planes":[[0.0,1.0],[0.5],[0.0,0.1]]},"base")") !=
      std::string::npos);
  CHECK(text(t, line_format::plain)
            .ends_with(" 2 1 2 0x0p+0 0x1p+0 0x1p-1 0x0p+0 0x1.999999999999ap-4"));
}

TEST_CASE("fuzz.external: a reader or writer that is wrong by an ulp is caught at the first ray",
          "[unit]") {
  const auto why = [](const std::string& behaviour) {
    const auto entry = external_traversal(peer(behaviour));
    return entry ? std::string() : entry.reason();
  };
  CHECK(why("right").empty());
  // serde_json's default: the first of the numbers that it reads wrong
  const std::string ulp = why("reads-an-ulp-off");
  CHECK(ulp.find(
            "1.9999999999999998 (bits 3fffffffffffffff) came back as 2 (bits 4000000000000000)") !=
        std::string::npos);
  CHECK(ulp.find("the strings of \"bits\"") != std::string::npos);
  CHECK(ulp.find('\n') == std::string::npos);
  CHECK(why("reads-floats").find("0.1 (bits 3fb999999999999a) came back") != std::string::npos);
  CHECK(why("writes-six-digits").find("came back as") != std::string::npos);
  const auto notices = [](const std::string& behaviour) {
    const auto entry = external_traversal(peer(behaviour));
    REQUIRE(entry);
    return entry->notices;
  };
  CHECK(notices("right").empty());
  REQUIRE(notices("loses-the-sign").size() == 1);
  CHECK(notices("loses-the-sign")[0].find("-0 came back as 0") != std::string::npos);
  REQUIRE(notices("no-echo").size() == 1);
  CHECK(notices("no-echo")[0].find("was not checked") != std::string::npos);
  CHECK(notices("hello-bits").empty());
}

TEST_CASE("fuzz.external: a batch with an answer too few is malformed", "[unit]") {
  // alone each has its answer: told of the last of each batch
  const counts c = campaign(started(peer("batch-short")), 300, 1).total;
  CHECK(c.faults > 0);
  CHECK(c.faults < 20);
  std::vector<visited> answers(2);
  const std::array<std::size_t, 2> places{0, 1};
  const std::array<trial, 2> trials{};
  for (visited& v : answers)
    v.clear();
  CHECK(read_batch(R"({"answers":[[[0,0,0]],{"visited":[],"id":8}]})", trials, places, 7, {},
                   answers));
  CHECK(answers[0].set() == 1u);
  CHECK(answers[1].failed() == fault::none);
  for (const char* line : {R"({"answers":[[]]})", "[]", "{", R"({"answers":[[],[]],"more":1})"}) {
    for (visited& v : answers)
      v.clear();
    CHECK_FALSE(read_batch(line, trials, places, 7, {}, answers));
    CHECK(answers[1].failed() == fault::malformed);
  }
}

TEST_CASE("fuzz.external: what a first line says must not contradict the options", "[unit]") {
  const auto why = [](const external_options& options) {
    const auto entry = external_traversal(options);
    return entry ? std::string() : entry.reason();
  };
  external_options options = peer("hello-first");
  CHECK(why(options).find("says promise first in its first line, against --promise owned") !=
        std::string::npos);
  options = peer("hello-bits");
  options.format = line_format::plain;
  CHECK(why(options).find("says numbers bits in its first line, against --plain") !=
        std::string::npos);
  options = peer("hello-batch");
  options.batch = 101;
  CHECK(why(options).find("a batch of 100 at most in its first line, against --batch 101") !=
        std::string::npos);
  options = peer("hello-first");
  options.promised.reset();
  options.segments = true;
  CHECK(why(options).find("says no segments") != std::string::npos);
  options = peer("hello");
  options.needs_received = true;
  CHECK(why(options).find("--received") != std::string::npos);
}

TEST_CASE("graze-fuzz run --command: found, shrunk, saved and replayed", "[unit]") {
  const support::scratch dir;
  const std::string file = dir / "miss.jsonl";
  const auto o = support::call(GRAZE_FUZZ, "run --rays 4000 --level 10 --json --save " + file +
                                               " " + command("drops"));
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["finding"] == "gross-miss");
  CHECK(object["rays"] == 4000);
  CHECK(object["faults"] == 0);
  // once, when the command is tried
  CHECK(o.err == "a word of the peer\n");
  CHECK(support::call(GRAZE_FUZZ, "replay " + file + " " + command("drops")).code == 1);
  CHECK(support::call(GRAZE_FUZZ, "replay " + file + " " + command("right")).code == 0);
  // what is said of it can be pasted
  const auto text = support::call(GRAZE_FUZZ, "run --rays 4000 --level 10 " + command("drops")).out;
  const std::size_t at = text.find("replay: ");
  REQUIRE(at != std::string::npos);
  std::string line = text.substr(at + 8, text.find('\n', at) - at - 8);
  line.replace(line.find("| graze-fuzz"), 12, std::string("| ") + GRAZE_FUZZ);
  std::ofstream(dir / "paste") << line << '\n';
  CHECK(support::call("/bin/sh", dir / "paste").code == 1);
}

TEST_CASE(
    "fuzz.external: answers for rays in float, or for directions of length 1, are told as such",
    "[property]") {
  const auto told = [](const std::string& behaviour, bool as_float = false) {
    external_options options = peer(behaviour);
    options.as_float = as_float;
    const campaign_result result = campaign(started(options), 3000);
    return hint_of(result.samples, promise::owned);
  };
  CHECK(told("float-silent") == other_ray::as_float);
  CHECK(told("unit-silent") == other_ray::unit_direction);
  CHECK_FALSE(told("drops")); // it is wrong for these rays too
  CHECK_FALSE(told("right"));
  CHECK_FALSE(told("float"));
  CHECK_FALSE(told("drops", true));
  const auto run = [](const std::string& behaviour, const std::string& more) {
    return support::call(GRAZE_FUZZ, "run --rays 2000 --level 10 --no-shrink --promise owned " +
                                         more + command(behaviour));
  };
  CHECK(run("float-silent", "").out.find("say --float") != std::string::npos);
  CHECK(nlohmann::json::parse(run("float-silent", "--json ").out)["hint"] == "float");
  CHECK(nlohmann::json::parse(run("drops", "--json ").out)["hint"].is_null());
  CHECK(run("drops", "").out.find("--float") == std::string::npos);
}

TEST_CASE("fuzz.external: a tolerance that makes any t right is no sign of float", "[regression]") {
  const auto told = [](double off, bool in_float) {
    std::vector<sample> samples;
    for (unsigned k = 0; samples.size() < 40; ++k) {
      const trial t = make_trial(generators()[k % generators().size()], 5, k, 10, {}, true);
      const truth exact = truth_of(t);
      if (exact.crossed == 0)
        continue;
      const auto entry = graze::oracle::rational::range_in(rational_line(t),
                                                           rational_cell(t, exact.first_crossed));
      visited answer;
      answer.clear();
      answer.push(exact.first_crossed);
      const double at = entry->first.get_d() * (1 + off);
      answer.said().t = in_float ? adapter::to_float(at) : at;
      if (judge_answer(t, answer, promise::first).findings == bit(finding::distance))
        samples.push_back({k, t, answer});
    }
    return hint_of(samples, promise::first);
  };
  CHECK_FALSE(told(0x1p-40, false));
  CHECK(told(0, true) == other_ray::as_float);
}

TEST_CASE("graze-fuzz run --command: a crash is shrunk, and replayed", "[unit]") {
  const support::scratch dir;
  const std::string file = dir / "crash.jsonl";
  const auto o = support::call(GRAZE_FUZZ, "run --rays 500 --level 10 --json --save " + file + " " +
                                               command("exit"));
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["finding"] == "crash");
  CHECK(object["rays"] == 500);
  CHECK(object["faults"] > 10);
  const auto again = support::call(GRAZE_FUZZ, "replay --json " + file + " " + command("exit"));
  CHECK(again.code == 1);
  CHECK(nlohmann::json::parse(again.out)["findings"] == nlohmann::json::array({"crash"}));
}

TEST_CASE("graze-fuzz replay: a library's adapter is asked with the options that were given",
          "[regression]") {
  const support::scratch dir;
  const std::string program = dir / "graze-adapter-octomap";
  std::ofstream(program) << "#!/bin/sh\n"
                            "case $1 in --variants) printf 'octomap-ray-keys\\tcrossed\\tx\\n';; "
                            "*) echo 'a word of the library' >&2;; esac\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const trial t = make_trial(generators().front(), 1, 0, 10);
  std::ofstream(dir / "ray.jsonl") << to_json_line(t) << '\n';
  const auto o =
      support::call(GRAZE_FUZZ, "replay " + (dir / "ray.jsonl") + " --traversal octomap-ray-keys",
                    "GRAZE_ADAPTERS='" + (dir / "") + "' ");
  CHECK(o.code == 1); // it ends before it answers: a crash
  CHECK(o.err.find("a word of the library") != std::string::npos);
}

TEST_CASE("graze-fuzz campaign --command: goes on, and its findings replay as it says", "[unit]") {
  const support::scratch dir;
  const std::string folder = dir / "campaign";
  support::refused(GRAZE_FUZZ, "campaign " + folder + " --command false", "false");
  CHECK_FALSE(std::filesystem::exists(folder)); // a command that gives no answer leaves nothing
  const std::string plan = " --level 10 --rays 3000 --piece 1000 ";
  const auto o =
      support::call(GRAZE_FUZZ, "campaign " + folder + plan + command("drops") + " --threads 1");
  CHECK(o.code == 1);
  CHECK(o.out.find("graze-fuzz replay " + folder + "/findings/") != std::string::npos);
  CHECK(o.out.find(".json --command ") != std::string::npos);
  // the folder knows the command
  CHECK(support::call(GRAZE_FUZZ, "campaign " + folder).out.find("goes on after 3000") !=
        std::string::npos);
  for (const std::string& other : {command("right"), command("drops") + " --float"}) {
    const auto refused = support::call(GRAZE_FUZZ, "campaign " + folder + " " + other);
    CHECK(refused.code == 2);
    CHECK(refused.err.find("another plan") != std::string::npos); // beside the peer's own word
  }
  CHECK(support::call(GRAZE_FUZZ, "summary " + folder).code == 1); // and starts no command
}

TEST_CASE("graze-fuzz run --command: the budget of time holds for one that hangs", "[unit]") {
  const auto o = support::call(GRAZE_FUZZ, "run --seconds 1 --level 10 --threads 2 --timeout 0.2 "
                                           "--json " +
                                               command("hang"));
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["finding"] == "hang");
  // each thread is through with its piece of 1024 rays long before every second one has hung
  CHECK(object["faults"] >= 2);
  CHECK(object["faults"] < 100);
}

TEST_CASE("graze-fuzz run --command: bad input is one line and exit code 2", "[unit]") {
  support::refused(GRAZE_FUZZ, "run --command 'exit 5'", "exit code 5");
  support::refused(GRAZE_FUZZ, "run --command cat --promise nothing", "promise \"nothing\"");
  support::refused(GRAZE_FUZZ, "run --command cat --timeout 0", "--timeout");
  support::refused(GRAZE_FUZZ, "run --command cat --timeout nan", "--timeout");
  support::refused(GRAZE_FUZZ, "run --command cat --traversal sound", "--command");
  support::refused(GRAZE_FUZZ, "run --plain", "--command");
  support::refused(GRAZE_FUZZ, "run --command cat --plain --bits", "--plain");
  support::refused(GRAZE_FUZZ, "run --command cat --batch 0", "--batch");
  support::refused(GRAZE_FUZZ, "run --command cat --tolerance -1", "--tolerance");
  const auto o = support::call(GRAZE_FUZZ, "run --rays 100 " + command("reads-an-ulp-off"));
  CHECK(o.code == 2);
  CHECK(o.err.find("1.9999999999999998") != std::string::npos);
}

TEST_CASE("graze-fuzz run --command: the example in Python is found to miss", "[unit]") {
  if (std::system("python3 -c 1 >/dev/null 2>&1") != 0) {
    std::cout << "graze: skipped, no python3\n";
    return;
  }
  const auto o =
      support::call(GRAZE_FUZZ, "run --rays 2000 --generator far-origin,exponent-gap --level 10 "
                                "--json --command 'python3 " EXAMPLES "/amanatides_woo.py'");
  CHECK(o.code == 1);
  CHECK(nlohmann::json::parse(o.out)["crossed_missed"] > 0);
}

TEST_CASE("graze-fuzz run --command: the example in C is found to miss, in float", "[unit]") {
  const auto o = support::call(
      GRAZE_FUZZ, "run --rays 5000 --level 10 --json --plain --float --command '" SLABS "'");
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["crossed_missed"] > 0);
  CHECK(object["faults"] == 0);
}
