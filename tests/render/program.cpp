// graze-render and graze-voxelize as their users meet them: output, exit codes, bad input.
#include "../support/program.hpp"
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_file.hpp>
#include <graze/render/scene.hpp>
#include <nlohmann/json.hpp>

using support::call, support::scratch;

namespace {
void refused(const scratch& dir, const std::string& arguments, const std::string& reason,
             const std::string& lines = "") {
  support::refused(GRAZE_RENDER, arguments, reason, lines);
  CHECK(dir.empty());
}
} // namespace

TEST_CASE("graze-render: --method is certified unless the descent's levels are given", "[unit]") {
  const scratch dir;
  const auto found = [&](const std::string& options) {
    const auto o = call(GRAZE_RENDER, "--scene tanglecube --size 64 --json " + options + " -o " +
                                          (dir / "a.png"));
    INFO(options << ": " << o.err);
    REQUIRE(o.code == 0);
    return nlohmann::json::parse(o.out);
  };
  const auto certified = found(""), descent = found("--method descent --octree-level 6");
  CHECK(certified["method"] == "certified");
  CHECK(found("--method certified")["method"] == "certified");
  CHECK(descent["method"] == "descent");
  CHECK(found("--levels 20")["method"] == "descent");
  CHECK(found("--octree-level 5")["method"] == "descent");
  CHECK(certified["octree_leaves"] == 0);
  CHECK(descent["octree_leaves"] > 0);
  CHECK(certified["hits"] == descent["hits"]);
  CHECK(certified["undecided"] == 0);
  CHECK(certified["octants_per_ray"] < descent["octants_per_ray"]);
  const auto line = call(GRAZE_RENDER, "--scene spheres --size 16 -o " + (dir / "a.png")).out;
  CHECK(line.find("certified") != std::string::npos);
  CHECK(line.find("steps a ray") != std::string::npos);
}

TEST_CASE("graze-render: --json prints one object, whose counts add up", "[unit]") {
  const scratch dir;
  const auto o =
      call(GRAZE_RENDER,
           "--scene spheres --levels 50 --size 64 --octree-level 6 --json -o " + (dir / "a.exr"));
  REQUIRE(o.code == 0);
  const auto line = nlohmann::json::parse(o.out);
  CHECK(line["rays"] == 4096);
  int sum = 0;
  for (const char* count : {"hits", "misses", "undecided", "poles", "jumps", "gaps"})
    sum += line[count].get<int>();
  CHECK(sum == 4096);
  CHECK(line["complete"] == true);
}

TEST_CASE("graze-render: bad input is one line, exit code 2, and no file", "[unit]") {
  const scratch dir;
  const std::string to = " -o " + (dir / "a.png");
  refused(dir, "--scene teapot --levels 30" + to, "tanglecube");
  refused(dir, "--scene tanglecube --levels 0" + to, "--levels must be 1 to 53, not 0");
  refused(dir, "--scene tanglecube --levels 54" + to, "--levels must be 1 to 53, not 54");
  refused(dir, "--scene tanglecube --levels x" + to, "--levels");
  refused(dir, "--scene tanglecube --levels 30 --size 0" + to, "--size");
  refused(dir, "--scene tanglecube --levels 30 --size -5" + to, "--size");
  refused(dir, "--scene tanglecube --levels 30 --threads -1" + to, "--threads");
  refused(dir, "--scene tanglecube --levels 30 -o " + (dir / "none/a.png"), "none");
  refused(dir, "--scene tanglecube --levels 30 -o " + (dir / "a.jpg"), "png");
  refused(dir, "--levels 30" + to, "--scene");
  refused(dir, "--scene tanglecube", "--output");
  refused(dir, "--scene tanglecube --size 0x0" + to, "--size must be 1 to 16384, not 0");
  refused(dir, "--scene tanglecube --size 9x" + to, "--size");
  refused(dir, "--scene tanglecube --size 16x16 --crop 0,0,17,1" + to, "--crop");
  refused(dir, "--scene tanglecube --crop 1,2,3" + to, "--crop");
  refused(dir, "--scene tanglecube --spp 3" + to, "--spp");
  refused(dir, "--scene tanglecube --mode draw" + to, "--mode");
  refused(dir, "--scene tanglecube --method guess" + to, "--method");
  refused(dir, "--scene tanglecube --method certified --levels 30" + to, "--method descent");
  refused(dir, "--scene tanglecube --formula x" + to, "one of --scene, --formula, --again");
  refused(dir, "--again /etc/passwd" + to, "/etc/passwd");
}

