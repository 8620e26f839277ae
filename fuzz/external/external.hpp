#pragma once
/// A traversal in another process, in any language, driven by lines (docs/adapters.md).
#include <external/line_protocol.hpp>
#include <traversal/list.hpp>

namespace graze::fuzz {

/// What the user asks for. What is left open is as the traversal's first line says, or else as
/// here.
struct external_options {
  std::string command;                     ///< for sh -c
  std::optional<promise> promised;         ///< instead of what it says itself; else `crossed`
  std::optional<cell_kind> cells;          ///< what its rays are sent through
  std::optional<bool> segments;            ///< whether it is sent segments
  cell_kind usual_cells = cell_kind::cube; ///< where neither says so
  bool usual_segments = false;             ///< likewise
  std::optional<double> tolerance;         ///< of t and distance, in ulps
  std::uint64_t batch = 0;                 ///< requests a message; 0: as it says, or one by one
  double seconds_a_ray = 2;                ///< a longer silence is a hang
  double start_seconds = 30;               ///< for its first answer of all, beyond that
  line_format format = line_format::json;
  bool as_float =
      false; ///< rays and boxes are rounded to float before they are sent, and judged so
  bool needs_received = false; ///< an answer without the ray that was received is malformed
  bool show_errors = false;    ///< its standard error is ours
  bool echo = false; ///< its first request asks for the hard numbers back: as its first line says
  std::shared_ptr<const voxel_map> map; ///< all trials are of this map: it is told to the command
};

/// The traversal behind a command; each that is made has a process of its own, started when it is
/// first asked, and again after each fault. Several rays are sent at a time. After a fault among
/// several rays, those that have no answer are asked again one at a time, so that the fault is that
/// of the ray which brings it on (output that was not flushed when the process ended, or a slow
/// moment of the machine, must not be blamed on others). A fault that does not come again is booked
/// on the last of them, unless it was a hang.
///
/// The command is tried with one ray first: refused, with the reason, when it gives no answer to it,
/// gives hard_numbers() back as others, or says in its first line what is not known or contradicts the
/// options. What it says there holds for the traversal. The entry's `notices` are for the user.
expected<traversal_entry> external_traversal(const external_options& options);

/// The same, not tried: for a program that is known to be there. Its promise is given.
traversal_entry untried_external_traversal(const external_options& options, std::string_view name,
                                           std::string_view summary);

/// The first request of a process, for this trial: as the traversal is asked in a campaign.
std::string first_request(const trial& t, const external_options& options);

/// The numbers that a traversal in float works on: the ray, the segment's end and the boxes of t, rounded.
received_ray rounded_to_float(const trial& t);

/// As one word of a shell's command line.
std::string shell_word(std::string_view text);

/// How a user asks for it: "--command '...' ..."; without cells and segments, which a replay file says.
std::string spelled(const external_options& options);

} // namespace graze::fuzz
