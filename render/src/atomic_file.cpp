#include <graze/render/atomic_file.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace graze::render {
namespace fs = std::filesystem;
namespace {

fs::path folder_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// Removes the temporary file unless it was renamed.
class temporary {
public:
  explicit temporary(std::string name)
      : name_(std::move(name)),
        file_(open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {}
  ~temporary() {
    if (file_ >= 0)
      close(file_);
    if (created_ && !renamed_)
      unlink(name_.c_str());
  }
  temporary(const temporary&) = delete;
  temporary& operator=(const temporary&) = delete;

  [[nodiscard]] bool is_open() const { return file_ >= 0; }

  bool write_all(std::span<const unsigned char> bytes) {
    while (!bytes.empty()) {
      const ssize_t n = write(file_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR)
        continue;
      if (n <= 0)
        return false;
      bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return true;
  }
  /// fsync, so that a rename never overtakes the data; a file system without fsync says EINVAL.
  bool finish() {
    if (fsync(file_) != 0 && errno != EINVAL && errno != ENOTSUP)
      return false;
    const int file = std::exchange(file_, -1);
    return close(file) == 0;
  }
  bool rename_to(const fs::path& target) {
    return renamed_ = rename(name_.c_str(), target.c_str()) == 0;
  }

private:
  std::string name_;
  int file_;
  bool created_ = file_ >= 0;
  bool renamed_ = false;
};

} // namespace

std::string why_not_writable(const fs::path& file) {
  std::error_code error;
  if (file.filename().empty())
    return fmt::format("the output '{}' names no file", file.string());
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, error))
    return fmt::format("the output folder '{}' does not exist", folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return fmt::format("the output folder '{}' may not be written to", folder.string());
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return fmt::format("the output '{}' is there and is not a regular file", file.string());
  return {};
}

expected<std::size_t> write_atomically(const fs::path& file, std::span<const unsigned char> bytes) {
  const auto failed = [&](const char* what) {
    return unexpected{fmt::format("cannot {} '{}': {}", what, file.string(), std::strerror(errno))};
  };
  std::error_code error; // through a symbolic link to the file that it names, not over the link
  const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
  const std::string name = fmt::format(".{}.part-{}", target.filename().string(), getpid());
  temporary part((folder_of(target) / name).string());
  if (!part.is_open())
    return failed("create");
  if (!part.write_all(bytes) || !part.finish())
    return failed("write");
  if (!part.rename_to(target))
    return failed("rename to");
  return bytes.size();
}

} // namespace graze::render