TEST_CASE("graze-render: a bad formula, an empty domain, no surface: one line, no file", "[unit]") {
  const scratch dir;
  const std::string to = " -o " + (dir / "a.png");
  refused(dir, "--formula 'x^2 + (y'" + to, "--formula: column 9", "  x^2 + (y\n          ^\n");
  refused(dir, "--formula 'x^2 + q'" + to, "column 7", "  x^2 + q\n        ^\n");
  refused(dir, "--formula '1/0 + x'" + to, "column 2: division by zero", "  1/0 + x\n   ^\n");
  refused(dir, "--formula '1/(x*y - y*x*1.0 + sin(x)^2 + cos(x)^2 - 1)'" + to, "divi");
  refused(dir, "--formula x --domain=2,1" + to, "the domain is empty: x from 2 to 1");
  refused(dir, "--formula x --domain=0,1,1,1,0,1" + to, "the domain is empty: y from 1 to 1");
  refused(dir, "--formula x --domain=0,inf" + to, "domain");
  refused(dir, "--formula x --domain=0,q" + to, "--domain: column 3");
  refused(dir, "--formula 'x^2 + y^2 + 1'" + to, "no surface");
  refused(dir, "--formula 'sqrt(-1 - x^2)'" + to, "no surface");
}

TEST_CASE("graze-render: scene files, and errors that name the key", "[unit]") {
  const scratch dir, scenes;
  const std::string file = scenes / "s.json", to = " -o " + (dir / "a.png");
  const auto wrong = [&](const char* text, const std::string& reason,
                         const std::string& lines = "") {
    std::ofstream(file) << text;
    refused(dir, "--scene " + file + to, file + ": " + reason, lines);
  };
  wrong("{\"formula\": \"x +\", \"domain\": [-1, 1]}", "key formula: column 4", "  x +\n     ^\n");
  wrong(R"({"formula": "x-a", "domain": [-1, 1], "set": {"a": "1/"}})",
        "key set.a: the value of 'a': column 3", "  1/\n    ^\n");
  wrong("{\"formula\": \"x\",\n\"domain\": [-1 1]}", "parse error at line 2, column 15");
  wrong("{\"domain\": [-1, 1]}", "no surface");
  wrong("{\"objects\": [], \"domain\": [-1, 1]}", "key objects: no surface");
  wrong("{\"formula\": \"x\", \"domain\": [1, 1]}", "key domain: the domain is empty");
  wrong("{\"formula\": \"x\", \"domain\": [0, 1], \"lights\": [{\"position\": [0, 0, \"a\"]}]}",
        "key lights[0].position[2]: must be a number");
  refused(dir, "--scene " + (scenes / "none.json") + to, "cannot read '");
  std::ofstream(file) << "{\"formula\": \"x^2 + y^2 + z^2 - 1\", \"domain\": [-1.5, 1.5]}";
  const auto o = call(GRAZE_RENDER, "--scene " + file + " --size 32 --json" + to);
  REQUIRE(o.code == 0);
  CHECK(nlohmann::json::parse(o.out)["hits"].get<int>() > 100);
}

TEST_CASE("graze-render: a caret is under the character that is meant", "[unit]") {
  const scratch dir;
  const std::string to = " -o " + (dir / "a.png");
  // columns and the caret count characters, not bytes; what is not shown is replaced
  refused(dir, "--formula 'θ²+é+1'" + to, "column 4: expected a number, a name or '(', found 'é'",
          "  θ²+é+1\n     ^\n");
  refused(dir, "--formula 'x+\tq'" + to, "column 4", "  x+ q\n     ^\n");
  refused(dir, "--formula 'x+\n\xff'" + to, "the byte 0xFF", "  x+ \uFFFD\n     ^\n");
  // long texts are cut on both sides, between characters
  std::string sum;
  for (int i = 0; i < 100; ++i)
    sum += "θ²+";
  refused(dir, "--formula '" + sum + "q+" + sum + "1'" + to, "column 301",
          "  ...θ²+θ²+θ²+θ²+θ²+θ²+θ²+θ²+θ²+θ²+q+θ²+θ²+θ²+θ²+θ²+θ²+θ²+θ²...\n  " +
              std::string(33, ' ') + "^\n");
  refused(dir, "--formula x-a --set a=1+" + to, "--set: the value of 'a': column 3",
          "  1+\n    ^\n");
}

