#include <catch2/catch.hpp>
#include <generate/generators.hpp>
#include <judge/replay.hpp>
#include <traversal/list.hpp>

using namespace graze::fuzz;

TEST_CASE("fuzz.replay: a line is read back to the last bit", "[property]") {
  for (const generator& g : generators())
    for (const int level : {1, 10, 30, 50, 53})
      for (unsigned k = 0; k < 100; ++k) {
        const trial t = make_trial(g, 31, k, level);
        const auto again = from_json_line(to_json_line(t));
        INFO(to_json_line(t));
        REQUIRE(again);
        REQUIRE(*again == t);
        REQUIRE(to_json_line(*again) == to_json_line(t)); // the signs of zeros too
      }
}

TEST_CASE("fuzz.replay: the root may be left out, numbers may be JSON numbers", "[unit]") {
  const auto t = from_json_line(
      R"({"origin":[0.5,"0.25","0x1p-3"],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":0.5},"name":"mine"})");
  REQUIRE(t);
  CHECK(t->origin == vec3{0.5, 0.25, 0.125});
  CHECK(t->level == 1);
  CHECK(t->root == cube{{0, 0, 0}, 1});
}

TEST_CASE("fuzz.replay: a corrupt line is refused with its reason", "[unit]") {
  const auto why = [](const char* line) { return from_json_line(line).reason(); };
  CHECK(why("{") == "not JSON");
  CHECK(why("") == "not JSON");
  CHECK(why("[1,2]") == "not a JSON object");
  CHECK(why("{}") == "no \"origin\"");
  CHECK(why(R"({"origin":[0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1}})") ==
        "\"origin\" is not an array of three numbers");
  CHECK(why(R"({"origin":[0,0,"nan"],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1}})") ==
        "\"origin\" is not a finite number");
  CHECK(why(R"({"origin":[0,0,null],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1}})") ==
        "\"origin\" is not a finite number");
  CHECK(why(R"({"origin":[0,0,1e999],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1}})") !=
        "");
  CHECK(why(R"({"origin":[0,0,0],"direction":[0,0,"-0x0p+0"],"octant":{"lo":[0,0,0],"size":1}})") ==
        "ray direction is zero");
  CHECK(why(R"({"origin":[0,0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0]}})") == "no \"size\"");
  CHECK(why(R"({"origin":[0,0,0],"direction":[1,0,0],"octant":7})") == "no \"lo\"");
  CHECK(
      why(R"({"origin":[0,0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1},"extent":[5,1,1]})") ==
      "\"extent\" is not an array of three integers in 1..4");
  CHECK(
      why(R"({"origin":[0,0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1},"extent":"x"})") ==
      "\"extent\" is not an array of three integers in 1..4");
  CHECK(
      why(R"({"origin":[0,0,0],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":1},"root":{"lo":[0,0,0],"size":3}})") ==
      "octant size is not the root's size halved 0 to 53 times");
}

TEST_CASE("fuzz.replay: the two oracles agree on every generator", "[property]") {
  const auto sound = find_traversal("sound")->make();
  for (const generator& g : generators())
    for (const int level : {1, 10, 50, 53})
      for (unsigned k = 0; k < 60; ++k) {
        const trial t = make_trial(g, 32, k, level);
        const replay_result r = replay(t, *sound);
        INFO(to_json_line(t));
        REQUIRE(r.oracles_agree);
        REQUIRE(r.findings == 0);
      }
}
