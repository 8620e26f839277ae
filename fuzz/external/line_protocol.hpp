#pragma once
/// What graze-fuzz and a traversal in another process say to each other: a line for a ray, a line
/// for its answer. For whoever writes the other side: docs/adapters.md.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <traversal/traversal.hpp>

namespace graze::fuzz {

/// `json`: an object a line. `plain`: the numbers with blanks between them, doubles as hex floats, for
/// scanf. `bits`: the same, a double as the 16 hex digits of its bits. Answers are read in JSON and
/// plain, whichever is asked in.
enum class line_format : std::uint8_t { json, plain, bits };

/// Doubles that bad readers and writers of decimals get wrong; the first is -0.
using echo_numbers = std::array<double, 16>;
const echo_numbers& hard_numbers();

/// What a process is told once, with its first request.
struct opening {
  bool echo = false; ///< hard_numbers(), to be given back
  bool grid = false; ///< of a map, its grid and what the library calls its first voxel
};

/// Appends the request for a trial, with its line's end.
void append_request(std::string& text, const trial& t, std::uint64_t id, line_format format,
                    opening first = {});
/// The requests for the trials of these places, in one message: ids from `first_id` on. In JSON one
/// line, else "batch N" and N lines.
void append_batch(std::string& text, std::span<const trial> trials,
                  std::span<const std::size_t> places, std::uint64_t first_id, line_format format,
                  opening first = {});

/// How an answer is read.
struct answer_form {
  promise promised = promise::crossed;
  bool bits = false;           ///< 16 hex digits in a plain line are a double's bits
  bool needs_received = false; ///< without the ray that was received it is malformed
};

/// The doubles that were to be given back, as they came back.
struct echoed {
  bool given = false;
  echo_numbers numbers{};
  bool sign_of_zero = true; ///< the -0 came back as such
};

/// Reads the answer to request `id` for trial t. What is not an answer is a fault in `out`, with the
/// reason.
void read_answer(std::string_view line, const trial& t, std::uint64_t id, const answer_form& form,
                 visited& out, echoed* echo = nullptr);
/// Reads {"answers":[...]}, the answers to what append_batch() asked. False where there are not as many:
/// then they are malformed.
bool read_batch(std::string_view line, std::span<const trial> trials,
                std::span<const std::size_t> places, std::uint64_t first_id,
                const answer_form& form, std::span<visited> out, echoed* echo = nullptr);

/// The line that a traversal may send before its first answer: what it promises, and what it is to be
/// asked, and how.
struct hello {
  std::optional<promise> promised;
  std::optional<cell_kind> cells;
  std::optional<bool> segments;
  std::optional<std::uint64_t> batch; ///< requests a message, at most
  std::optional<line_format> numbers; ///< `json`: decimals
  std::optional<double> tolerance;
  bool echo = false;     ///< it gives the hard numbers back in a plain form too
  bool as_float = false; ///< numbers are to be rounded to float before they are sent
  bool plain = false;    ///< it was no JSON
  std::string wrong;     ///< what is wrong with it; empty where nothing is
};
/// Nothing when the line is something else.
std::optional<hello> read_hello(std::string_view line);

/// The names of all promises, for messages.
std::string promise_names();
std::string_view name_of(cell_kind cells);
/// By the names of name_of().
std::optional<cell_kind> cell_kind_of(std::string_view name);

} // namespace graze::fuzz