TEST_CASE("graze-render: --set gives names their values, exactly, before a scene file's",
          "[unit]") {
  const scratch dir;
  const auto bytes = [&](const std::string& arguments) {
    const std::string file = dir / "a.png";
    const auto o = call(GRAZE_RENDER,
                        arguments + " --eye 5,2,3 --look-at 0,0,0 --fov 40 --size 24 -o " + file);
    INFO(arguments << ": " << o.err);
    REQUIRE(o.code == 0);
    CHECK(o.err.empty());
    const auto r = call(GRAZE_RENDER, "--json --again " + file + " -o " + (dir / "b.png"));
    REQUIRE(r.code == 0);
    CHECK((support::content(file) == support::content(dir / "b.png")));
    return nlohmann::json::parse(r.out)["hits"].get<int>();
  };
  const int plain = bytes("--formula 'x^2+y^2+z^2-0.3'");
  CHECK(bytes("--formula 'x^2+y^2+z^2=a' --set a=0.3") == plain);
  CHECK(bytes("--formula 'x^2+y^2+z^2=a*b' --set 'b = 1/10' --set a=3") == plain);
  CHECK(bytes("--formula 'x^2+y^2+z^2=a' --set a=1.3") > plain);
  const scratch scenes;
  const std::string file = scenes / "s.json";
  const auto write = [&](const std::string& set) {
    std::ofstream(file) << R"({"objects": [{"name": "ball", "formula": "w=a; x²+y²+z² = w;"},
      {"name": "half", "formula": "w = b; z < w"}], "solid": {"intersection": ["ball", "half"]},
      "domain": [-2, 2], "set": {)"
                        << set << "}}";
  };
  write(R"("a": 0.3, "b": 3)");
  CHECK(bytes("--scene " + file) == plain);
  CHECK(bytes("--scene " + file + " --set a=1.3") > plain);
  CHECK(bytes("--scene " + file + " --set b=-1/4") < plain);
  write(R"("a": "3/10", "b": "1e3")");
  CHECK(bytes("--scene " + file) == plain);
  const std::string to = " -o " + (dir / "c.png");
  const auto no = [&](const std::string& arguments, const std::string& reason) {
    support::refused(GRAZE_RENDER, arguments + to, reason);
  };
  no("--formula x-a --set a=1 --set a=2", "--set a: is given twice");
  no("--formula x-a --set a=1 --set b=2", "no formula has the name 'b'");
  no("--formula x-a --set a", "--set a: needs a name and a value");
  no("--formula x-a --set x=1", "'x' has a meaning already");
  no("--formula x-a --set a=y", "no constant");
  no("--scene spheres --set a=1", "spheres has no names");
  no("--set a=1", "exactly one of");
  no("--again x.png --set a=1", "--set is of --formula and --scene");
  write(R"("a": 0.3, "b": 3, "c": 1)");
  no("--scene " + file, "no formula has the name 'c'");
  write(R"("a": 0.3, "b": [])");
  no("--scene " + file, "key set.b: must be a number or a text");
}

TEST_CASE("graze-render: a power that is not defined for x < 0 is one line, graze-voxelize's too",
          "[unit]") {
  const scratch dir;
  const std::string cubes = "--formula 'x^(1/3)+y^(1/3)+z^(1/3)' ";
  const auto o = call(GRAZE_RENDER, cubes + "--size 16 -o " + (dir / "a.png"));
  CHECK(o.code == 0);
  CHECK(o.err == "graze-render: x^(1/3) is defined for x >= 0; cbrt(x)? y^(1/3) is defined for "
                 "y >= 0; cbrt(y)? z^(1/3) is defined for z >= 0; cbrt(z)?\n");
  CHECK(call(GRAZE_VOXELIZE, "--level 3 " + cubes + "-o " + (dir / "a.octree")).err ==
        "graze-voxelize" + o.err.substr(12));
  CHECK(call(GRAZE_RENDER, "--formula 'cbrt(x)+|y|^(1/3)-z' --size 16 -o " + (dir / "a.png"))
            .err.empty());
}

