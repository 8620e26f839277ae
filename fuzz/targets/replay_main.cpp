/// Runs a fuzz target on its seeds and on the files that are given, writes its seeds (--seeds FOLDER), or
/// runs it on so many inputs that are mutated from its seeds (--mutate COUNT [SEED]), where no engine is
/// linked: each within 5 s, all within 256 MB (more under a sanitizer, which takes some itself). Exit
/// codes: 0 all held (else the target aborts), 2 bad input.
#include "target.hpp"
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <graze/rounding/environment.hpp>
#include <iterator>
#include <sys/resource.h>
#include <trial/content_hash.hpp>

// the target's own, where it has one
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                             std::size_t max_size, unsigned seed);

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

/// One change of the kinds that fuzzing engines make.
std::string mutated(graze::fuzz::random_stream& random, std::string text,
                    const std::vector<std::string>& seeds) {
  static const char* const words[] = {
      "[",         "{",         "\"",     "\\u0000", "1e999",
      "-0",        "nan",       "1e-400", "null",    "\xff\xfe",
      ",",         ":",         "]}",     "[[",      "18446744073709551616",
      "0x1p-1074", "(((((((((", "^9999"};
  const auto below = [&random](std::size_t n) {
    return n == 0 ? 0 : random.below(static_cast<unsigned>(n));
  };
  const std::size_t at = below(text.size() + 1),
                    length = below(std::min<std::size_t>(text.size() - at, 32) + 1);
  switch (random.below(8)) {
  case 0:
    if (at < text.size())
      text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
    break;
  case 1:
    if (at < text.size())
      text[at] = static_cast<char>(random.below(256));
    break;
  case 2:
    text.erase(at, length);
    break;
  case 3:
    text.insert(at, text.substr(at, length));
    break;
  case 4:
    text.insert(at, words[below(std::size(words))]);
    break;
  case 5: { // a part many times: what nests, and what is long
    const std::string part = text.substr(at, 1 + length);
    for (unsigned n = 1u << random.below(10); n > 0; --n)
      text.insert(at, part);
    break;
  }
  case 6: { // the beginning of one and the end of another
    const std::string& other = seeds[below(seeds.size())];
    text = text.substr(0, at) + other.substr(below(other.size() + 1));
    break;
  }
  default:
    text.resize(at);
  }
  return text;
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// Inputs are no longer than this.
constexpr std::size_t longest = 1 << 16;

/// For a target's own mutator, which asks LLVMFuzzerMutate.
graze::fuzz::random_stream* stream = nullptr;
const std::vector<std::string>* all_seeds = nullptr;

std::string changed(graze::fuzz::random_stream& random, std::string text) {
  if (LLVMFuzzerCustomMutator == nullptr) {
    text = mutated(random, std::move(text), *all_seeds);
    text.resize(std::min(text.size(), longest));
    return text;
  }
  text.resize(std::min(text.size(), longest));
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  bytes.resize(longest);
  bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), text.size(), bytes.size(),
                                       static_cast<unsigned>(random.bits(32))));
  return {bytes.begin(), bytes.end()};
}

int run_mutated(std::uint64_t count, std::uint64_t seed) {
  using clock = std::chrono::steady_clock;
  const std::vector<std::string> seeds = graze::fuzz::target::seeds();
  all_seeds = &seeds;
  double slowest = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    graze::fuzz::random_stream random(seed, k);
    stream = &random;
    std::string text = seeds[random.below(static_cast<unsigned>(seeds.size()))];
    for (unsigned changes = 1 + random.below(6); changes > 0; --changes)
      text = changed(random, std::move(text));
    const auto start = clock::now();
    run(text);
    slowest = std::max(slowest, std::chrono::duration<double>(clock::now() - start).count());
    graze::fuzz::target::require(slowest < 5, "an input that takes more than 5 s");
  }
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const long megabytes = used.ru_maxrss / 1024;
  graze::fuzz::target::require(sanitized || megabytes < 256, "more than 256 MB");
  std::printf("%llu mutated inputs, the slowest took %.3f s, %ld MB at most\n",
              static_cast<unsigned long long>(count), slowest, megabytes);
  return 0;
}

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                        std::size_t max_size) {
  const std::string text = mutated(*stream, {data, data + size}, *all_seeds);
  const std::size_t length = std::min(text.size(), max_size);
  std::copy_n(text.begin(), length, data);
  return length;
}

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-fuzz-target"))
    return 2;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments[0] == "--seeds")
    return arguments.size() == 2 ? write_seeds(arguments[1]) : bad_input("--seeds wants a folder");
  if (!arguments.empty() && arguments[0] == "--mutate") {
    std::uint64_t numbers[] = {0, 1};
    for (std::size_t i = 1; i < arguments.size() && i < 3; ++i) {
      const std::string& text = arguments[i];
      const auto [end, error] =
          std::from_chars(text.data(), text.data() + text.size(), numbers[i - 1]);
      if (error != std::errc() || end != text.data() + text.size())
        return bad_input(text + " is not a number");
    }
    return numbers[0] != 0 ? run_mutated(numbers[0], numbers[1])
                           : bad_input("--mutate wants a count");
  }
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
