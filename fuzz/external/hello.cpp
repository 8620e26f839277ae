/// The first line of a traversal in another process.
#include <cmath>
#include <cstdlib>
#include <external/line_protocol.hpp>
#include <external/words.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace graze::fuzz {

namespace {

using json = nlohmann::json;

constexpr std::array keys{"promise", "cells",     "segments", "batch",
                          "numbers", "tolerance", "echo",     "float"};
bool is_key(std::string_view name) {
  return std::find(keys.begin(), keys.end(), name) != keys.end();
}

/// The most requests a message: some 700 bytes each.
constexpr std::uint64_t most_requests = 1'000'000;

/// Takes members by their names; the first thing that is wrong stays.
class reader {
public:
  hello& greeting() { return hello_; }
  void wrong(std::string why) {
    if (hello_.wrong.empty())
      hello_.wrong = std::move(why);
  }
  void take(const std::string& name, const json& value) {
    if (name == "promise")
      take_name(hello_.promised, name, value, promise_of, promise_names());
    else if (name == "cells")
      take_name(hello_.cells, name, value, cell_kind_of, "cube, grid, boxes");
    else if (name == "numbers")
      take_name(hello_.numbers, name, value, numbers_of, "decimal, hex, bits");
    else if (name == "segments")
      hello_.segments = flag(name, value);
    else if (name == "echo")
      hello_.echo = flag(name, value);
    else if (name == "float")
      hello_.as_float = flag(name, value);
    else if (name == "batch")
      take_batch(value);
    else if (name == "tolerance")
      take_tolerance(value);
    else
      wrong(fmt::format("its first line has an unknown member \"{}\" (known are {})", name,
                        fmt::join(keys, ", ")));
  }

private:
  static std::string text_of(const json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
  }
  static std::optional<line_format> numbers_of(std::string_view name) {
    if (name == "decimal")
      return line_format::json;
    if (name == "hex")
      return line_format::plain;
    return name == "bits" ? std::optional(line_format::bits) : std::nullopt;
  }
  template <class T, class Find>
  void take_name(std::optional<T>& into, const std::string& name, const json& value, Find find,
                 std::string_view names) {
    const std::string text = text_of(value);
    into = find(text);
    if (!into)
      wrong(fmt::format("its {} \"{}\" is none of {}", name, text, names));
  }
  bool flag(const std::string& name, const json& value) {
    const std::string text = text_of(value);
    if (text != "true" && text != "false")
      wrong(fmt::format("its \"{}\" is neither true nor false", name));
    return text == "true";
  }
  /// A number, as it is or as a word.
  static double number(const json& value) {
    const std::string text = text_of(value);
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nan("") : x;
  }
  void take_batch(const json& value) {
    const double n = number(value);
    if (!(n >= 1 && n <= static_cast<double>(most_requests)) || n != std::floor(n))
      return wrong(
          fmt::format("its batch {} is not a number in 1..{}", text_of(value), most_requests));
    hello_.batch = static_cast<std::uint64_t>(n);
  }
  void take_tolerance(const json& value) {
    const double ulps = number(value);
    if (!(ulps >= 0) || std::isinf(ulps))
      return wrong(fmt::format("its tolerance {} is not a number of ulps", text_of(value)));
    hello_.tolerance = ulps;
  }

  hello hello_;
};

} // namespace

std::optional<hello> read_hello(std::string_view line) {
  reader read;
  if (const json parsed = json::parse(line, nullptr, false); parsed.is_object()) {
    bool any = false; // "echo" and numbers stand in answers too
    for (const auto& member : parsed.items())
      any = any || (is_key(member.key()) && member.key() != "echo");
    if (!any)
      return std::nullopt;
    for (const auto& member : parsed.items())
      read.take(member.key(), member.value());
    return read.greeting();
  }
  std::string name = next_word(line);
  if (!is_key(name))
    return std::nullopt;
  read.greeting().plain = true;
  for (; !name.empty(); name = next_word(line))
    read.take(name, next_word(line));
  return read.greeting();
}

std::string promise_names() {
  std::string names;
  for (int p = 0; p <= static_cast<int>(promise::count); ++p)
    names += fmt::format("{}{}", p == 0 ? "" : ", ", name_of(static_cast<promise>(p)));
  return names;
}

std::string_view name_of(cell_kind cells) {
  return cells == cell_kind::boxes ? "boxes" : (cells == cell_kind::grid ? "grid" : "cube");
}

std::optional<cell_kind> cell_kind_of(std::string_view name) {
  for (const cell_kind k : {cell_kind::cube, cell_kind::grid, cell_kind::boxes})
    if (name_of(k) == name)
      return k;
  return std::nullopt;
}

} // namespace graze::fuzz
