/// Answers: what a traversal in another process says.
#include <cmath>
#include <cstdlib>
#include <external/line_protocol.hpp>
#include <external/words.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::json;

bool is_first(promise p) { return p == promise::first || p == promise::first_touched; }
bool is_list(promise p) { return !is_first(p) && p != promise::any && p != promise::count; }

/// A number in a string: what strtod reads (hex, inf, nan), or 16 hex digits.
std::optional<double> number_of(const std::string& text) {
  if (const auto x = number_of_bits(text))
    return x;
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size())
    return std::nullopt;
  return x;
}

/// A number or such a string. JSON.stringify writes null for what is not finite.
std::optional<double> number_of(const json& value) {
  if (value.is_number())
    return value.get<double>();
  if (value.is_null())
    return std::nan("");
  return value.is_string() ? number_of(value.get_ref<const std::string&>()) : std::nullopt;
}

std::optional<face> face_of(std::string_view name) {
  if (name.size() != 2 || (name[0] != '-' && name[0] != '+') || name[1] < 'x' || name[1] > 'z')
    return std::nullopt;
  return face{static_cast<std::uint8_t>(name[1] - 'x'), name[0] == '+'};
}

/// Text of a peer in a line of ASCII.
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 60))
    result += c < ' ' || c > '~' ? '?' : c;
  return result + "\"";
}

/// Collects one answer; the first thing that is wrong with it stays.
class answer {
public:
  answer(const trial& t, const answer_form& form, visited& out) : t_(t), form_(form), out_(out) {}

  [[nodiscard]] promise promised() const { return form_.promised; }
  [[nodiscard]] bool bits() const { return form_.bits; }
  [[nodiscard]] bool of_boxes() const { return t_.cells() == cell_kind::boxes; }
  [[nodiscard]] bool of_segment() const { return t_.end.has_value(); }

  void wrong(std::string why) {
    if (out_.failed() == fault::none)
      out_.fail_by_form(std::move(why));
  }
  void not_a_number() {
    if (out_.failed() == fault::none)
      out_.fail(fault::not_a_number);
  }
  /// A voxel by its place among all those of the level or grid, or a box by its place in the list (in
  /// index[0]), in doubles that hold it exactly.
  void cell(const std::array<double, 3>& index) {
    const unsigned axes = of_boxes() ? 1 : 3;
    std::array<unsigned, 3> place{};
    bool of_block = true;
    for (unsigned a = 0; a < axes; ++a) {
      const double i = index[a];
      if (std::isnan(i))
        return not_a_number();
      if (i != std::floor(i))
        return wrong(fmt::format("the index {} is no integer", i));
      if (!(0 <= i && i < count(a)))
        return out_.push_outside();
      if (of_boxes())
        return push(static_cast<octant_number>(i));
      const auto whole = static_cast<std::uint64_t>(i);
      of_block = of_block && t_.base[a] <= whole && whole - t_.base[a] < t_.extent[a];
      if (of_block)
        place[a] = static_cast<unsigned>(whole - t_.base[a]);
    }
    if (of_block && (!t_.map || has(t_.all(), octant_at(place[0], place[1], place[2]))))
      return push(octant_at(place[0], place[1], place[2]));
    // voxels around the block are empty, or it was not them that was asked about
    if (t_.map && is_first(form_.promised) && out_.size() == 0)
      push_elsewhere(index);
  }
  void received(received_ray r) {
    const vec3& second = of_segment() ? *r.end : r.direction;
    for (unsigned a = 0; a < 3; ++a)
      if (std::isnan(r.origin[a]) || std::isnan(second[a]))
        return not_a_number();
    if (of_segment())
      for (unsigned a = 0; a < 3; ++a)
        r.direction[a] = second[a] - r.origin[a];
    if (out_.received()) // rounded to float before it was sent
      r.boxes = out_.received()->boxes;
    out_.receive(r);
    is_received_ = true;
  }
  /// Entry into the first cell. What is said of no cell says nothing.
  void entry(std::optional<double>& into, double x) {
    if (!says_cell())
      return;
    if (std::isnan(x))
      return not_a_number();
    into = x; // infinite, where the true one is beyond all doubles
  }
  void t(double x) { entry(out_.said().t, x); }
  void distance(double x) { entry(out_.said().distance, x); }
  /// A face's name, or an empty one where none is entered.
  void entered(const std::string& name) {
    if (!says_cell())
      return;
    out_.said().no_face = name.empty();
    if (!name.empty())
      out_.said().entered = face_of(name);
    if (!name.empty() && !out_.said().entered)
      wrong(fmt::format("the face {} is none of -x, +x, -y, +y, -z, +z", in_quotes(name)));
  }
  void hit(bool h) { out_.said().hit = h; }
  void crossings(double n) {
    if (std::isnan(n))
      return not_a_number();
    if (!(0 <= n && n <= 1e9) || n != std::floor(n))
      return wrong("the count is no number of crossings");
    out_.said().crossings = static_cast<std::uint64_t>(n);
  }
  void decline() {
    out_.decline();
    is_received_ = true;
  }
  /// Nothing more is said.
  void end() {
    if (form_.needs_received && !is_received_)
      wrong("there is no \"received\", which --received asks for");
  }

private:
  static bool has(octant_set set, octant_number v) { return (set >> v & 1) != 0; }
  void push_elsewhere(const std::array<double, 3>& index) {
    const voxel_index v{static_cast<std::uint32_t>(index[0]), static_cast<std::uint32_t>(index[1]),
                        static_cast<std::uint32_t>(index[2])};
    if (!out_.elsewhere())
      t_.map->occupied(v) ? out_.push_elsewhere(v) : out_.push_outside();
  }
  [[nodiscard]] bool says_cell() const { return out_.size() != 0 || out_.elsewhere(); }
  [[nodiscard]] double count(unsigned axis) const {
    switch (t_.cells()) {
    case cell_kind::boxes:
      return static_cast<double>(t_.boxes->size());
    case cell_kind::grid:
      return t_.grid->count[axis];
    default:
      return std::ldexp(1.0, t_.level);
    }
  }
  void push(octant_number v) {
    if (!is_first(form_.promised) || !says_cell())
      out_.push(v);
  }

