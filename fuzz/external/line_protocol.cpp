#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <external/line_protocol.hpp>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::json;

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

void append_decimals(std::string& text, const vec3& v) {
  char before = '[';
  for (const double x : v) {
    text += before;
    append_decimal(text, x);
    before = ',';
  }
  text += ']';
}

/// A number of `received`: a JSON number, or a string that strtod reads (hex, inf, nan).
/// JSON.stringify writes null for what is not finite.
std::optional<double> number_of(const json& value) {
  if (value.is_number())
    return value.get<double>();
  if (value.is_null())
    return std::nan("");
  if (!value.is_string())
    return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size())
    return std::nullopt;
  return x;
}

/// Collects one answer; the first thing that is wrong with it stays.
class answer {
public:
  answer(const trial& t, visited& out) : t_(t), out_(out) {}

  void wrong(fault f = fault::malformed) {
    if (out_.failed() == fault::none)
      out_.fail(f);
  }
  /// A voxel by its place among all those of the level, in doubles that hold it exactly.
  void voxel_index(const std::array<double, 3>& index) {
    const double count = std::ldexp(1.0, t_.level);
    std::array<unsigned, 3> place{};
    bool of_block = true;
    for (unsigned a = 0; a < 3; ++a) {
      const double i = index[a];
      if (std::isnan(i))
        return wrong(fault::not_a_number);
      if (i != std::floor(i))
        return wrong();
      if (!(0 <= i && i < count))
        return out_.push_outside();
      const auto whole = static_cast<std::uint64_t>(i);
      of_block = of_block && t_.base[a] <= whole && whole - t_.base[a] < t_.extent[a];
      if (of_block)
        place[a] = static_cast<unsigned>(whole - t_.base[a]);
    }
    if (of_block) // voxels around the block are empty: nobody asked about them
      out_.push(octant_at(place[0], place[1], place[2]));
  }
  void received(const received_ray& r) {
    for (unsigned a = 0; a < 3; ++a)
      if (std::isnan(r.origin[a]) || std::isnan(r.direction[a]))
        return wrong(fault::not_a_number);
    out_.receive(r);
  }
  void decline() { out_.decline(); }

private:
  const trial& t_;
  visited& out_;
};

bool read_vector(const json& object, const char* key, vec3& v) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != 3)
    return false;
  for (unsigned a = 0; a < 3; ++a) {
    const auto x = number_of((*found)[a]);
    if (!x)
      return false;
    v[a] = *x;
  }
  return true;
}

void read_voxels(const json& list, answer& into) {
  if (!list.is_array())
    return into.wrong();
  for (const json& octant : list) {
    if (!octant.is_array() || octant.size() != 3)
      return into.wrong();
    std::array<double, 3> index{};
    for (unsigned a = 0; a < 3; ++a) {
      if (!octant[a].is_number() && !octant[a].is_null())
        return into.wrong();
      index[a] = octant[a].is_null() ? std::nan("") : octant[a].get<double>();
    }
    into.voxel_index(index);
  }
}

void read_json(const json& line, std::uint64_t id, answer& into) {
  if (line.is_array())
    return read_voxels(line, into);
  if (!line.is_object())
    return into.wrong();
  if (const auto named = line.find("id"); named != line.end() && *named != id)
    return into.wrong();
  if (const auto skip = line.find("skip"); skip != line.end() && *skip == true)
    return into.decline();
  const auto list = line.find("visited");
  if (list == line.end())
    return into.wrong();
  read_voxels(*list, into);
  if (const auto ray = line.find("received"); ray != line.end()) {
    received_ray r{};
    if (!ray->is_object() || !read_vector(*ray, "origin", r.origin) ||
        !read_vector(*ray, "direction", r.direction))
      return into.wrong();
    into.received(r);
  }
}

/// The next word of a line, which is taken off it; empty at its end.
std::string next_word(std::string_view& line) {
  const std::size_t from = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t to = std::min(line.find_first_of(" \t", from), line.size());
  const std::string word(line.substr(from, to - from));
  line.remove_prefix(to);
  return word;
}

