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
  CHECK(why(R"({"origin":[0,0,0],"direction":[1,0,0],"octant":7})") ==
        "\"octant\" is not an object");
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

TEST_CASE("fuzz.replay: grids, boxes and segments are read, and written to be read back",
          "[unit]") {
  const auto same_again = [](const trial& t) {
    const auto again = from_json_line(to_json_line(t));
    INFO(to_json_line(t) << again.reason());
    REQUIRE(again);
    CHECK(*again == t);
    CHECK(to_json_line(*again) == to_json_line(t));
  };
  const auto read = [](const char* line) {
    const auto t = from_json_line(line);
    INFO(t.reason());
    REQUIRE(t);
    return *t;
  };
  trial t = read(
      R"({"origin":[0,0,0],"direction":[1,0,0],"grid":{"origin":[0,-10,0.5],"spacing":[0.1,"0x1p-3",0],"count":[10,20,1],"planes":"rounded"},"voxel":[3,4,0],"extent":[2,1,1],"comment":"a map"})");
  CHECK(t.cells() == cell_kind::grid);
  CHECK(t.plane(0, 0) == 0.30000000000000004);
  CHECK(t.plane(1, 0) == -9.5);
  CHECK(t.plane(2, 0) == 0.5);
  CHECK(t.plane(2, 1) == 0.5);
  CHECK(t.cell(1).hi[0] == 0.5);
  same_again(t);
  t = read(
      R"({"origin":[0,0,0],"end":[1,"3ff8000000000000",0],"grid":{"planes":[[0,0.1,0.5],[0,1],[7]]},"voxel":[1,0,0]})");
  REQUIRE(t.end);
  CHECK((*t.end)[1] == 1.5);
  CHECK(t.grid->rule == plane_rule::given);
  CHECK(t.plane(0, 1) == 0.5);
  CHECK(t.flat(2));
  same_again(t);
  t = read(
      R"({"origin":[0,0,0],"direction":[1,0,0],"box":{"lo":[-1,-1,1],"hi":[1,1,1]},"name":"flat"})");
  CHECK(t.boxes->size() == 1);
  same_again(t);
  t = read(R"({"origin":[0,0,0],"end":[1,0,0],"boxes":[{"lo":[-1,-1,1],"hi":[1,1,1]},)"
           R"({"lo":[0,0,0],"hi":[1,2,"0x1.8p+1"]}]})");
  CHECK(t.boxes->at(1).hi[2] == 3);
  CHECK(t.all() == 3);
  same_again(t);
  same_again(read(R"({"origin":[0,0,0],"end":[1,0,0],"octant":{"lo":[0,0,0],"size":0.5}})"));
}

TEST_CASE("fuzz.replay: what a line has besides is refused by its name", "[unit]") {
  const auto why = [](const std::string& rest) {
    return from_json_line(R"({"origin":[0,0,0],)" + rest + "}").reason();
  };
  const std::string
      ray = R"("direction":[1,0,0],)",
      grid =
          R"("grid":{"origin":[0,0,0],"spacing":[1,1,1],"count":[3,3,3],"planes":"exact"},"voxel":[0,0,0])";
  CHECK(why(ray + grid) == "");
  CHECK(why(ray + grid + R"(,"ende":[1,0,0])") ==
        "unknown member \"ende\": remarks may be members \"comment\" and \"name\"");
  CHECK(why(ray + grid + R"(,"end":[1,0,0])").starts_with("unknown member \"direction\""));
  CHECK(why(ray + R"("octant":{"lo":[0,0,0],"size":1},"voxel":[0,0,0])")
            .starts_with("unknown member \"voxel\""));
  CHECK(why(ray + R"("octant":{"lo":[0,0,0],"size":1,"comment":1})")
            .starts_with("unknown member \"comment\" in octant"));
  CHECK(why(ray + grid + R"(,"root":{"lo":[0,0,0],"size":1})")
            .starts_with("unknown member \"root\""));
  CHECK(why(ray + R"("box":{"lo":[0,0,0],"hi":[1,1,1]},"extent":[1,1,1])")
            .starts_with("unknown member \"extent\""));
  CHECK(why(ray + R"("boxes":[])") == "\"boxes\" is not an array of 1 to 64 boxes");
  CHECK(why(ray + R"("grid":7,"voxel":[0,0,0])") == "no \"planes\"");
  CHECK(
      why(ray +
          R"("grid":{"origin":[0,0,0],"spacing":[1,1,1],"count":[3,3,3],"planes":"given"},"voxel":[0,0,0])")
          .starts_with("\"planes\" is none of"));
  CHECK(why(ray + R"("grid":{"planes":[[0,1],[0,1]]},"voxel":[0,0,0])") ==
        "\"planes\" is not three arrays");
  CHECK(why(ray + R"("grid":{"planes":[[0,1],[0,1],[0,"x"]]},"voxel":[0,0,0])") ==
        "\"planes\" is not a finite number");
  CHECK(why(ray + R"("grid":{"planes":[[0,1],[0,1],[0]]},"voxel":[0,-1,0])") ==
        "\"voxel\" is not an array of three integers in 0..1048575");
  CHECK(why(ray + R"("grid":{"planes":[[0,1],[0,1],[0]]},"voxel":[0,1,0])") ==
        "voxels lie outside the grid, which has 1 on axis y");
  CHECK(why(R"("end":[0,0,0],)" + grid) ==
        "segment's end is its origin: take two points, or ask about a ray");
  CHECK(why(R"("end":["7ff0000000000000",0,0],)" + grid) == "\"end\" is not a finite number");
}
