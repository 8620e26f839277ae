#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <sys/stat.h>
#include <unistd.h>

namespace graze::support {
namespace {

namespace fs = std::filesystem;

/// Regular, of this size; the reason why it is not.
expected<std::uint64_t> size_of_regular(const struct stat& found, const char* verb,
                                        const std::string& path) {
  const char* const kind = S_ISREG(found.st_mode)    ? nullptr
                           : S_ISDIR(found.st_mode)  ? "is a folder"
                           : S_ISFIFO(found.st_mode) ? "is a FIFO"
                           : S_ISSOCK(found.st_mode) ? "is a socket"
                                                     : "is a device";
  if (kind != nullptr)
    return unexpected{std::string("cannot ") + verb + ' ' + in_quotes(path) + ": it " + kind};
  return static_cast<std::uint64_t>(found.st_size);
}

/// Opens a regular file, or makes one where `flags` hold O_CREAT.
expected<descriptor> open_regular(const std::string& path, int flags, const char* verb) {
  struct stat found{};
  if (stat(path.c_str(), &found) == 0) {
    if (const auto size = size_of_regular(found, verb, path); !size)
      return unexpected{size.reason()};
  } else if (errno != ENOENT || (flags & O_CREAT) == 0) {
    return failed(verb, path);
  }
  // O_NONBLOCK: what has become a FIFO since then is not waited for
  descriptor file(::open(path.c_str(), flags | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666));
  if (!file.is_open() || fstat(file.number(), &found) != 0)
    return failed(verb, path);
  if (const auto size = size_of_regular(found, verb, path); !size)
    return unexpected{size.reason()};
  return file;
}

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Where the bytes go in the end: the file that a link names.
expected<std::string> target_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error))
    return path;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error)
    return failed("write", path, error.value());
  if (fs::is_symlink(target, error))
    return unexpected{"cannot write " + in_quotes(path) + ": it is a link to what is not there"};
  return target.string();
}

/// fsync; a file system without it says EINVAL.
bool sync(int file) { return fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP; }

/// Makes the names in a folder last.
bool sync_folder(const std::string& folder) {
  const descriptor d(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // a folder that may be written to but not read cannot be synced, and need not be
  return d.is_open() ? sync(d.number()) : errno == EACCES;
}

} // namespace

std::string in_quotes(std::string_view path) { return '\'' + shown(path) + '\''; }

unexpected failed(const char* verb, std::string_view path) { return failed(verb, path, errno); }

unexpected failed(const char* verb, std::string_view path, int error) {
  return unexpected{std::string("cannot ") + verb + ' ' + in_quotes(path) + ": " +
                    std::strerror(error)};
}

bool descriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0;
}

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(to, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR)
      return false;
    if (n > 0)
      bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

expected<input_file> input_file::open(const std::string& path) {
  auto file = open_regular(path, O_RDONLY, "read");
  if (!file)
    return unexpected{file.reason()};
  struct stat found{};
  fstat(file->number(), &found);
  return input_file(*std::move(file), path, static_cast<std::uint64_t>(found.st_size));
}

input_file input_file::standard_input() {
  return {descriptor(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)), "standard input", 0};
}

expected<std::string> input_file::read(std::size_t most) {
  std::string bytes;
  while (bytes.size() < most) {
    // no more at once than is likely to be there: a bound is no reason to take its memory
    const std::size_t before = bytes.size();
    const std::size_t piece = std::min<std::size_t>(
        most - before, std::clamp<std::uint64_t>(size_ + 1, 1 << 16, 1 << 24));
    bytes.resize(before + piece);
    const ssize_t n = ::read(from_.number(), bytes.data() + before, piece);
    bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n < 0 && errno != EINTR)
      return failed("read", path_);
    if (n == 0)
      break;
  }
  return bytes;
}

expected<std::string> input_file::read_all(std::uint64_t most) {
  const auto too_large = [&] {
    return unexpected{"cannot read " + in_quotes(path_) + ": it is larger than " +
                      std::to_string(most) + " bytes"};
  };
  if (size_ > most)
    return too_large();
  auto bytes = read(most + 1);
  if (bytes && bytes->size() > most)
    return too_large();
  return bytes;
}

