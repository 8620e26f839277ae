#pragma once
/// Files as programs read and write them. POSIX. Reasons are one line and name the file.
///
/// Read and written are regular files only, links followed: a folder, FIFO, socket or device is
/// refused before it is opened, since opening alone can wait for ever or move a machine.
#include <cstdint>
#include <graze/support/status.hpp>
#include <span>
#include <string>
#include <string_view>

namespace graze::support {

/// 'path', fit to be shown.
std::string in_quotes(std::string_view path);
/// "cannot VERB 'path': why", by errno or by the number given.
unexpected failed(const char* verb, std::string_view path);
unexpected failed(const char* verb, std::string_view path, int error);

/// A descriptor that is closed at the end of its life.
class descriptor {
public:
  explicit descriptor(int number = -1) : number_(number) {}
  ~descriptor() { close(); }
  descriptor(descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  descriptor& operator=(descriptor&& other) noexcept {
    if (this != &other) {
      close();
      number_ = std::exchange(other.number_, -1);
    }
    return *this;
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  /// False with errno where the system had kept back an error until now.
  bool close();

private:
  int number_;
};

/// A file that is read from its beginning, piece by piece.
class input_file {
public:
  static expected<input_file> open(const std::string& path);
  /// Standard input, whatever it is.
  static input_file standard_input();

  /// Its length when it was opened; 0 for standard input.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /// The next `most` bytes; fewer at the end only.
  expected<std::string> read(std::size_t most);
  /// All that is left, if it is no more than `most` bytes.
  expected<std::string> read_all(std::uint64_t most);
  /// The next line into `line`, without its end; false at the end. A line of more than `longest`
  /// bytes is refused.
  expected<bool> read_line(std::string& line, std::size_t longest);
  /// The last line that was read had an end, rather than the file.
  [[nodiscard]] bool line_was_whole() const { return whole_; }
  /// Of that line, from 1.
  [[nodiscard]] std::uint64_t line_number() const { return lines_; }

private:
  input_file(descriptor from, std::string path, std::uint64_t size)
      : from_(std::move(from)), path_(std::move(path)), size_(size) {}
  descriptor from_;
  std::string path_;
  std::uint64_t size_, lines_ = 0;
  std::string buffer_; ///< of read_line: what lies from at_ on is not yet given out
  std::size_t at_ = 0;
  bool whole_ = true;
};

/// All of a file of at most `most` bytes.
expected<std::string> read_file(const std::string& path, std::uint64_t most);

/// Whether a file could be written, asked before the work: its name is not too long, its folder is
/// there and may be written to, and it is absent or a regular file that may be written to.
status check_writable(const std::string& path);

/// Writes the bytes under a name of its own in the same folder, flushes them to the disk and
/// renames. Through links to the file that they name; never over what is no regular file. An older
/// file keeps its permissions; on any failure it is as it was, and nothing new is left.
status write_atomically(const std::string& path, std::string_view bytes);
inline status write_atomically(const std::string& path, std::span<const unsigned char> bytes) {
  return write_atomically(
      path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

/// Something has this name, or what it is cannot be told.
bool is_there(const std::string& path);

/// What write_atomically names its files until they are whole begins so.
inline constexpr std::string_view part_prefix = ".graze-part-";

/// A file that grows by whole pieces, each flushed to the disk.
class append_file {
public:
  /// Makes it if need be, and cuts it off after `keep` bytes.
  static expected<append_file> open(const std::string& path, std::uint64_t keep);
  status append(std::string_view bytes);

private:
  append_file(descriptor to, std::string path) : to_(std::move(to)), path_(std::move(path)) {}
  descriptor to_;
  std::string path_;
};

/// A lock that this process holds alone as long as the descriptor lives; it ends with the process,
/// however that ends, and a child does not inherit it. Makes the file if need be. `in_use` is the
/// reason where another process holds it.
expected<descriptor> lock_file(const std::string& path, const std::string& in_use);

/// Makes a folder that may be there already; its parent is there.
status make_folder(const std::string& path);

/// Writes all of it; false with errno.
bool write_all(int to, std::string_view bytes);

} // namespace graze::support