void read_plain(std::string_view line, answer& into) {
  std::string word = next_word(line);
  if (word == "skip" && next_word(line).empty())
    return into.decline();
  const auto number = [&](double& x) {
    char* end = nullptr;
    x = std::strtod(word.c_str(), &end);
    const bool all = !word.empty() && *end == '\0';
    word = next_word(line);
    return all;
  };
  while (!word.empty() && word != "received") {
    std::array<double, 3> index{};
    for (double& i : index)
      if (!number(i))
        return into.wrong();
    into.voxel_index(index);
  }
  if (word.empty())
    return;
  word = next_word(line);
  received_ray r{};
  for (vec3* v : {&r.origin, &r.direction})
    for (double& x : *v)
      if (!number(x))
        return into.wrong();
  if (!word.empty())
    return into.wrong();
  into.received(r);
}

bool holds_nan(std::string_view line) {
  static constexpr std::string_view nan = "nan";
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::search(line.begin(), line.end(), nan.begin(), nan.end(),
                     [&](char a, char b) { return lower(a) == b; }) != line.end();
}

} // namespace

void append_request(std::string& text, const trial& t, std::uint64_t id, line_format format) {
  const auto into = std::back_inserter(text);
  if (format == line_format::plain) {
    fmt::format_to(into, "{} {} {} {} {} {} {} {}", id, t.level, t.base[0], t.base[1], t.base[2],
                   t.extent[0], t.extent[1], t.extent[2]);
    for (const vec3* v : {&t.origin, &t.direction, &t.root.lo})
      for (const double x : *v)
        fmt::format_to(into, " {}", hex(x));
    fmt::format_to(into, " {}\n", hex(t.root.size));
    return;
  }
  fmt::format_to(into, R"({{"id":{},"origin":)", id);
  append_decimals(text, t.origin);
  text += R"(,"direction":)";
  append_decimals(text, t.direction);
  text += R"(,"root":{"lo":)";
  append_decimals(text, t.root.lo);
  text += R"(,"size":)";
  append_decimal(text, t.root.size);
  fmt::format_to(into, R"(}},"level":{},"voxel_size":)", t.level);
  append_decimal(text, t.size());
  fmt::format_to(into, R"(,"base":[{},{},{}],"extent":[{},{},{}],"hex":{{"origin":)", t.base[0],
                 t.base[1], t.base[2], t.extent[0], t.extent[1], t.extent[2]);
  const auto append_hex = [&](const vec3& v) {
    fmt::format_to(into, R"(["{}","{}","{}"])", hex(v[0]), hex(v[1]), hex(v[2]));
  };
  append_hex(t.origin);
  text += R"(,"direction":)";
  append_hex(t.direction);
  text += "}}\n";
}

void read_answer(std::string_view line, const trial& t, std::uint64_t id, visited& out) {
  answer into(t, out);
  const std::size_t start = line.find_first_not_of(" \t");
  if (start != std::string_view::npos && (line[start] == '[' || line[start] == '{')) {
    if (const json parsed = json::parse(line, nullptr, false); !parsed.is_discarded())
      read_json(parsed, id, into);
    else
      into.wrong(holds_nan(line) ? fault::not_a_number : fault::malformed); // JSON has no NaN
    return;
  }
  read_plain(line, into);
}

std::optional<hello> read_hello(std::string_view line) {
  std::string name;
  if (const json parsed = json::parse(line, nullptr, false); parsed.is_object()) {
    const auto found = parsed.find("promise");
    if (found == parsed.end())
      return std::nullopt;
    name = found->is_string() ? found->get<std::string>() : found->dump();
  } else if (next_word(line) == "promise") {
    name = next_word(line);
  } else {
    return std::nullopt;
  }
  hello greeting{promise_of(name), {}};
  if (!greeting.promised)
    greeting.wrong = name;
  return greeting;
}

} // namespace graze::fuzz
