#include <algorithm>
#include <array>
#include <external/line_protocol.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <report/reproducer/passage.hpp>
#include <report/reproducer/test_file.hpp>
#include <report/reproducer/test_templates.hpp>
#include <sstream>

namespace graze::fuzz {

namespace {

constexpr std::array<std::string_view, 6> names{"rust",       "go",     "java",
                                                "javascript", "python", "c++"};

using place = std::array<std::uint64_t, 3>;

place place_of(const trial& t, octant_number v) {
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
};

expectation expectation_of(const reproduction& r) {
  const trial& t = r.answered;
  const truth exact = truth_of(t);
  expectation e;
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
    e.none_of = places_of(t, far_spurious(t, exact, r.answer));
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

std::string bits_of(const vec3& v, language l) {
  return fmt::format("{}, {}, {}", bits_of(v[0], l), bits_of(v[1], l), bits_of(v[2], l));
}

std::string list_of(const std::vector<place>& places, language l) {
  const notation& n = notation_of(l);
  std::string text;
  for (const place& p : places) {
    text += text.empty() ? "" : ", ";
    text += n.open;
    for (unsigned a = 0; a < 3; ++a)
      text += fmt::format("{}{}{}", a == 0 ? "" : ", ", p[a], l == language::java ? "L" : "");
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
    return fmt::format("cargo test, from tests/; or rustc --test {} -o t && ./t", file);
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
  const cube box = r.octant();
  const std::string lines[] = {
      fmt::format("{} by {}: {}.", name_of(r.kind), r.traversal, sentence_of(r.kind)),
      fmt::format("Origin {}, direction {},", spelled(t.origin), spelled(t.direction)),
      fmt::format("root {} size {}, level {}.", spelled(t.root.lo), hex(t.root.size), t.level),
      fmt::format("Voxel {} size {}.", spelled(box.lo), hex(box.size)),
      fmt::format("Judged by rationals: graze-fuzz replay {}.json {}", reproducer_name(r),
                  r.options),
      fmt::format("Run: {}", how_to_run(r, l))};
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
    append_request(request, t, 0, r.external->format);
    seconds = std::max(2.0, 5 * r.external->seconds_a_ray);
  }
  const auto flag = [l](bool b) {
    return l == language::python ? (b ? "True" : "False") : (b ? "true" : "false");
  };
  const std::array<std::pair<std::string_view, std::string>, 20> values{
      {{"@TITLE@", title_of(r, l)},
       {"@NAME@", stem_of(r, '_')},
       {"@ORIGIN@", bits_of(t.origin, l)},
       {"@DIRECTION@", bits_of(t.direction, l)},
       {"@LO@", bits_of(t.root.lo, l)},
       {"@SIZE@", bits_of(t.root.size, l)},
       {"@LEVEL@", fmt::format("{}", t.level)},
       {"@COUNT@",
        fmt::format("{}{}", std::uint64_t{1} << t.level, l == language::java ? "L" : "")},
       {"@CELL@", list_of({place_of(t, r.subject)}, l)},
       {"@BLOCK@", list_of(places_of(t, t.all()), l)},
       {"@MUST@", list_of(e.must, l)},
       {"@ONE_OF@", list_of(e.one_of, l)},
       {"@NONE_OF@", list_of(e.none_of, l)},
       {"@IN_ORDER@", list_of(e.in_order, l)},
       {"@ONCE@", flag(e.once)},
       {"@INSIDE@", flag(e.inside)},
       {"@SECONDS@", fmt::format("{:.0f}", std::ceil(seconds))},
       // words that stand in a first line, and in no answer
       {"@FIRST@", "promise|cells|segments|batch|numbers|tolerance|float|echo true"},
       {"@REQUEST@", literal(request, l)},
       {"@COMMAND@", literal(command, l)}}};
  std::string text(test_template(l));
  for (const auto& [name, value] : values)
    text = replaced(std::move(text), name, value);
  return text;
}

} // namespace graze::fuzz