  const trial& t_;
  const answer_form& form_;
  visited& out_;
  bool is_received_ = false;
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

/// [x,y,z], or a box's place.
void read_cell(const json& cell, answer& into) {
  std::array<double, 3> index{};
  const auto one = [&](const json& value, double& i) {
    const bool good = value.is_number() || value.is_null();
    i = value.is_number() ? value.get<double>() : std::nan("");
    return good;
  };
  bool good = true;
  if (into.of_boxes())
    good = one(cell, index[0]);
  else if ((good = cell.is_array() && cell.size() == 3))
    for (unsigned a = 0; a < 3; ++a)
      good = one(cell[a], index[a]) && good;
  if (!good)
    return into.wrong(into.of_boxes() ? "a box is not told by its place in the list, a number"
                                      : "a voxel is not told by three numbers");
  into.cell(index);
}

void read_cells(const json& list, answer& into) {
  if (!list.is_array())
    return into.wrong("what was visited is no array");
  for (const json& cell : list)
    read_cell(cell, into);
}

void read_received(const json& ray, answer& into) {
  received_ray r{};
  const char* second = into.of_segment() ? "end" : "direction";
  vec3 other{};
  if (!ray.is_object() || ray.size() != 2 || !read_vector(ray, "origin", r.origin) ||
      !read_vector(ray, second, other))
    return into.wrong(
        fmt::format("\"received\" is not {{\"origin\":[3],\"{}\":[3]}} and no more", second));
  (into.of_segment() ? r.end.emplace() : r.direction) = other;
  into.received(r);
}

void read_echo(const json& list, std::string_view line, answer& into, echoed* echo) {
  if (echo == nullptr)
    return;
  if (!list.is_array() || list.size() != echo->numbers.size())
    return into.wrong(fmt::format("\"echo\" is not {} numbers", echo->numbers.size()));
  for (std::size_t i = 0; i < echo->numbers.size(); ++i) {
    const auto x = number_of(list[i]);
    if (!x)
      return into.wrong("\"echo\" holds what is no number");
    echo->numbers[i] = *x;
  }
  echo->given = true;
  echo->sign_of_zero = std::signbit(echo->numbers[0]);
  // "-0", as some write it, is an integer to the parser: without a sign
  if (const auto name = line.find("\"echo\""); name != std::string_view::npos)
    if (const auto open = line.find('[', name); open != std::string_view::npos)
      if (const auto first = line.find_first_not_of(" \t", open + 1);
          first != std::string_view::npos && line.substr(first, 2) == "-0")
        echo->sign_of_zero = true;
}

void read_entered(const json& value, answer& into) {
  if (value.is_null())
    return into.entered({});
  if (!value.is_string())
    return into.wrong("\"face\" is neither a string nor null");
  into.entered(value.get_ref<const std::string&>());
}

/// Members that any answer may have.
bool is_general(std::string_view key) {
  return key == "id" || key == "received" || key == "skip" || key == "echo";
}

/// Members of an answer by its promise, in the order in which they are read.
std::span<const char* const> members_of(promise p) {
  static constexpr const char* list[] = {"visited"};
  static constexpr const char* first[] = {"first", "visited", "t", "distance", "face"};
  static constexpr const char* any[] = {"hit"};
  static constexpr const char* count[] = {"count"};
  if (is_first(p))
    return first;
  if (p == promise::any)
    return any;
  return p == promise::count ? std::span<const char* const>(count) : list;
}

void read_member(const char* key, const json& value, answer& into) {
  const std::string_view name = key;
  const auto number = [&](auto take) {
    const auto x = number_of(value);
    if (!x)
      return into.wrong(fmt::format("\"{}\" is no number", name));
    (into.*take)(*x);
  };
  if (name == "visited")
    return read_cells(value, into);
  if (name == "first")
    return value.is_null() ? void() : read_cell(value, into);
  if (name == "t")
    return number(&answer::t);
  if (name == "distance")
    return number(&answer::distance);
  if (name == "face")
    return read_entered(value, into);
  if (name == "count")
    return number(&answer::crossings);
  if (!value.is_boolean())
    return into.wrong("\"hit\" is neither true nor false");
  into.hit(value.get<bool>());
}

void read_object(const json& object, std::string_view line, std::uint64_t id, answer& into,
                 echoed* echo) {
  const auto members = members_of(into.promised());
  for (const auto& member : object.items())
    if (!is_general(member.key()) &&
        std::find(members.begin(), members.end(), std::string_view(member.key())) == members.end())
      return into.wrong(fmt::format("the member {} is unknown in an answer of the promise \"{}\"",
                                    in_quotes(member.key()), name_of(into.promised())));
  if (const auto number = object.find("id"); number != object.end() && *number != id)
    return into.wrong(fmt::format("its id is not {}", id));
  if (const auto list = object.find("echo"); list != object.end() && !list->is_null())
    read_echo(*list, line, into, echo);
  if (const auto skip = object.find("skip"); skip != object.end()) {
    if (*skip == true)
      return into.decline();
    if (*skip != false)
      return into.wrong("\"skip\" is neither true nor false");
  }
  bool said = false;
  for (const char* key : members)
    if (const auto found = object.find(key); found != object.end()) {
      read_member(key, *found, into);
      said = said || found == object.find(members[0]) || std::string_view(key) == "visited";
    }
  if (!said)
    return into.wrong(fmt::format("there is no \"{}\", which the promise \"{}\" needs", members[0],
                                  name_of(into.promised())));
  if (const auto ray = object.find("received"); ray != object.end() && !ray->is_null())
    read_received(*ray, into);
  into.end();
}

void read_json(const json& answered, std::string_view line, std::uint64_t id, answer& into,
               echoed* echo) {
  if (answered.is_object())
    return read_object(answered, line, id, into, echo);
  const promise p = into.promised();
  if (answered.is_array() && (is_list(p) || is_first(p)))
    read_cells(answered, into);
  else if (answered.is_boolean() && p == promise::any)
    into.hit(answered.get<bool>());
  else if (answered.is_number() && p == promise::count)
    into.crossings(answered.get<double>());
  else
    return into.wrong(fmt::format("this is no answer of the promise \"{}\"", name_of(p)));
  into.end();
}

/// Reads the words of a plain line.
class plain_reader {
public:
  plain_reader(std::string_view line, std::uint64_t id, answer& into, echoed* echo)
      : rest_(line), word_(next_word(rest_)), id_(id), into_(into), echo_(echo) {}