TEST_CASE("graze-render: --again gives the same bytes, crops and samples included", "[unit]") {
  const scratch dir;
  const char* const arguments =
      GENERATE("--scene tanglecube --mode trace --size 60x40 --crop 10,5,37,33 --spp 4 --levels 35 "
               "--octree-level 6",
               "--formula 'max(x^2 + y^2 + z^2 - 1, -abs(x) + 1/3)' --domain=-1.5,1.25 --size 40 "
               "--octree-level 6",
               "--scene 'asterisk(3,4)' --mode trace --method certified --size 40");
  for (const char* extension : {".exr", ".png"}) {
    const std::string first = (dir / "a") + extension, second = (dir / "b") + extension;
    REQUIRE(call(GRAZE_RENDER, arguments + (" --threads 1 -o " + first)).code == 0);
    const auto o = call(GRAZE_RENDER, "--again " + first + " --threads 3 -o " + second);
    INFO(o.err);
    REQUIRE(o.code == 0);
    CHECK(o.err.empty());
    CHECK(support::content(first) == support::content(second));
  }
}

TEST_CASE("graze-render: view options are those of scene files, and contradictions are one line",
          "[unit]") {
  const scratch dir, scenes;
  const std::string to = " -o " + (dir / "a.png"), file = scenes / "s.json";
  std::ofstream(file)
      << R"({"name": "formula", "formula": "x^2 + 2*y^2 + z^2 - 1", "domain": [-2, 2],
      "camera": {"azimuth": -40, "elevation": 30, "up": "z", "fov": 25, "zoom": 1.5},
      "colour": "tomato", "inside_colour": [0.1, 0.2, 0.3], "background": "transparent"})";
  REQUIRE(call(GRAZE_RENDER, "--scene " + file + " --size 40 -o " + (scenes / "a.png")).code == 0);
  const auto o =
      call(GRAZE_RENDER,
           "--formula 'x^2 + 2*y^2 + z^2 - 1' --azimuth -40 --elevation 30 --up z --fov 25 "
           "--zoom 1.5 --color tomato --inside-colour 0.1,0.2,0.3 --background "
           "transparent --size 40" +
               to);
  INFO(o.err);
  REQUIRE(o.code == 0);
  CHECK(support::content(dir / "a.png") == support::content(scenes / "a.png"));
  std::filesystem::remove(dir / "a.png");
  const std::string sphere = "--formula 'x^2 + y^2 + z^2 - 1' ";
  refused(dir, sphere + "--eye 1,2,3 --azimuth 5" + to, "leave out one of them");
  refused(dir, sphere + "--eye 0,0,3 --up z" + to, "give another axis, such as x");
  refused(dir, sphere + "--eye 1,2,3 --look-at 1,2,3" + to, "move one of them");
  refused(dir, sphere + "--eye 1,2" + to, "--eye: needs x,y,z, not 2 numbers");
  refused(dir, sphere + "--eye 1,2,q" + to, "--eye: column 5");
  refused(dir, sphere + "--eye nan,0,1" + to, "eye must be finite");
  refused(dir, sphere + "--look-at 0,inf,1" + to, "look-at must be finite");
  refused(dir, sphere + "--up 0,0,0" + to, "up must not be 0");
  refused(dir, sphere + "--up w" + to, "--up: column 1");
  refused(dir, sphere + "--elevation 91" + to, "elevation must be -90 to 90");
  refused(dir, sphere + "--azimuth nan" + to, "azimuth must be");
  refused(dir, sphere + "--fov 180" + to, "fov must be 0.001 to 170");
  refused(dir, sphere + "--zoom 0" + to, "zoom must be");
  refused(dir, sphere + "--colour mauve" + to, "--colour: 'mauve' is no colour");
  refused(dir, sphere + "--background '#12'" + to, "--background: '#12' is no colour");
  refused(dir, sphere + "--light 1,2" + to, "--light: needs x,y,z");
  refused(dir, sphere + "--light headlight --light 1,2,3" + to, "headlight or positions");
  refused(dir, sphere + "--light 1,2,3,-1" + to, "intensity must be");
  refused(dir, sphere + "--orbit 1" + to, "--orbit must be 2 to 10000, not 1");
  refused(dir, sphere + "--orbit 4 -o " + (dir / "a%s.png"), "needs one %d");
  refused(dir, sphere + "--orbit 4 -o " + (dir / "a%d%d.png"), "needs one %d");
  refused(dir, "--again " + (scenes / "a.png") + " --zoom 2" + to, "--zoom");
  support::refused(GRAZE_VOXELIZE, sphere + "--azimuth 3 -o " + (dir / "a.octree"), "--azimuth");
  std::ofstream(file)
      << R"({"objects": [{"name": "a", "formula": "x"}, {"name": "b", "formula": "y"}],
      "domain": [-1, 1]})";
  refused(dir, "--scene " + file + " --colour red" + to, "objects have their own");
}

