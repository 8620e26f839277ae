#pragma once
/// A program as its users meet it: what it prints, its exit code, and the folder it is given.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace support {

struct outcome {
  int code;
  std::string out, err;
};

/// A fresh folder, gone at the end.
class scratch {
public:
  scratch() {
    char name[] = "/tmp/graze-test-XXXXXX";
    path_ = mkdtemp(name);
  }
  ~scratch() { std::filesystem::remove_all(path_); }
  scratch(const scratch&) = delete;
  scratch& operator=(const scratch&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] bool empty() const { return std::filesystem::is_empty(path_); }

private:
  std::string path_;
};

inline std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Runs `program arguments` by the shell. `before` is put in front: a limit, a variable. The time
/// limit is for what hangs where no ctest watches.
inline outcome call(const std::string& program, const std::string& arguments,
                    const std::string& before = "timeout 600 ") {
  const scratch dir;
  const std::string command =
      before + "'" + program + "' " + arguments + " >" + (dir / "out") + " 2>" + (dir / "err");
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(dir / "out"), content(dir / "err")};
}

/// Bad input: one clear line on stderr that begins with the program's name and holds `reason`, then
/// `lines`, nothing on stdout, exit code 2.
inline void refused(const std::string& program, const std::string& arguments,
                    const std::string& reason, const std::string& lines = "") {
  const outcome o = call(program, arguments);
  INFO(arguments << "\n" << o.out << o.err);
  CHECK(o.code == 2);
  CHECK(o.out.empty());
  CHECK(o.err.substr(std::min(o.err.find('\n') + 1, o.err.size())) == lines);
  CHECK(o.err.rfind(std::filesystem::path(program).filename().string() + ": ", 0) == 0);
  CHECK(o.err.find(reason) != std::string::npos);
}

} // namespace support
