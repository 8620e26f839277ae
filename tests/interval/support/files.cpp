// Files: what is no regular file is refused before it is read or replaced; what is written is whole.
#include "../../support/program.hpp"
#include <graze/support/files.hpp>
#include <sys/stat.h>

using graze::support::input_file, graze::support::read_file, graze::support::check_writable,
    graze::support::write_atomically, graze::support::append_file, graze::support::lock_file;
using support::content, support::scratch;
namespace fs = std::filesystem;

TEST_CASE("support.files: what is no regular file is refused, at once and by its kind", "[unit]") {
  const scratch dir;
  mkfifo((dir / "fifo").c_str(), 0666);
  fs::create_directory(dir / "folder");
  fs::create_symlink("loop", dir / "loop");
  fs::create_symlink("nothing", dir / "dangling");
  const std::pair<const char*, const char*> kinds[] = {
      {"fifo", "is a FIFO"}, {"folder", "is a folder"}, {"loop", "symbolic links"}};
  for (const auto& [name, why] : kinds) {
    INFO(name);
    const auto mode = fs::symlink_status(dir / name).type();
    CHECK(read_file(dir / name, 10).reason().find(why) != std::string::npos);
    CHECK(check_writable(dir / name).reason().find(why) != std::string::npos);
    CHECK(write_atomically(dir / name, "x").reason().find(why) != std::string::npos);
    CHECK_FALSE(append_file::open(dir / name, 0).has_value());
    CHECK_FALSE(lock_file(dir / name, "in use").has_value());
    CHECK(fs::symlink_status(dir / name).type() == mode);
  }
  CHECK_FALSE(write_atomically(dir / "dangling", "x"));
  CHECK_FALSE(check_writable(dir / std::string(300, 'n')));
  CHECK_FALSE(check_writable(dir / "none/a"));
  CHECK_FALSE(check_writable(dir / "folder/"));
}

TEST_CASE("support.files: written whole, through links, with the older file's permissions",
          "[unit]") {
  const scratch dir;
  REQUIRE(write_atomically(dir / "a", "first"));
  CHECK(content(dir / "a") == "first");
  chmod((dir / "a").c_str(), 0640);
  fs::create_symlink("a", dir / "link");
  REQUIRE(write_atomically(dir / "link", "second"));
  CHECK(fs::is_symlink(dir / "link"));
  CHECK(content(dir / "a") == "second");
  struct stat now{};
  REQUIRE(stat((dir / "a").c_str(), &now) == 0);
  CHECK((now.st_mode & 0777) == 0640);
  // a name of 255 bytes, the longest: the name in between is no longer
  REQUIRE(write_atomically(dir / std::string(255, 'n'), "long"));
  CHECK(std::distance(fs::directory_iterator(fs::path(dir / "a").parent_path()), {}) == 3);
}

TEST_CASE("support.files: lines of any length up to a bound, and the last one cut off", "[unit]") {
  const scratch dir;
  const std::string longest(100'000, 'x');
  std::ofstream(dir / "lines") << "one\n\n" << longest << "\nrest";
  auto file = input_file::open(dir / "lines");
  REQUIRE(file.has_value());
  std::string line;
  for (const std::string& expected : {std::string("one"), std::string(), longest}) {
    const auto read = file->read_line(line, longest.size());
    REQUIRE((read && *read));
    CHECK(line == expected);
    CHECK(file->line_was_whole());
  }
  CHECK(file->line_number() == 3);
  CHECK(*file->read_line(line, 10));
  CHECK(line == "rest");
  CHECK_FALSE(file->line_was_whole());
  CHECK_FALSE(*file->read_line(line, 10));
  file = input_file::open(dir / "lines");
  CHECK(*file->read_line(line, 10));
  CHECK(*file->read_line(line, 10));
  CHECK_FALSE(file->read_line(line, longest.size() - 1).has_value());
  CHECK_FALSE(read_file(dir / "lines", 100).has_value());
  CHECK(read_file(dir / "lines", 200'000)->size() == longest.size() + 10);
}

TEST_CASE("support.files: a file grows by whole pieces behind what is kept", "[unit]") {
  const scratch dir;
  std::ofstream(dir / "log") << "whole\ncut o";
  auto log = append_file::open(dir / "log", 6);
  REQUIRE(log.has_value());
  REQUIRE(log->append("next\n"));
  CHECK(content(dir / "log") == "whole\nnext\n");
}
