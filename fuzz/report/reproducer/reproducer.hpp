#pragma once
/// What a maintainer is handed for a finding: five small files about one ray and one octant.
///
///   NAME.json  the replay line ("graze-fuzz replay NAME.json")
///   NAME.txt   root, level, ray, octant, what was missed, by how much, judged by what
///   NAME.cpp   the ray and the box in hex floats; where 128-bit integers hold the products, the
///              claim as a static_assert, in plain C++ without Graze
///   NAME.svg   the ray and the octants on the two axes that tell most
///   a test in the language of the traversal, by its bits and what must be visited (test_file.hpp)
///
/// Of a segment, and of voxels of a grid and boxes, all but snippet and picture; of a map the first two
/// alone.
/// NAME is traversal-finding-HASH, the hash being that of the replay line: one case, one name.
#include <external/external.hpp>
#include <graze/support/status.hpp>
#include <judge/replay.hpp>

namespace graze::fuzz {

/// In which the test is written.
enum class language : std::uint8_t { rust, go, java, javascript, python, cpp };

/// For whom a reproducer is written.
struct reader_of_test {
  language written = language::cpp;
  std::optional<external_options>
      external{}; ///< the command that the test asks; else a function is left to be filled in
};

/// A finding with all that is told about it.
struct reproduction {
  trial at;       ///< what the traversal was given: the replay line
  trial answered; ///< the same with the ray that it received: what text, snippet and picture show
  std::string traversal;
  std::string options; ///< how graze-fuzz is asked for it: "--traversal NAME"
  promise promises;
  finding kind;
  visited answer{};
  allowance allowed{};    ///< to rounding
  replay_result judged{}; ///< by rationals
  octant_number subject =
      0; ///< the octant that the finding is about: the first that was missed, ...
  std::optional<external_options> external{}; ///< how a test asks the traversal

  /// The octant's box.
  [[nodiscard]] cube octant() const { return answered.octant(subject); }
};

/// Asks the traversal and the oracles; `kind` is among the findings of `t`, as after shrink().
/// `options` are what traversal_entry::asked_for() says; empty: the name is enough.
reproduction reproduction_of(const trial& t, traversal& under_test, finding kind,
                             const std::string& options = {});

/// Lines of a ray or segment and its cells, names in a column of 11 characters after the indent.
std::string scene_lines(const trial& t, std::string_view indent);

std::string reproducer_name(const reproduction& r);
std::string reproducer_json(const reproduction& r);
std::string reproducer_text(const reproduction& r);
/// A header-like piece of C++17 in a namespace of its own; 128-bit integers are GCC's and Clang's.
std::string reproducer_snippet(const reproduction& r);
/// SVG 1.1, 600 px wide.
std::string reproducer_picture(const reproduction& r);

/// Makes the folder if it is not there; refused if nothing can be written to it.
support::status prepare_folder(const std::string& folder);

/// What was written: "FOLDER/NAME.json .txt .cpp .svg, FOLDER/NAME_test.cpp".
struct written_reproducer {
  std::string path;          ///< without an ending
  std::string test;          ///< the test's file; empty where there is none
  bool shows_octant = false; ///< there are a snippet and a picture
  [[nodiscard]] std::string spelled() const {
    return path + ".json .txt" + (shows_octant ? " .cpp .svg" : "") +
           (test.empty() ? std::string() : ", " + test);
  }
};

/// Writes the files, each whole or not at all, NAME.json last; refuses when a file cannot be written.
expected<written_reproducer> write_reproducer(const reproduction& r, const std::string& folder,
                                              language written = language::cpp);

/// Shrinks the trial, keeping `kind`, and writes its reproducer.
expected<written_reproducer> write_reproducer(const trial& found, traversal& under_test,
                                              finding kind, const std::string& options,
                                              const std::string& folder,
                                              const reader_of_test& reader = {});

} // namespace graze::fuzz
