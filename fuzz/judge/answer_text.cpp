#include <fmt/format.h>
#include <fmt/ranges.h>
#include <judge/answer_text.hpp>
#include <judge/first.hpp>

namespace graze::fuzz {

namespace {

std::vector<std::string> names_of(const trial& t, octant_set cells) {
  std::vector<std::string> names;
  for (octant_set left = cells; left != 0; left &= left - 1)
    names.push_back(cell_name(t, static_cast<octant_number>(std::countr_zero(left))));
  return names;
}

constexpr std::size_t most_names = 12;

/// The first few, and how many more there are.
std::string listed(const std::vector<std::string>& names) {
  const std::size_t some = std::min(names.size(), most_names);
  return fmt::format("{}{}",
                     fmt::join(names.begin(), names.begin() + static_cast<long>(some), ", "),
                     names.size() > some ? fmt::format(", ... {} more", names.size() - some) : "");
}

std::string alternatives(const std::vector<std::string>& all) {
  if (all.size() < 2)
    return all.empty() ? "none" : all[0];
  if (all.size() > most_names)
    return listed(all);
  const auto last = all.end() - 1;
  return fmt::format("{} or {}", fmt::join(all.begin(), last, ", "), *last);
}

std::string first_text(const trial& t, const truth& exact, const visited& answer, promise p,
                       const allowance& allowed, const verdict& v) {
  const remarks& said = answer.said();
  std::string text = "answered first ";
  if (answer.elsewhere())
    text += fmt::format("[{}]", fmt::join(*answer.elsewhere(), ","));
  else
    text += answer.size() == 0 ? (answer.outside() ? "one that there is not" : "none")
                               : cell_name(t, answer[0]);
  if (said.t)
    text += fmt::format(", t {}", *said.t);
  if (said.distance)
    text += fmt::format(", distance {}", *said.distance);
  if (said.entered)
    text += fmt::format(", face {}{}", said.entered->upper ? '+' : '-', "xyz"[said.entered->axis]);
  if (said.no_face)
    text += ", face none";
  if (v.findings == 0 || answer.elsewhere())
    return text;
  constexpr finding_set remark = bit(finding::distance) | bit(finding::face);
  if ((v.findings & ~remark) != 0) {
    const right_first right = right_first_of(t, exact, p, allowed);
    std::vector<std::string> names = names_of(t, right.cells);
    if (right.none)
      names.emplace_back("none");
    return text + "; right: " + alternatives(names);
  }
  const right_entry right = entry_into(t, answer[0], allowed.tolerance);
  std::vector<std::string> parts;
  const auto about = [&](const char* name, const std::array<double, 2>& range) {
    parts.push_back(fmt::format("{} {:.17g}", name, range[0] / 2 + range[1] / 2));
  };
  if (said.t && (v.findings & bit(finding::distance)) != 0)
    about("t", right.t);
  if (said.distance && (v.findings & bit(finding::distance)) != 0)
    about("distance", right.distance);
  if ((v.findings & bit(finding::face)) != 0)
    parts.push_back(alternatives(right.faces));
  return text + fmt::format("; right: {}", fmt::join(parts, ", "));
}

std::string list_text(const trial& t, const visited& answer, const verdict& v) {
  std::vector<std::string> names;
  for (unsigned i = 0; i < answer.size(); ++i)
    names.push_back(cell_name(t, answer[i]));
  std::string text = "answered " + (names.empty() ? std::string("no cell") : listed(names));
  if (answer.outside())
    text += ", and one that there is not";
  if (answer.repeated())
    text += ", one of them twice";
  if (const octant_set missed = v.missed | v.crossed_missed; missed != 0)
    text += "; missed " + listed(names_of(t, missed));
  if (v.spurious != 0)
    text += "; not touched " + listed(names_of(t, v.spurious));
  return text;
}

} // namespace

std::string cell_name(const trial& t, octant_number v) {
  if (t.boxes)
    return std::to_string(v);
  return fmt::format("[{},{},{}]", t.base[0] + (v & 3u), t.base[1] + (v >> 2 & 3u),
                     t.base[2] + (v >> 4));
}

right_first right_first_of(const trial& t, const truth& exact, promise p,
                           const allowance& allowed) {
  right_first right;
  visited answer;
  const auto is_right = [&] { return judge(t, exact, answer, p, allowed).findings == 0; };
  answer.clear();
  right.none = is_right();
  for (octant_set left = t.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    answer.clear();
    answer.push(v);
    right.cells |= octant_set{is_right()} << v;
  }
  return right;
}

std::string answer_text(const trial& t, const truth& exact, const visited& answer, promise p,
                        const allowance& allowed) {
  if (answer.failed() == fault::malformed && !answer.thrown().empty())
    return "answered what is none: " + answer.thrown();
  if (answer.failed() != fault::none || answer.declined())
    return {};
  switch (p) {
  case promise::first:
  case promise::first_touched:
    return first_text(t, exact, answer, p, allowed, judge(t, exact, answer, p, allowed));
  case promise::any:
    return fmt::format("answered {}; right: {}", answer.said().hit.value_or(answer.size() != 0),
                       exact.touched != 0);
  case promise::count: {
    const auto known = crossings_of(t);
    if (!answer.said().crossings || !known)
      return {};
    return fmt::format("answered {}; right: {}", *answer.said().crossings,
                       known->number ? std::to_string(*known->number)
                                     : (known->odd ? "an odd number" : "an even number"));
  }
  default:
    return list_text(t, answer, judge(t, exact, answer, p, allowed));
  }
}

} // namespace graze::fuzz
