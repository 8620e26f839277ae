#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <report/reproducer/reproducer.hpp>
#include <report/reproducer/test_file.hpp>
#include <shrink/shrink.hpp>

namespace graze::fuzz {

namespace {

/// FNV-1a: Fowler, Noll, Vo; draft-eastlake-fnv.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

octant_number lowest(octant_set set) { return static_cast<octant_number>(std::countr_zero(set)); }

/// The octant that the finding is about; the block's first where no octant alone is to blame.
octant_number subject_of(const trial& t, const truth& exact, const visited& answer, promise p,
                         finding kind, const allowance& allowed) {
  octant_set set = 0;
  switch (kind) {
  case finding::gross_miss:
    set = gross(t, crossed_missed(exact, answer));
    break;
  case finding::crossed_miss:
    set = crossed_missed(exact, answer);
    break;
  case finding::gap:
  case finding::seam:
    for (unsigned i = 0; i < exact.length_count && set == 0; ++i)
      if ((exact.lengths[i] & answer.set()) == 0 &&
          (std::popcount(exact.lengths[i]) > 1) == (kind == finding::seam))
        set = exact.lengths[i];
    break;
  case finding::miss:
    set = misses(exact, answer, p) & ~exact.crossed;
    break;
  case finding::far_spurious:
    set = far_spurious(t, exact, answer, allowed);
    break;
  case finding::distance:
  case finding::face:
    set = answer.set();
    break;
  case finding::spurious:
    set = spurious(exact, answer, p);
    break;
  case finding::order:
    // the first owner that was visited after one that lies behind it
    for (unsigned at = 0, i = 0; i < answer.size() && set == 0; ++i) {
      const auto* place =
          std::find(exact.owner_order.data(), exact.owner_order.data() + exact.owners, answer[i]);
      const auto index = static_cast<unsigned>(place - exact.owner_order.data());
      if (index == exact.owners)
        continue;
      if (index < at)
        set = octant_set{1} << answer[i];
      at = index;
    }
    break;
  default:
    break;
  }
  return lowest(set != 0 ? set : t.all());
}

} // namespace

reproduction reproduction_of(const trial& t, traversal& under_test, finding kind,
                             const std::string& options) {
  const std::string name(under_test.name());
  reproduction r{
      t, t, name, options.empty() ? "--traversal " + name : options, under_test.promises(), kind};
  r.allowed = allowance_of(under_test);
  ask(under_test, t, r.answer);
  if (const auto answered = trial_answered(t, r.answer))
    r.answered = *answered;
  r.judged = replay(t, under_test);
  r.subject = subject_of(r.answered, truth_of(r.answered), r.answer, r.promises, kind, r.allowed);
  return r;
}

std::string reproducer_name(const reproduction& r) {
  constexpr std::size_t longest = 60; // of a traversal, in the name of a file
  std::string name = fmt::format("{}-{}-{:08x}", r.traversal.substr(0, longest), name_of(r.kind),
                                 hash_of(to_json_line(r.at)) >> 32);
  for (char& c : name) // a traversal's name may be a command line
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'))
      c = '_';
  return name;
}

support::status prepare_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? support::failed("make the folder", folder, error.value())
               : support::check_writable((std::filesystem::path(folder) / "x.json").string());
}

expected<written_reproducer> write_reproducer(const reproduction& r, const std::string& folder,
                                              language written) {
  if (const support::status may = prepare_folder(folder); !may)
    return unexpected{may.reason()};
  const std::filesystem::path within(folder);
  written_reproducer done{(within / reproducer_name(r)).string(), {}};
  std::vector<std::pair<std::string, std::string>> files{{done.path + ".txt", reproducer_text(r)}};
  done.shows_octant = !r.at.end && r.at.cells() == cell_kind::cube;
  if (done.shows_octant) {
    files.emplace_back(done.path + ".cpp", reproducer_snippet(r));
    files.emplace_back(done.path + ".svg", reproducer_picture(r));
  }
  if (!r.at.map) {
    done.test = (within / test_file_name(r, written)).string();
    files.emplace_back(done.test, test_file(r, written));
  }
  files.emplace_back(done.path + ".json", reproducer_json(r));
  for (const auto& [path, text] : files)
    if (const support::status s = support::write_atomically(path, text); !s)
      return unexpected{s.reason()};
  return done;
}

expected<written_reproducer> write_reproducer(const trial& found, traversal& under_test,
                                              finding kind, const std::string& options,
                                              const std::string& folder,
                                              const reader_of_test& reader) {
  reproduction r = reproduction_of(shrink(found, under_test, kind), under_test, kind, options);
  r.external = reader.external;
  return write_reproducer(r, folder, reader.written);
}

} // namespace graze::fuzz
