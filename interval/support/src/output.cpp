#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <graze/support/files.hpp>
#include <graze/support/interrupts.hpp>
#include <graze/support/output.hpp>
#include <graze/support/text.hpp>
#include <mutex>
#include <unistd.h>

namespace graze::support {
namespace {

/// A complaint is one line of no more than this.
constexpr std::size_t longest_complaint = 1000;

const char* name_of_program = "graze";
std::mutex output; ///< of what follows
int first_error = 0;

void note_error() {
  if (first_error == 0)
    first_error = errno != 0 ? errno : EIO;
  request_stop();
}

} // namespace

const char* program_name() { return name_of_program; }

void start_output(const char* name) {
  name_of_program = name;
  // a folder can be opened and neither read nor written
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) [[maybe_unused]]
      const int taken = ::open("/", O_RDONLY | O_DIRECTORY);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void print_text(std::string_view text) {
  const std::lock_guard lock(output);
  if (first_error != 0)
    return;
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
    note_error();
}

void flush_output() {
  const std::lock_guard lock(output);
  errno = 0;
  if (first_error == 0 && std::fflush(stdout) != 0)
    note_error();
}

status finish_output() {
  flush_output();
  const std::lock_guard lock(output);
  if (first_error == 0 && std::ferror(stdout) != 0) // of what others have printed
    first_error = EIO;
  // a file system over a network may tell only when a descriptor is closed
  if (const int copy = dup(STDOUT_FILENO); first_error == 0 && copy >= 0 && close(copy) != 0)
    first_error = errno;
  if (first_error == 0)
    return {};
  return unexpected{std::string("cannot write to standard output: ") + std::strerror(first_error)};
}

void complain(std::string_view text) {
  print_error(std::string(name_of_program) + ": " + shown(text, longest_complaint) + '\n');
}

void print_error(std::string_view text) {
  // not by stdio, which would try again at the end what could not be written
  [[maybe_unused]] const bool written = write_all(STDERR_FILENO, text);
}

} // namespace graze::support
