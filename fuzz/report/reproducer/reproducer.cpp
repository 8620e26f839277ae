#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <report/reproducer/reproducer.hpp>
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

voxel lowest(voxel_set set) { return static_cast<voxel>(std::countr_zero(set)); }

/// The octant that the finding is about; the block's first where no octant alone is to blame.
voxel subject_of(const trial& t, const truth& is, const visited& said, promise p, finding kind) {
  voxel_set set = 0;
  switch (kind) {
  case finding::gross_miss:
    set = gross(t, crossed_missed(is, said));
    break;
  case finding::crossed_miss:
    set = crossed_missed(is, said);
    break;
  case finding::gap:
    for (unsigned i = 0; i < is.length_count && set == 0; ++i)
      if ((is.lengths[i] & said.set()) == 0)
        set = is.lengths[i];
    break;
  case finding::miss:
    set = misses(is, said, p) & ~is.crossed;
    break;
  case finding::far_spurious:
    set = far_spurious(t, is, said);
    break;
  case finding::spurious:
    set = spurious(is, said, p);
    break;
  case finding::order:
    // the first owner that was visited after one that lies behind it
    for (unsigned at = 0, i = 0; i < said.size() && set == 0; ++i) {
      const auto* place =
          std::find(is.owner_order.data(), is.owner_order.data() + is.owners, said[i]);
      const auto index = static_cast<unsigned>(place - is.owner_order.data());
      if (index == is.owners)
        continue;
      if (index < at)
        set = voxel_set{1} << said[i];
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
      t,  t,  name, options.empty() ? "--traversal " + name : options, under_test.promises(), kind,
      {}, {}, 0};
  ask(under_test, t, r.said);
  if (const auto answered = trial_answered(t, r.said))
    r.answered = *answered;
  r.judged = replay(t, under_test);
  r.subject = subject_of(r.answered, truth_of(r.answered), r.said, r.promises, kind);
  return r;
}

std::string reproducer_name(const reproduction& r) {
  std::string name =
      fmt::format("{}-{}-{:08x}", r.traversal, name_of(r.kind), hash_of(to_json_line(r.at)) >> 32);
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

expected<std::string> write_reproducer(const reproduction& r, const std::string& folder) {
  if (const support::status may = prepare_folder(folder); !may)
    return unexpected{may.reason()};
  const std::string path = (std::filesystem::path(folder) / reproducer_name(r)).string();
  const std::array<std::pair<const char*, std::string>, 4> files{{{".txt", reproducer_text(r)},
                                                                  {".cpp", reproducer_snippet(r)},
                                                                  {".svg", reproducer_picture(r)},
                                                                  {".json", reproducer_json(r)}}};
  for (const auto& [ending, text] : files)
    if (const support::status written = support::write_atomically(path + ending, text); !written)
      return unexpected{written.reason()};
  return path;
}

expected<std::string> write_reproducer(const trial& found, traversal& under_test, finding kind,
                                       const std::string& options, const std::string& folder) {
  return write_reproducer(
      reproduction_of(shrink(found, under_test, kind), under_test, kind, options), folder);
}

} // namespace graze::fuzz
