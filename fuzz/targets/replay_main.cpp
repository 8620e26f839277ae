/// Runs a fuzz target on its seeds and on the files that are given, or writes its seeds. Exit
/// codes: 0 all held (else the target aborts), 2 bad input.
#include "target.hpp"
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <graze/fuzz/campaign_store.hpp>
#include <graze/rounding/environment.hpp>
#include <iterator>

namespace {

namespace fs = std::filesystem;

void run(const std::string& input) {
  // a copy of its own, so that a sanitizer sees what is read beyond its end
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

int bad_input(const std::string& why) {
  std::fprintf(stderr, "replay: %s\n", why.c_str());
  return 2;
}

/// Each in a file named by its content.
int write_seeds(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (const std::string& seed : graze::fuzz::target::seeds()) {
    const fs::path file = folder / graze::fuzz::content_hash(seed);
    std::ofstream out(file, std::ios::binary);
    out << seed;
    out.close();
    if (!out)
      return bad_input("cannot write " + file.string());
  }
  return 0;
}

int run_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string input{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in)
    return bad_input("cannot read " + path.string());
  std::fprintf(stderr, "%s\n", path.c_str()); // the last one named is the one that aborts
  run(input);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-fuzz-target"))
    return 2;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments[0] == "--seeds")
    return arguments.size() == 2 ? write_seeds(arguments[1]) : bad_input("--seeds wants a folder");
  std::vector<fs::path> files;
  for (const std::string& name : arguments) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    const std::size_t before = files.size();
    for (const auto& entry : fs::recursive_directory_iterator(name, error))
      if (entry.is_regular_file())
        files.push_back(entry.path());
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
  }
  run({});
  const std::vector<std::string> seeds = graze::fuzz::target::seeds();
  for (const std::string& seed : seeds)
    run(seed);
  for (const fs::path& file : files)
    if (const int code = run_file(file); code != 0)
      return code;
  std::printf("%zu seeds and %zu files\n", seeds.size(), files.size());
}