TEST_CASE("graze-render: an orbit is a picture from each side, and --again makes any of them again",
          "[unit]") {
  const scratch dir;
  const std::string formula =
      "--formula '(x-1/4)^2 + 2*y^2 + z^2 + x*y - 1' --up z --elevation 20 --size 40 ";
  const auto o =
      call(GRAZE_RENDER, formula + "--azimuth 10 --orbit 4 --json -o " + (dir / "a.png"));
  INFO(o.err);
  REQUIRE(o.code == 0);
  std::istringstream lines(o.out);
  int frame = 0;
  for (std::string line; std::getline(lines, line); ++frame) {
    const auto found = nlohmann::json::parse(line);
    const std::string file = dir / ("a_000" + std::to_string(frame) + ".png");
    CHECK(found["frame"] == frame);
    CHECK(found["frames"] == 4);
    CHECK(found["output"] == file);
    CHECK(found["complete"] == true);
    // 10, 100, 190 and 280 degrees: the same as one picture each, but for roundings of the camera
    const auto single =
        call(GRAZE_RENDER, formula + "--json --azimuth " + std::to_string(10 + 90 * frame) +
                               " -o " + (dir / "b.png"));
    REQUIRE(single.code == 0);
    CHECK(nlohmann::json::parse(single.out)["hits"] == found["hits"]);
    REQUIRE(call(GRAZE_RENDER, "--again " + file + " -o " + (dir / "b.png")).code == 0);
    CHECK(support::content(dir / "b.png") == support::content(file));
  }
  CHECK(frame == 4);
  CHECK(support::content(dir / "a_0000.png") != support::content(dir / "a_0001.png"));
  REQUIRE(call(GRAZE_RENDER, "--scene tanglecube --size 16 --orbit 11 -o " + (dir / "t-%03d-x.png"))
              .code == 0);
  CHECK(std::filesystem::exists(dir / "t-000-x.png"));
  CHECK(std::filesystem::exists(dir / "t-010-x.png"));
}

TEST_CASE("graze-render: an animation is a picture for each value, under one camera", "[unit]") {
  const scratch dir;
  const std::string to = " -o " + (dir / "a.png"),
                    ball = "--formula 'x^2 + y^2 + z^2 - a*b' --set b=2 --size 40 --json ";
  const auto seen = call(GRAZE_RENDER, ball + "--animate a=0.25..1 --frames 4" + to);
  INFO(seen.err);
  REQUIRE(seen.code == 0);
  std::istringstream lines(seen.out);
  int hits = 0, frame = 0;
  for (std::string line; std::getline(lines, line); ++frame) { // it grows: the camera stands still
    const auto found = nlohmann::json::parse(line);
    CHECK(found["frame"] == frame);
    CHECK(found["hits"].get<int>() > hits + 50);
    hits = found["hits"];
  }
  CHECK(frame == 4);
  for (const char* name : {"a_0000.png", "a_0001.png", "a_0002.png", "a_0003.png"})
    CHECK(std::filesystem::remove(dir / name));
  const std::string standing = ball + "--eye 5,2,3 --look-at 0,0,0 --fov 40 ";
  REQUIRE(call(GRAZE_RENDER, standing + "--animate a=1..0.5 --frames 3" + to).code == 0);
  REQUIRE(call(GRAZE_RENDER, standing + "--set a=0.75" + to).code == 0);
  CHECK(support::content(dir / "a_0001.png") == support::content(dir / "a.png"));
  REQUIRE(call(GRAZE_RENDER, "--again " + (dir / "a_0001.png") + " -o " + (dir / "b.png")).code ==
          0);
  CHECK(support::content(dir / "a_0001.png") == support::content(dir / "b.png"));
  const scratch none;
  const std::string nowhere = " -o " + (none / "a.png");
  refused(none, ball + "--animate a=0..1" + nowhere, "--animate needs --frames");
  refused(none, ball + "--frames 3" + nowhere, "--frames is of --animate");
  refused(none, ball + "--animate a=0..1 --frames 1" + nowhere, "--frames must be 2 to 10000");
  refused(none, ball + "--animate a=0..1 --frames 3 --orbit 3" + nowhere, "exclude each other");
  for (const char* wrong :
       {"a", "a=1", "a=1..", "=0..1", "a=0..nan", "a=0..inf", "0..1", "a=0,1..2"})
    refused(none, ball + "--animate " + wrong + " --frames 3" + nowhere, "must be as a=0..1");
  refused(none, "--formula 'x^2 + y^2 + z^2 - 1' --animate c=0..1 --frames 3" + nowhere, "--set");
  refused(none, ball + "--animate a=-2..-1 --frames 3" + nowhere, "picture 0 of 3: no surface");
}

