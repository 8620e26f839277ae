/// Requests: what a traversal in another process is asked.
#include <charconv>
#include <external/line_protocol.hpp>
#include <external/maps.hpp>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

/// The shortest decimal that reads back as x, always with a point or an exponent: some readers take
/// "-0" for an integer and lose its sign.
void append_decimal(std::string& text, double x) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, x).ptr;
  const std::string_view spelled(digits, static_cast<std::size_t>(end - digits));
  text += spelled;
  if (spelled.find_first_of(".e") == std::string_view::npos)
    text += ".0";
}

/// Writes the doubles of a request in JSON, once as decimals and once as bits.
class json_writer {
public:
  json_writer(std::string& text, bool bits) : text_(text), bits_(bits) {}

  void raw(std::string_view text) { text_ += text; }
  /// `,"key":`, without the comma after an opening brace.
  void key(std::string_view name) {
    if (text_.back() != '{')
      text_ += ',';
    text_ += '"';
    text_ += name;
    text_ += "\":";
  }
  void number(double x) {
    if (!bits_)
      return append_decimal(text_, x);
    text_ += '"';
    text_ += bits_of(x);
    text_ += '"';
  }
  void numbers(std::span<const double> all) {
    text_ += '[';
    for (const double x : all) {
      if (text_.back() != '[')
        text_ += ',';
      number(x);
    }
    text_ += ']';
  }
  void vector(std::string_view name, const vec3& v) { key(name), numbers(v); }
  /// Integers are no doubles: they are not said again.
  template <class Integers> void integers(std::string_view name, const Integers& v) {
    if (!bits_)
      key(name), text_ += fmt::format("[{},{},{}]", v[0], v[1], v[2]);
  }
  void word(std::string_view name, std::string_view value) {
    if (!bits_)
      key(name), text_ += fmt::format("\"{}\"", value);
  }

private:
  std::string& text_;
  bool bits_;
};

void append_grid(json_writer& to, const grid_planes& grid) {
  to.key("grid");
  to.raw("{");
  if (grid.rule == octree::plane_rule::given) {
    to.key("planes");
    to.raw("[");
    for (unsigned a = 0; a < 3; ++a) {
      to.raw(a == 0 ? "" : ",");
      to.numbers(grid.given[a]);
    }
    to.raw("]");
  } else {
    to.vector("origin", grid.origin);
    to.vector("spacing", grid.spacing);
    to.integers("count", grid.count);
    to.word("planes", name_of(grid.rule));
  }
  to.raw("}");
}

/// The members that hold doubles, and, among the decimals, what stands between them.
void append_members(json_writer& to, const trial& t, bool bits, opening first) {
  to.vector("origin", t.origin);
  to.vector(t.end ? "end" : "direction", t.end ? *t.end : t.direction);
  switch (t.cells()) {
  case cell_kind::boxes:
    to.key("boxes");
    for (std::size_t i = 0; i < t.boxes->size(); ++i) {
      to.raw(i == 0 ? "[{" : ",{");
      to.vector("lo", (*t.boxes)[i].lo);
      to.vector("hi", (*t.boxes)[i].hi);
      to.raw("}");
    }
    to.raw("]");
    break;
  case cell_kind::grid:
    if (t.map && !bits) {
      to.key("scene"), to.raw(nlohmann::json(whole_path(t.map->file())).dump());
      if (first.grid)
        to.integers("first", t.map->first);
    }
    if (!t.map || first.grid)
      append_grid(to, *t.grid);
    break;
  case cell_kind::cube:
    to.key("root");
    to.raw("{");
    to.vector("lo", t.root.lo);
    to.key("size");
    to.number(t.root.size);
    to.raw("}");
    if (!bits)
      to.key("level"), to.raw(std::to_string(t.level));
    to.key("voxel_size");
    to.number(t.size());
    break;
  }
  if (t.cells() != cell_kind::boxes) {
    to.integers("base", t.base);
    to.integers("extent", t.extent);
  }
  if (first.echo)
    to.key("echo"), to.numbers(hard_numbers());
}

void append_json(std::string& text, const trial& t, std::uint64_t id, opening first) {
  text += fmt::format(R"({{"id":{})", id);
  json_writer decimals(text, false), bits(text, true);
  append_members(decimals, t, false, first);
  decimals.key("bits");
  decimals.raw("{");
  append_members(bits, t, true, first);
  decimals.raw("}}");
}

