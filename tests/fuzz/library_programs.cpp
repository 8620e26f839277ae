/// What graze-fuzz makes of the programs graze-adapter-NAME, shown with scripts in their place.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <external/libraries.hpp>
#include <filesystem>
#include <fstream>

using namespace graze::fuzz;
namespace fs = std::filesystem;

namespace {

/// A folder of programs, which GRAZE_ADAPTERS names while it lives.
class adapter_folder {
public:
  adapter_folder() {
    std::string name = (fs::temp_directory_path() / "graze-adapters-XXXXXX").string();
    path_ = mkdtemp(name.data());
    setenv("GRAZE_ADAPTERS", path_.c_str(), 1);
  }
  adapter_folder(const adapter_folder&) = delete;
  adapter_folder& operator=(const adapter_folder&) = delete;
  ~adapter_folder() {
    unsetenv("GRAZE_ADAPTERS");
    fs::remove_all(path_);
  }
  void add(const std::string& library, const std::string& script) const {
    const fs::path file = path_ / ("graze-adapter-" + library);
    std::ofstream(file) << "#!/bin/sh\n" << script;
    fs::permissions(file, fs::perms::owner_all);
  }

private:
  fs::path path_;
};

} // namespace

TEST_CASE("fuzz.libraries: a program says which variants it has", "[unit]") {
  const adapter_folder folder;
  CHECK(library_traversals().empty());
  folder.add("cgal",
             "printf 'cgal-a\\texactly-touched\\tfirst of two\\ncgal-b\\tcrossed\\tsecond\\n'");
  folder.add(
      "octomap",
      "printf 'octomap-c\\tcrossed\\tlisted before CGAL\\noctomap-d\\tperhaps\\tno promise\\n'");
  folder.add("pcl", "exit 1");
  folder.add("unlisted", "printf 'unlisted\\tcrossed\\tnot on the list\\n'");
  const auto found = library_traversals();
  REQUIRE(found.size() == 3);
  CHECK(found[0].name == "octomap-c"); // in the order of fuzz/peers/CMakeLists.txt
  CHECK(found[1].name == "cgal-a");
  CHECK(found[1].summary == "first of two");
  CHECK(found[1].make()->promises() == promise::exactly_touched);
  CHECK(found[2].make()->promises() == promise::crossed);
  CHECK(named_traversal("cgal-b"));
  CHECK_FALSE(named_traversal("cgal-c"));
  CHECK_FALSE(named_traversal("pcl"));
}

TEST_CASE("fuzz.libraries: a variant is asked by its name", "[unit]") {
  const adapter_folder folder;
  folder.add("embree", "case $1 in --variants) printf 'embree-x\\tcrossed\\tx\\n';; embree-x) "
                       "echo promise crossed; while read -r line; do echo; done;; esac\n");
  const auto entry = named_traversal("embree-x");
  REQUIRE(entry);
  visited out;
  entry->make()->visit(trial{}, out);
  CHECK(out.failed() == fault::none);
  CHECK(out.size() == 0);
}