expected<bool> input_file::read_line(std::string& line, std::size_t longest) {
  std::size_t searched = at_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    whole_ = end != std::string::npos;
    if ((whole_ ? end : buffer_.size()) - at_ > longest)
      return unexpected{in_quotes(path_) + ", line " + std::to_string(lines_ + 1) +
                        ": longer than " + std::to_string(longest) + " bytes"};
    if (whole_) {
      line.assign(buffer_, at_, end - at_);
      at_ = end + 1;
      ++lines_;
      return true;
    }
    buffer_.erase(0, at_);
    at_ = 0;
    searched = buffer_.size();
    auto more = read(1 << 16);
    if (!more)
      return unexpected{more.reason()};
    if (more->empty()) {
      line = std::exchange(buffer_, {});
      lines_ += line.empty() ? 0 : 1;
      return !line.empty();
    }
    buffer_ += *more;
  }
}

expected<std::string> read_file(const std::string& path, std::uint64_t most) {
  auto file = input_file::open(path);
  if (!file)
    return unexpected{file.reason()};
  return file->read_all(most);
}

status check_writable(const std::string& path) {
  if (fs::path(path).filename().empty())
    return unexpected{"cannot write " + in_quotes(path) + ": it names no file"};
  const auto target = target_of(path);
  if (!target)
    return unexpected{target.reason()};
  struct stat found{};
  if (stat(target->c_str(), &found) == 0) {
    if (const auto size = size_of_regular(found, "write", path); !size)
      return unexpected{size.reason()};
    if (access(target->c_str(), W_OK) != 0)
      return failed("write", path);
  } else if (errno != ENOENT) {
    return failed("write", path);
  }
  const std::string folder = folder_of(*target);
  if (stat(folder.c_str(), &found) != 0)
    return failed("write to the folder", folder);
  if (!S_ISDIR(found.st_mode))
    return failed("write to the folder", folder, ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return failed("write to the folder", folder);
  return {};
}

status write_atomically(const std::string& path, std::string_view bytes) {
  if (auto may = check_writable(path); !may)
    return may;
  const std::string target = *target_of(path);
  static std::atomic<unsigned> made{0};
  const std::string part = folder_of(target) + '/' + std::string(part_prefix) +
                           std::to_string(getpid()) + '-' + std::to_string(++made);
  descriptor file(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file.is_open())
    return failed("write", path);
  struct stat older{};
  const bool replaces = stat(target.c_str(), &older) == 0;
  if (write_all(file.number(), bytes) &&
      (!replaces || fchmod(file.number(), older.st_mode & 0777) == 0) && sync(file.number()) &&
      file.close() && (!replaces || S_ISREG(older.st_mode)) &&
      rename(part.c_str(), target.c_str()) == 0)
    return sync_folder(folder_of(target)) ? status() : status(failed("sync", path));
  const unexpected why = failed("write", path);
  unlink(part.c_str());
  return why;
}

bool is_there(const std::string& path) {
  struct stat found{};
  return lstat(path.c_str(), &found) == 0 || (errno != ENOENT && errno != ENOTDIR);
}

expected<append_file> append_file::open(const std::string& path, std::uint64_t keep) {
  auto file = open_regular(path, O_WRONLY | O_CREAT | O_APPEND, "write");
  if (!file)
    return unexpected{file.reason()};
  if (ftruncate(file->number(), static_cast<off_t>(keep)) != 0 || !sync(file->number()) ||
      !sync_folder(folder_of(path)))
    return failed("write", path);
  return append_file(*std::move(file), path);
}

status append_file::append(std::string_view bytes) {
  if (!write_all(to_.number(), bytes) || !sync(to_.number()))
    return failed("write", path_);
  return {};
}

expected<descriptor> lock_file(const std::string& path, const std::string& in_use) {
  auto file = open_regular(path, O_RDWR | O_CREAT, "write");
  if (!file)
    return file;
  struct flock whole_file{};
  whole_file.l_type = F_WRLCK;
  whole_file.l_whence = SEEK_SET;
  if (fcntl(file->number(), F_SETLK, &whole_file) == 0)
    return file;
  if (errno == EACCES || errno == EAGAIN)
    return unexpected{in_use};
  return failed("lock", path);
}

status make_folder(const std::string& path) {
  if (mkdir(path.c_str(), 0777) == 0)
    return {};
  struct stat found{};
  if (errno == EEXIST && stat(path.c_str(), &found) == 0 && !S_ISDIR(found.st_mode))
    errno = ENOTDIR;
  else if (errno == EEXIST)
    return {};
  return failed("make the folder", path);
}

} // namespace graze::support