  void read() {
    const promise p = into_.promised();
    bool good = true;
    if (word_ == "skip") {
      into_.decline();
      next();
    } else if (p == promise::any)
      good = hit();
    else if (p == promise::count)
      good = count();
    else if ((word_ == "none" || word_ == "null") && is_first(p))
      next();
    else
      good = cells();
    while (good && !word_.empty())
      good = extra();
    if (good)
      into_.end();
  }

private:
  void next() { word_ = next_word(rest_); }
  bool wrong(std::string why) {
    into_.wrong(std::move(why));
    return false;
  }
  /// An integer, or a number as it is written by hand.
  bool index(double& x) {
    char* end = nullptr;
    x = std::strtod(word_.c_str(), &end);
    if (word_.empty() || *end != '\0')
      return wrong(word_.empty() ? "the line ends within a voxel"
                                 : fmt::format("{} is no index", in_quotes(word_)));
    next();
    return true;
  }
  bool number(double& x) {
    const auto bits = into_.bits() ? number_of_bits(word_) : std::nullopt;
    const auto read = bits ? bits : number_text();
    if (!read)
      return wrong(word_.empty() ? "the line ends before its numbers"
                                 : fmt::format("{} is no number", in_quotes(word_)));
    x = *read;
    next();
    return true;
  }
  [[nodiscard]] std::optional<double> number_text() const {
    char* end = nullptr;
    const double x = std::strtod(word_.c_str(), &end);
    return word_.empty() || *end != '\0' ? std::nullopt : std::optional(x);
  }
  bool hit() {
    const bool yes = word_ == "true" || word_ == "1";
    if (!yes && word_ != "false" && word_ != "0")
      return wrong(fmt::format("{} is neither true nor false", in_quotes(word_)));
    into_.hit(yes);
    next();
    return true;
  }
  bool count() {
    double n = 0;
    if (!index(n))
      return false;
    into_.crossings(n);
    return true;
  }
  bool cells() {
    while (!word_.empty() && !is_keyword()) {
      std::array<double, 3> at{};
      for (unsigned a = 0; a < (into_.of_boxes() ? 1u : 3u); ++a)
        if (!index(at[a]))
          return false;
      into_.cell(at);
    }
    return true;
  }
  [[nodiscard]] bool is_keyword() const {
    for (const char* k : {"t", "distance", "face", "received", "id", "echo"})
      if (word_ == k)
        return true;
    return false;
  }
  /// A keyword and what follows it.
  bool extra() {
    const std::string key = word_;
    next();
    double x = 0;
    if (is_first(into_.promised()) && (key == "t" || key == "distance")) {
      if (!number(x))
        return false;
      key == "t" ? into_.t(x) : into_.distance(x);
      return true;
    }
    if (is_first(into_.promised()) && key == "face") {
      into_.entered(word_ == "none" ? "" : word_);
      next();
      return true;
    }
    if (key == "id") {
      if (word_ != std::to_string(id_))
        return wrong(fmt::format("its id is not {}", id_));
      next();
      return true;
    }
    if (key == "received")
      return received();
    if (key == "echo")
      return echo();
    return wrong(fmt::format("{} is unknown in an answer of the promise \"{}\"", in_quotes(key),
                             name_of(into_.promised())));
  }
  bool received() {
    received_ray r{};
    vec3& second = into_.of_segment() ? r.end.emplace() : r.direction;
    for (vec3* v : {&r.origin, &second})
      for (double& x : *v)
        if (!number(x))
          return false;
    into_.received(r);
    return true;
  }
  bool echo() {
    echo_numbers numbers{};
    for (double& x : numbers)
      if (!number(x))
        return false;
    if (echo_ != nullptr)
      *echo_ = {true, numbers, std::signbit(numbers[0])};
    return true;
  }