TEST_CASE("graze-render: an interrupted orbit leaves whole pictures", "[unit]") {
  const scratch dir, pictures;
  const std::string log = dir / "log", first = pictures / "a_0000.png";
  const auto o =
      call("sh", "-c '" + std::string(GRAZE_RENDER) +
                     " --scene spheres --mode trace --size 200 --spp 25 --orbit 1000 -o " +
                     (pictures / "a.png") + " 2>" + log + " & while ! [ -s " + first +
                     " ]; do sleep 0.02; done; kill -INT $!; wait $!'");
  const std::string err = support::content(log);
  INFO(err);
  CHECK(o.code == 130);
  CHECK(err.find("of 1000 pictures are written") != std::string::npos);
  CHECK(std::count(err.begin(), err.end(), '\n') == 1);
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(first).parent_path())) {
    const std::string bytes = support::content(entry.path());
    CHECK(bytes.find("graze:complete") != std::string::npos);
    CHECK(bytes.substr(bytes.find("graze:complete") + 15, 3) == "yes");
    ++count;
  }
  CHECK(err.find("interrupted: " + std::to_string(count) + " of 1000") != std::string::npos);
  CHECK(count > 0);
  CHECK(count < 1000);
}

TEST_CASE("graze-render: a full disk is one line, exit code 1, and no file", "[unit]") {
  const scratch dir;
  // write() fails beyond the limit; the limit counts for all files of the program
  const auto o =
      call(GRAZE_RENDER, "--scene spheres --octree-level 6 --size 200 -o " + (dir / "a.exr"),
           "ulimit -f 8; timeout 600 ");
  CHECK(o.code == 1);
  CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
  CHECK(o.err.find("cannot write") != std::string::npos);
  CHECK(dir.empty());
}

TEST_CASE("graze-render: EXR needs the plug-in, which lies beside it; PNG needs nothing",
          "[unit]") {
  namespace fs = std::filesystem;
  const scratch dir, programs;
  const std::string alone = programs / "graze-render", plugin = programs / "graze_exr.so",
                    png = " -o " + (dir / "a.png"), exr = " -o " + (dir / "a.exr");
  fs::copy(GRAZE_RENDER, alone);
  support::refused(alone, "--scene spheres --size 8" + exr, "graze_exr.so");
  support::refused(alone, "--scene teapot" + exr, "teapot"); // said before
  CHECK(dir.empty());
  CHECK(call(alone, "--scene spheres --size 8" + png).code == 0);
  std::ofstream(plugin) << "no library";
  support::refused(alone, "--scene spheres --size 8" + exr, "cannot load");
  CHECK(!fs::exists(dir / "a.exr"));
  fs::remove(plugin);
  fs::copy(GRAZE_EXR_PLUGIN, plugin);
  CHECK(call(alone, "--scene spheres --size 8" + exr).code == 0);
  fs::remove(plugin); // a picture's texts need none
  CHECK(call(alone, "--again " + (dir / "a.exr") + png).code == 0);
  const auto libraries = call("ldd", GRAZE_RENDER);
  CHECK(libraries.code == 0);
  CHECK(libraries.out.find("OpenImageIO") == std::string::npos);
}