void append_plain(std::string& text, const trial& t, std::uint64_t id, bool bits, opening first) {
  const auto into = std::back_inserter(text);
  const auto numbers = [&](std::span<const double> all) {
    for (const double x : all) {
      text += ' ';
      text += bits ? bits_of(x) : hex(x);
    }
  };
  const auto block = [&] {
    fmt::format_to(into, " {} {} {} {} {} {}", t.base[0], t.base[1], t.base[2], t.extent[0],
                   t.extent[1], t.extent[2]);
  };
  const auto ray = [&] {
    numbers(t.origin);
    numbers(t.end ? *t.end : t.direction);
  };
  const auto planes = [&] {
    if (t.grid->rule == octree::plane_rule::given) {
      for (const auto& of_axis : t.grid->given)
        fmt::format_to(into, " {}", of_axis.size());
      for (const auto& of_axis : t.grid->given)
        numbers(of_axis);
    } else {
      numbers(t.grid->origin);
      numbers(t.grid->spacing);
      fmt::format_to(into, " {} {} {}", t.grid->count[0], t.grid->count[1], t.grid->count[2]);
    }
  };
  if (t.map && first.grid) {
    const auto& from = t.map->first;
    fmt::format_to(into, "scene {} {} {} {}\ngrid {}", from[0], from[1], from[2],
                   whole_path(t.map->file()), name_of(t.grid->rule));
    planes();
    text += '\n';
  }
  text += std::to_string(id);
  switch (t.cells()) {
  case cell_kind::boxes:
    text += " boxes";
    ray();
    fmt::format_to(into, " {}", t.boxes->size());
    for (const octree::box& b : *t.boxes)
      numbers(b.lo), numbers(b.hi);
    break;
  case cell_kind::grid:
    if (t.map) {
      text += " scene";
      block();
      ray();
      break;
    }
    fmt::format_to(into, " grid {}", name_of(t.grid->rule));
    block();
    ray();
    planes();
    break;
  case cell_kind::cube:
    fmt::format_to(into, " {}", t.level);
    block();
    ray();
    numbers(t.root.lo);
    numbers({&t.root.size, 1});
    break;
  }
  if (first.echo)
    text += " echo", numbers(hard_numbers());
  text += '\n';
}

} // namespace

// Read as digits times a power of ten, both doubles (serde_json does so unless told otherwise), 1.99...8,
// the greatest, and the last seven are an ulp off or infinite; so are they where digits are added up in
// doubles, or where but 15 of them are kept. The others are for float, for subnormal numbers that are
// flushed, for integers of 64 bits.
const echo_numbers& hard_numbers() {
  static constexpr echo_numbers numbers{-0.0,
                                        0.1,
                                        1.9999999999999998,
                                        5e-324,
                                        2.2250738585072014e-308,
                                        1.7976931348623157e308,
                                        1e23,
                                        9007199254740994.0,
                                        1.0 / 3,
                                        -0.9836237133425473,
                                        0.00010678500163828601,
                                        -0.00036151356901086603,
                                        101.21016800070727,
                                        1.0671009529491235e-297,
                                        -7.164384684239564e289,
                                        11354724370.048637};
  return numbers;
}

void append_request(std::string& text, const trial& t, std::uint64_t id, line_format format,
                    opening first) {
  if (format != line_format::json)
    return append_plain(text, t, id, format == line_format::bits, first);
  append_json(text, t, id, first);
  text += '\n';
}

void append_batch(std::string& text, std::span<const trial> trials,
                  std::span<const std::size_t> places, std::uint64_t first_id, line_format format,
                  opening first) {
  const bool in_json = format == line_format::json;
  text += in_json ? R"({"batch":[)" : fmt::format("batch {}\n", places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const opening told = i == 0 ? first : opening{};
    if (!in_json) {
      append_request(text, trials[places[i]], first_id + i, format, told);
      continue;
    }
    if (i != 0)
      text += ',';
    append_json(text, trials[places[i]], first_id + i, told);
  }
  if (in_json)
    text += "]}\n";
}

} // namespace graze::fuzz