  std::string_view rest_;
  std::string word_;
  std::uint64_t id_;
  answer& into_;
  echoed* echo_;
};

bool holds_nan(std::string_view line) {
  static constexpr std::string_view nan = "nan";
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::search(line.begin(), line.end(), nan.begin(), nan.end(),
                     [&](char a, char b) { return lower(a) == b; }) != line.end();
}

void fail_by_json(std::string_view line, answer& into) {
  if (holds_nan(line)) // JSON has none
    return into.not_a_number();
  into.wrong("this is no JSON");
}

} // namespace

void read_answer(std::string_view line, const trial& t, std::uint64_t id, const answer_form& form,
                 visited& out, echoed* echo) {
  answer into(t, form, out);
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || (line[start] != '[' && line[start] != '{'))
    return plain_reader(line, id, into, echo).read();
  if (const json parsed = json::parse(line, nullptr, false); !parsed.is_discarded())
    read_json(parsed, line, id, into, echo);
  else
    fail_by_json(line, into);
}

bool read_batch(std::string_view line, std::span<const trial> trials,
                std::span<const std::size_t> places, std::uint64_t first_id,
                const answer_form& form, std::span<visited> out, echoed* echo) {
  const json parsed = json::parse(line, nullptr, false);
  std::string why;
  if (!parsed.is_object() || parsed.size() != 1 || !parsed.contains("answers"))
    why = "the answer to a batch is not {\"answers\":[...]} and no more";
  else if (const json& list = parsed["answers"]; !list.is_array() || list.size() != places.size())
    why = fmt::format("{} answers to {} requests", list.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    answer into(trials[places[i]], form, out[places[i]]);
    if (parsed.is_discarded())
      fail_by_json(line, into);
    else if (!why.empty())
      into.wrong(why);
    else
      read_json(parsed["answers"][i], line, first_id + i, into, i == 0 ? echo : nullptr);
  }
  return why.empty() && !parsed.is_discarded();
}

} // namespace graze::fuzz
