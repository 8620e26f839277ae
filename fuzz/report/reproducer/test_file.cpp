#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <graze/support/text.hpp>
#include <judge/answer_text.hpp>
#include <judge/first.hpp>
#include <limits>
#include <report/reproducer/passage.hpp>
#include <report/reproducer/test_file.hpp>
#include <report/reproducer/test_templates.hpp>
#include <sstream>
#include <utility>

namespace graze::fuzz {

namespace {

constexpr std::array<std::string_view, 6> names{"rust",       "go",     "java",
                                                "javascript", "python", "c++"};

/// A voxel by its place on each axis, a box by its place in the list.
using place = std::vector<std::uint64_t>;

place place_of(const trial& t, octant_number v) {
  if (t.boxes)
    return {v};
  return {t.base[0] + (v & 3u), t.base[1] + (v >> 2 & 3u), t.base[2] + (v >> 4)};
}

std::vector<place> places_of(const trial& t, octant_set set) {
  std::vector<place> places;
  for (octant_set left = set; left != 0; left &= left - 1)
    places.push_back(place_of(t, static_cast<octant_number>(std::countr_zero(left))));
  return places;
}

/// What a right answer holds; of a fault it is enough that there is one.
struct expectation {
  std::vector<place> must, one_of, none_of, in_order;
  bool once = false, inside = false;
  bool first = false, nothing = false; ///< the cell is one of these; none is right too
  std::string said;                    ///< "true", "false", a count, "odd", "even"
  std::vector<double> t, distance;     ///< of each of one_of: from, to
  std::vector<std::string> faces;      ///< of each: "-x -y"
};

/// Each answer of a first cell that judge() finds nothing in.
void expect_first(const reproduction& r, const truth& exact, expectation& e) {
  const trial& t = r.answered;
  const right_first right_ones = right_first_of(t, exact, r.promises, r.allowed);
  e.first = true;
  e.nothing = right_ones.none;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (octant_set left = right_ones.cells; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    e.one_of.push_back(place_of(t, v));
    // of a cell within rounding of the ray nothing is asked
    right_entry right{
        {-infinite, infinite}, {-infinite, infinite}, {"-x", "+x", "-y", "+y", "-z", "+z", "none"}};
    if ((exact.touched >> v & 1) != 0)
      right = entry_into(t, v, r.allowed.tolerance);
    if (r.kind == finding::distance) {
      e.t.insert(e.t.end(), right.t.begin(), right.t.end());
      e.distance.insert(e.distance.end(), right.distance.begin(), right.distance.end());
    } else if (r.kind == finding::face) {
      e.faces.push_back(fmt::format("{}", fmt::join(right.faces, " ")));
    }
  }
}

expectation expectation_of(const reproduction& r) {
  const trial& t = r.answered;
  const truth exact = truth_of(t);
  expectation e;
  switch (r.promises) {
  case promise::first:
  case promise::first_touched:
    if (is_fault(r.kind) || r.kind == finding::outside)
      e.inside = r.kind == finding::outside;
    else
      expect_first(r, exact, e);
    return e;
  case promise::any:
    if (!is_fault(r.kind))
      e.said = exact.touched != 0 ? "true" : "false";
    return e;
  case promise::count:
    if (const auto known = crossings_of(t); known && !is_fault(r.kind))
      e.said = known->number ? std::to_string(*known->number) : (known->odd ? "odd" : "even");
    return e;
  default:
    break;
  }
  switch (r.kind) {
  case finding::gross_miss:
  case finding::crossed_miss:
    e.must = places_of(t, crossed_missed(exact, r.answer));
    break;
  case finding::miss:
    e.must = places_of(t, misses(exact, r.answer, r.promises));
    break;
  case finding::gap:
  case finding::seam:
    for (unsigned i = 0; i < exact.length_count && e.one_of.empty(); ++i)
      if ((exact.lengths[i] & r.answer.set()) == 0 &&
          (std::popcount(exact.lengths[i]) > 1) == (r.kind == finding::seam))
        e.one_of = places_of(t, exact.lengths[i]);
    break;
  case finding::far_spurious:
    e.none_of = places_of(t, far_spurious(t, exact, r.answer, r.allowed));
    break;
  case finding::spurious:
    e.none_of = places_of(t, spurious(exact, r.answer, r.promises));
    break;
  case finding::order:
    for (unsigned i = 0; i < exact.owners; ++i)
      e.in_order.push_back(place_of(t, exact.owner_order[i]));
    break;
  case finding::revisit:
    e.once = true;
    break;
  case finding::outside:
    e.inside = true;
    break;
  default:
    break;
  }
  return e;
}

/// Members that an answer may have; the cells of a plain line have no name.
std::vector<std::string> known_members(promise p) {
  std::vector<std::string> all{"", "id", "received", "skip", "echo"};
  const auto add = [&all](std::initializer_list<const char*> more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  if (p == promise::first || p == promise::first_touched)
    add({"first", "visited", "t", "distance", "face"});
  else
    add({p == promise::any ? "hit" : (p == promise::count ? "count" : "visited")});
  return all;
}

/// How a language writes things down.
struct notation {
  std::string_view comment, bits_end, open, close;
};

const notation& notation_of(language l) {
  static constexpr std::array<notation, 6> all{{{"// ", "", "[", "]"},
                                                {"// ", "", "{", "}"},
                                                {"// ", "L", "{", "}"},
                                                {"// ", "n", "[", "]"},
                                                {"# ", "", "[", "]"},
                                                {"// ", "u", "{", "}"}}};
  return all[static_cast<unsigned>(l)];
}

std::string bits_of(double x, language l) {
  return fmt::format("0x{:016x}{}", std::bit_cast<std::uint64_t>(x), notation_of(l).bits_end);
}

std::string bits_of(const std::vector<double>& all, language l) {
  std::string text;
  for (const double x : all)
    text += (text.empty() ? "" : ", ") + bits_of(x, l);
  return text;
}

std::string numbers_of(const std::vector<std::uint64_t>& all, language l) {
  std::string text;
  for (const std::uint64_t x : all)
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", x, l == language::java ? "L" : "");
  return text;
}

std::string list_of(const std::vector<place>& places, language l) {
  const notation& n = notation_of(l);
  std::string text;
  for (const place& p : places) {
    text += text.empty() ? "" : ", ";
    text += n.open;
    text += numbers_of(p, l);
    text += n.close;
  }
  return text;
}

/// The inside of a string literal that the language reads as the text; C++ has trigraphs.
std::string literal(std::string_view text, language l) {
  std::string out;
  for (const char c : support::utf8(text))
    switch (c) {
    case '\\':
      out += "\\\\";
      break;
    case '"':
      out += "\\\"";
      break;
    case '?':
      out += l == language::cpp ? "\\?" : "?";
      break;
    case '\n':
      out += "\\n";
      break;
    case '\t':
      out += "\\t";
      break;
    default:
      out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  return out;
}

std::string quoted(const std::vector<std::string>& all, language l) {
  std::string text;
  for (const std::string& one : all)
    text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", literal(one, l));
  return text;
}

/// "PLANES_X" of "planes x", as the language spells names.
std::string spelled_name(std::string_view name, language l) {
  std::string text;
  bool next = false; // begins a word
  for (const char c : name) {
    const bool begins = std::exchange(next, c == ' ');
    if (c == ' ')
      text += l == language::go || l == language::javascript ? "" : "_";
    else if (l == language::cpp || ((l == language::go || l == language::javascript) && !begins))
      text += c;
    else
      text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

/// A constant that holds doubles by their bits.
std::string declared(std::string_view name, const std::vector<double>& all, language l) {
  const std::string spelled = spelled_name(name, l), bits = bits_of(all, l);
  switch (l) {
  case language::rust:
    return fmt::format("const {}: [u64; {}] = [{}];\n", spelled, all.size(), bits);
  case language::go:
    return fmt::format("\t{0} := doubles({1})\n\t_ = {0}\n", spelled, bits);
  case language::java:
    return fmt::format("  static final long[] {} = {{{}}};\n", spelled, bits);
  case language::javascript:
    return fmt::format("const {} = doubles({});\n", spelled, bits);
  case language::python:
    return fmt::format("{} = doubles({})\n", spelled, bits);
  default:
    return fmt::format("[[maybe_unused]] const bits_of_doubles {}{{{}}};\n", spelled, bits);
  }
}

/// The ray or segment, and what its cells are.
std::string scene_of(const trial& t, language l) {
  const auto of = [](const vec3& v) { return std::vector<double>(v.begin(), v.end()); };
  std::string text =
      declared("origin", of(t.origin), l) +
      (t.end ? declared("end", of(*t.end), l) : declared("direction", of(t.direction), l));
  if (t.boxes) {
    std::vector<double> all;
    for (const octree::box& b : *t.boxes) {
      all.insert(all.end(), b.lo.begin(), b.lo.end());
      all.insert(all.end(), b.hi.begin(), b.hi.end());
    }
    return text + declared("boxes", all, l);
  }
  if (t.grid && t.grid->rule == plane_rule::given)
    return text + declared("planes x", t.grid->given[0], l) +
           declared("planes y", t.grid->given[1], l) + declared("planes z", t.grid->given[2], l);
  if (t.grid)
    return text + declared("grid origin", of(t.grid->origin), l) +
           declared("spacing", of(t.grid->spacing), l);
  return text + declared("root lo", of(t.root.lo), l) + declared("root size", {t.root.size}, l);
}

std::string what_cells_are(const trial& t) {
  if (t.boxes)
    return "a box by its place in the list, each lo(3) hi(3)";
  if (t.grid)
    return fmt::format("a voxel by its place in the grid of {} x {} x {}, planes {}",
                       t.grid->count[0], t.grid->count[1], t.grid->count[2], name_of(t.grid->rule));
  return fmt::format("a voxel by its place in the grid, which has 2^{} an axis", t.level);
}

/// On one line of a comment, whatever it is.
std::string in_comment(std::string_view text) {
  std::string out = support::shown(text, 1000);
  std::replace(out.begin(), out.end(), '\\', ' '); // no escape, and no line that goes on
  return out;
}

std::string stem_of(const reproduction& r, char separator) {
  std::string stem = reproducer_name(r);
  std::replace(stem.begin(), stem.end(), '-', separator);
  return stem;
}

std::string replaced(std::string text, std::string_view name, std::string_view value) {
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += value.size())
    text.replace(at, name.size(), value);
  return text;
}

std::string how_to_run(const reproduction& r, language l) {
  const std::string file = test_file_name(r, l);
  switch (l) {
  case language::rust:
    return fmt::format("cargo test, from tests/; or rustc --edition 2021 --test {} -o t && ./t",
                       file);
  case language::go:
    return fmt::format("go test {}", file);
  case language::java:
    return fmt::format("java {}", file);
  case language::javascript:
    return fmt::format("node --test {}", file);
  case language::python:
    return fmt::format("python3 {}, or pytest", file);
  default:
    return fmt::format("c++ -std=c++17 {} -o t && ./t", file);
  }
}

std::string title_of(const reproduction& r, language l) {
  const trial& t = r.answered;
  std::vector<std::string> lines{
      fmt::format("{} by {}: {}.", name_of(r.kind), r.traversal, sentence_of(r.kind))};
  if (t.end || t.cells() != cell_kind::cube) {
    std::istringstream scene(scene_lines(t, ""));
    for (std::string line; std::getline(scene, line);)
      lines.push_back(line);
  } else {
    const cube box = r.octant();
    lines.push_back(
        fmt::format("Origin {}, direction {},", spelled(t.origin), spelled(t.direction)));
    lines.push_back(
        fmt::format("root {} size {}, level {}.", spelled(t.root.lo), hex(t.root.size), t.level));
    lines.push_back(fmt::format("Voxel {} size {}.", spelled(box.lo), hex(box.size)));
  }
  lines.push_back(fmt::format("Judged by rationals: graze-fuzz replay {}.json {}",
                              reproducer_name(r), r.options));
  lines.push_back(fmt::format("Run: {}", how_to_run(r, l)));
  std::string text;
  for (const std::string& line : lines)
    text += fmt::format("{}{}\n", notation_of(l).comment, in_comment(line));
  return text;
}

} // namespace

std::string_view name_of(language l) { return names[static_cast<unsigned>(l)]; }

std::optional<language> language_of(std::string_view name) {
  for (unsigned i = 0; i < names.size(); ++i)
    if (names[i] == name)
      return static_cast<language>(i);
  return std::nullopt;
}

language language_of_command(std::string_view command) {
  std::istringstream words{std::string(command)};
  for (std::string word; words >> word;) {
    std::erase_if(word, [](char c) { return c == '\'' || c == '"'; });
    const std::filesystem::path path(word);
    const std::string program = path.filename(), ending = path.extension();
    const auto is = [&program](std::initializer_list<std::string_view> programs) {
      return std::find(programs.begin(), programs.end(), program) != programs.end();
    };
    if (is({"cargo", "rustc"}) || ending == ".rs" ||
        word.find("target/release/") != std::string::npos ||
        word.find("target/debug/") != std::string::npos)
      return language::rust;
    if (program == "go" || ending == ".go")
      return language::go;
    if (is({"java", "mvn", "gradle", "jbang"}) || ending == ".java" || ending == ".jar")
      return language::java;
    if (is({"node", "npm", "npx", "bun", "deno"}) || ending == ".mjs" || ending == ".js" ||
        ending == ".cjs" || ending == ".ts")
      return language::javascript;
    if (program.starts_with("python") || program.starts_with("pypy") || ending == ".py")
      return language::python;
  }
  return language::cpp;
}

std::string test_file_name(const reproduction& r, language l) {
  switch (l) {
  case language::rust:
    return stem_of(r, '_') + ".rs";
  case language::go:
    return stem_of(r, '_') + "_test.go";
  case language::java:
    return "Graze_" + stem_of(r, '_') + ".java";
  case language::javascript:
    return stem_of(r, '-') + ".test.mjs";
  case language::python:
    return "test_" + stem_of(r, '_') + ".py";
  default:
    return stem_of(r, '-') + "_test.cpp";
  }
}

std::string test_file(const reproduction& r, language l) {
  const trial& t = r.answered;
  const expectation e = expectation_of(r);
  std::string request, command;
  double seconds = 10;
  if (r.external) {
    command = r.external->command;
    request = first_request(r.at, *r.external);
    seconds = std::max(2.0, 5 * r.external->seconds_a_ray);
  }
  const auto flag = [l](bool b) {
    return l == language::python ? (b ? "True" : "False") : (b ? "true" : "false");
  };
  place counts{t.boxes ? t.boxes->size() : 0};
  if (!t.boxes)
    counts = {t.count(0), t.count(1), t.count(2)};
  const std::pair<std::string_view, std::string> values[]{
      {"@TITLE@", title_of(r, l)},
      {"@NAME@", stem_of(r, '_')},
      {"@AXES@", std::to_string(counts.size())},
      {"@WHAT@", what_cells_are(t)},
      {"@SCENE@", scene_of(t, l)},
      {"@CELL@", list_of({place_of(t, r.subject)}, l)},
      {"@OCCUPIED@", list_of(places_of(t, t.all()), l)},
      {"@COUNTS@", numbers_of(counts, l)},
      {"@MUST@", list_of(e.must, l)},
      {"@ONE_OF@", list_of(e.one_of, l)},
      {"@NONE_OF@", list_of(e.none_of, l)},
      {"@IN_ORDER@", list_of(e.in_order, l)},
      {"@ONCE@", flag(e.once)},
      {"@INSIDE@", flag(e.inside)},
      {"@FIRST@", flag(e.first)},
      {"@NOTHING@", flag(e.nothing)},
      {"@T@", bits_of(e.t, l)},
      {"@DISTANCE@", bits_of(e.distance, l)},
      {"@FACES@", quoted(e.faces, l)},
      {"@BITS@", flag(r.external && r.external->format == line_format::bits)},
      {"@NEEDS_RECEIVED@", flag(r.external && r.external->needs_received)},
      {"@KNOWN@", quoted(known_members(r.promises), l)},
      {"@SECONDS@", fmt::format("{:.0f}", std::ceil(seconds))},
      {"@SAID@", e.said},
      {"@REQUEST@", literal(request, l)},
      {"@COMMAND@", literal(command, l)}};
  std::string text(test_template(l));
  for (const auto& [name, value] : values)
    text = replaced(std::move(text), name, value);
  return text;
}

} // namespace graze::fuzz
