#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <graze/rounding/environment.hpp>
#include <graze/support/program.hpp>
#include <graze/support/text.hpp>
#include <new>
#include <optional>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace graze::support {
namespace {

int finished(int code) {
  if (const status written = finish_output(); !written) {
    complain(written.reason());
    return refused;
  }
  return code;
}

/// The number of a file that holds nothing else.
std::optional<std::uint64_t> number_in(const char* path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

/// Bytes that may be allocated before something is taken from others.
std::optional<std::uint64_t> free_memory() {
  std::optional<std::uint64_t> bytes;
  std::ifstream machine("/proc/meminfo");
  for (std::string name; machine >> name;) {
    std::uint64_t kibibytes = 0;
    if (name == "MemAvailable:" && machine >> kibibytes)
      bytes = 1024 * kibibytes;
    machine.ignore(256, '\n');
  }
  const auto most = number_in("/sys/fs/cgroup/memory.max"), // "max" where there is no limit
      used = number_in("/sys/fs/cgroup/memory.current");
  if (most && used && bytes)
    bytes = std::min(*bytes, *most > *used ? *most - *used : 0);
  return bytes;
}

} // namespace

void limit_memory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const auto bytes = free_memory();
  rlimit now{};
  // RLIMIT_DATA: what may be written to; not what is only reserved
  if (!bytes || getrlimit(RLIMIT_DATA, &now) != 0)
    return;
  now.rlim_cur = std::min<rlim_t>(now.rlim_cur, *bytes / 10 * 9);
  setrlimit(RLIMIT_DATA, &now);
#endif
}

int run_program(const char* name, int argc, char** argv, int (*body)(int, char**)) {
  start_output(name);
  int code = refused;
  try {
    if (rounding::program_may_start(name))
      code = body(argc, argv);
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
  } catch (const std::exception& e) {
    complain(e.what());
  } catch (...) {
    complain("an unexpected exception");
  }
  return finished(code);
}

void end_program(int code) { _exit(finished(code)); }

const char* version() { return GRAZE_VERSION; }

std::optional<int> parse_arguments(CLI::App& app, int argc, char** argv) {
  const std::string text = std::string(program_name()) + " " + version();
  app.set_version_flag("--version", text);
  for (CLI::App* const subcommand : app.get_subcommands({}))
    subcommand->set_version_flag("--version", text);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0)
      return bad_input(std::string(e.what()) + " (--help shows the options)");
    std::ostringstream help;
    app.exit(e, help, help);
    print_text(help.str());
    return done;
  }
  return std::nullopt;
}

int bad_input(std::string_view reason) {
  complain(reason);
  return refused;
}

CLI::Validator whole_number() {
  return {[](std::string& text) -> std::string {
            std::uint64_t value = 0;
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), value);
            if (error == std::errc() && end == text.data() + text.size())
              return {};
            return text + " is not a whole number, 0 or more, of 64 bits";
          },
          "", "whole number"};
}

unsigned default_threads() {
  return std::clamp(std::thread::hardware_concurrency(), 1u, most_threads);
}

} // namespace graze::support
