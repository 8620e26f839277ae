#pragma once
/// Runs statements and says which hold.
#include <graze/itf1788/syntax.hpp>

namespace graze::itf1788 {

enum class verdict {
  passed,
  tighter, ///< passed too: strictly within the stated result, and proved to be right (tighter.hpp)
  failed,
  unsupported,
};

struct judgement {
  verdict is = verdict::passed;
  std::string expected, got; ///< of a failure or a tighter result
  std::string missing;       ///< of an unsupported statement: "pow(interval, integer)"
};

/// "= C": every result is the same as stated, or a proof shows that a tighter one is right. "= C <=
/// D": it holds C and lies within D, decorations between theirs. "<= D": it lies within D. The
/// signal is the one stated, and none where none is.
judgement judge(const statement& s);

struct judged {
  statement stated;
  judgement is;
};

struct file_report {
  std::string path;
  std::vector<judged> statements;
  [[nodiscard]] int count(verdict v) const;
};

/// Bounds of a file: 16 MiB (the public suite's are below 1), and statements.
inline constexpr std::uint64_t largest_file = 1 << 24;

/// Reads a file and judges its statements; refused as by parse(), or when it cannot be read.
expected<file_report> run_file(const std::string& path);

/// The .itl files that a path stands for: a file itself, whatever its name; those in a folder and
/// in its subfolders, sorted by name. Refused: no such path, no .itl file in the folder.
expected<std::vector<std::string>> files_of(const std::string& path);

} // namespace graze::itf1788