TEST_CASE("graze-render: help has examples", "[unit]") {
  const auto o = call(GRAZE_RENDER, "--help");
  CHECK(o.code == 0);
  CHECK(o.out.find("Examples") != std::string::npos);
}

TEST_CASE("graze-voxelize: every scene that graze-render takes", "[unit]") {
  using namespace graze;
  const scratch dir;
  const std::string to = " --level 5 -o " + (dir / "a.octree"), file = dir / "s.json";
  const auto octree_of = [&](const std::string& arguments) {
    const auto o = call(GRAZE_VOXELIZE, arguments + to);
    INFO(arguments << ": " << o.err);
    REQUIRE(o.code == 0);
    return *octree::load_octree(dir / "a.octree");
  };
  for (const render::scene& s : render::scenes())
    CHECK(octree_of("--scene '" + s.name + "'").description == s.name + ": " + formula_text(s));
  const auto typed = octree::formula::parse("x^2 + y^2 - z^2");
  const octree::box domain{{-1, -1, -1}, {1, 1, 1}};
  const auto wanted = *octree::voxelize(typed->surface(), domain, 5);
  const auto formula = octree_of("--formula 'x^2 + y^2 - z^2' --domain=-1,1");
  CHECK(formula.octree == wanted);
  CHECK(formula.description == "formula: x^2 + y^2 - z^2");
  CHECK(octree_of(std::string("--scene ") + GRAZE_SCENES "/cone_tip.json").octree == wanted);
  std::ofstream(file) << R"({"surface": "holesrot", "domain": [0, 1]})";
  CHECK(octree_of("--scene " + file).octree ==
        *octree::voxelize(octree::holesrot{}, {{0, 0, 0}, {1, 1, 1}}, 5));
  std::ofstream(file) << R"({"objects": [{"name": "a", "formula": "x"},
      {"name": "b", "formula": "y"}], "solid": {"difference": ["a", "b"]}, "domain": [-1, 1]})";
  CHECK(octree_of("--scene " + file).description == "scene: difference((x),(y))");
  std::ofstream(file) << R"({"name": ")" << std::string(70000, 'n')
                      << R"(", "formula": "x", "domain": [-1, 1]})";
  CHECK(octree_of("--scene " + file).description.size() == octree::longest_description);
}

TEST_CASE("graze-voxelize: what is no scene is refused in graze-render's words", "[unit]") {
  const scratch dir, scenes;
  const std::string file = scenes / "s.json";
  std::ofstream(file) << R"({"formula": "x +", "domain": [-1, 1]})";
  for (const std::string scene :
       {"--scene teapot", "--scene none.json", "--formula 'x^2 + (y'", "--formula 1/0",
        "--formula x --domain=2,1", "--formula x --domain=0,q", "--scene spheres --domain=-1,1",
        "--formula 'x^2 + y^2 + 1'", "--formula 'sqrt(-1 - x^2)'", "--scene FILE"}) {
    std::string arguments = scene;
    if (const auto at = arguments.find("FILE"); at != std::string::npos)
      arguments.replace(at, 4, file);
    const auto seen = call(GRAZE_RENDER, arguments + " -o " + (dir / "a.png"));
    const auto found = call(GRAZE_VOXELIZE, arguments + " -o " + (dir / "a.octree"));
    INFO(arguments << "\n" << seen.err << found.err);
    CHECK(found.code == 2);
    CHECK(found.err == "graze-voxelize" + seen.err.substr(std::string("graze-render").size()));
    const bool shows_formula = found.err.find(": column ") != std::string::npos &&
                               found.err.find("--domain") == std::string::npos;
    CHECK(std::count(found.err.begin(), found.err.end(), '\n') == (shows_formula ? 3 : 1));
    CHECK(dir.empty());
  }
  support::refused(GRAZE_VOXELIZE, "--scene spheres --formula x -o " + (dir / "a"),
                   "one of --scene, --formula, --info");
  support::refused(GRAZE_VOXELIZE, "--info a --formula x", "--formula");
  CHECK(dir.empty());
  CHECK(call(GRAZE_VOXELIZE, "--help").out.find("--formula") != std::string::npos);
}
