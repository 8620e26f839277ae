#pragma once
/// What graze-fuzz and a traversal in another process say to each other: a line for a ray, a line
/// for its answer. For whoever writes the other side: docs/adapters.md.
#include <optional>
#include <string>
#include <string_view>
#include <traversal/traversal.hpp>

namespace graze::fuzz {

/// `json`: an object a line. `plain`: the same numbers with blanks between them, hex floats, for
/// scanf. Answers are read in both, whichever is asked in.
enum class line_format { json, plain };

/// Appends the request for a trial, with its line's end.
void append_request(std::string& text, const trial& t, std::uint64_t id, line_format format);

/// Reads the answer to request `id` for trial t. What is not an answer is a fault in `out`.
void read_answer(std::string_view line, const trial& t, std::uint64_t id, visited& out);

/// The line that a traversal may send before its first answer.
struct hello {
  std::optional<promise> promised;
  std::string wrong; ///< the promise that is none
};
/// Nothing when the line is something else.
std::optional<hello> read_hello(std::string_view line);

} // namespace graze::fuzz
