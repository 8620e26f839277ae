#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <report/checks/checks.hpp>

namespace graze::fuzz {

std::string_view name_of(standing s) {
  static constexpr std::array<std::string_view, 4> names{"known", "new", "more", "gone"};
  return names[static_cast<unsigned>(s)];
}

bool fails(const check_report& report) {
  return std::any_of(report.checks.begin(), report.checks.end(), [](const check_result& c) {
    return std::any_of(c.problems.begin(), c.problems.end(),
                       [](const problem& p) { return fails(p.how); });
  });
}

std::string standings_text(const check_report& report) {
  std::array<unsigned, 4> counted{};
  std::string others;
  for (const check_result& c : report.checks)
    for (const problem& p : c.problems) {
      ++counted[static_cast<unsigned>(p.how)];
      if (p.how == standing::known)
        continue;
      const std::string where = c.name == name_of(p.kind) ? std::string() : c.name + ": ";
      others += support::shown(
                    fmt::format("{}: {}{}: {}", name_of(p.how), where, name_of(p.kind), p.sentence),
                    1000) +
                "\n";
    }
  return fmt::format("baseline: {} known, {} new, {} more, {} gone\n{}", counted[0], counted[1],
                     counted[2], counted[3], others);
}

std::string uri_of(const std::string& path) {
  std::string out = path.starts_with('/') ? "file://" : "";
  for (const char c : path.starts_with("./") ? path.substr(2) : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

namespace {

std::string kinds_of(const std::vector<const problem*>& problems) {
  std::string text;
  for (const problem* p : problems)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name_of(p->kind));
  return text;
}

std::vector<const problem*> those(const check_result& c, bool (*wanted)(standing)) {
  std::vector<const problem*> some;
  for (const problem& p : c.problems)
    if (wanted(p.how))
      some.push_back(&p);
  return some;
}

bool is_failing(standing s) { return fails(s); }
bool is_known(standing s) { return s == standing::known; }

} // namespace

std::string to_junit(const check_report& report) {
  std::string cases;
  std::size_t failures = 0, skipped = 0;
  for (const check_result& c : report.checks) {
    cases += fmt::format("    <testcase classname=\"graze-fuzz.{}\" name=\"{}\" time=\"0\"",
                         support::markup(report.command), support::markup(c.name));
    const auto failing = those(c, is_failing), known = those(c, is_known);
    if (!failing.empty()) {
      ++failures;
      std::string text;
      for (const problem* p : failing)
        text += fmt::format("{}: {}\n{}", name_of(p->kind), p->sentence, p->details);
      cases += fmt::format(">\n      <failure type=\"{}\" message=\"{}\">{}</failure>\n"
                           "    </testcase>\n",
                           kinds_of(failing), support::markup(failing.front()->sentence),
                           support::markup(text));
    } else if (!known.empty() || !c.declined.empty()) {
      ++skipped;
      cases += fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n",
                           support::markup(known.empty() ? c.declined
                                                         : "known: " + kinds_of(known) + ": " +
                                                               known.front()->sentence));
    } else {
      cases += "/>\n";
    }
  }
  const std::string numbers =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"{:.3f}\"",
                  report.checks.size(), failures, skipped, report.seconds);
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"graze-fuzz\" "
                     "{0}>\n  <testsuite name=\"graze-fuzz {1} {2}\" {0}>\n{3}  </testsuite>\n"
                     "</testsuites>\n",
                     numbers, support::markup(report.command), support::markup(report.traversal),
                     cases);
}

namespace {

/// As GitHub's toolkit escapes what stands behind the second "::", and in a property before it.
std::string escaped(std::string_view text, bool property) {
  std::string out;
  for (const char c : support::utf8(text))
    if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ',')))
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return out;
}

} // namespace

std::string to_annotations(const check_report& report) {
  std::string text;
  for (const check_result& c : report.checks)
    for (const problem& p : c.problems) {
      std::string where;
      if (!p.file.empty())
        where = fmt::format("file={},line={},", escaped(p.file, true), p.file_line);
      const std::string word =
          report.compared ? fmt::format(" ({})", name_of(p.how)) : std::string();
      text += fmt::format("::{} {}title={}::{}\n", fails(p.how) ? "error" : "notice", where,
                          escaped(fmt::format("graze-fuzz: {}{}", name_of(p.kind), word), true),
                          escaped(p.sentence + "\n" + p.details, false));
    }
  return text;
}

} // namespace graze::fuzz
