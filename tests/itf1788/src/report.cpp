#include <fmt/format.h>
#include <graze/itf1788/report.hpp>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

namespace graze::itf1788 {

namespace {

std::string counts(const totals& t) {
  return fmt::format("{} passed, {} failed, {} unsupported", t.passed, t.failed, t.unsupported);
}

// ordered: the members as documented, not by the alphabet
nlohmann::ordered_json members(const totals& t) {
  return {{"passed", t.passed}, {"failed", t.failed}, {"unsupported", t.unsupported}};
}

} // namespace

totals total_of(const file_report& report) {
  return {report.count(verdict::passed) + report.count(verdict::tighter),
          report.count(verdict::failed), report.count(verdict::unsupported)};
}

totals total_of(const std::vector<file_report>& reports) {
  totals all;
  for (const file_report& report : reports) {
    const totals t = total_of(report);
    all.passed += t.passed;
    all.failed += t.failed;
    all.unsupported += t.unsupported;
  }
  return all;
}

std::vector<file_report> strict(std::vector<file_report> reports) {
  for (file_report& report : reports)
    for (judged& j : report.statements)
      if (j.is.is == verdict::tighter)
        j.is.is = verdict::failed;
  return reports;
}

std::string to_text(const std::vector<file_report>& reports, bool verbose) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const file_report& report : reports) {
    std::map<std::string, int> missing;
    for (const auto& [s, is] : report.statements) {
      const std::string where = fmt::format("{}:{}: ", report.path, s.line);
      if (is.is == verdict::failed || is.is == verdict::tighter)
        fmt::format_to(out, "{}{}: {}\n  expected {}\n  got      {}\n", where,
                       is.is == verdict::failed ? "failed" : "passed, tighter than stated",
                       s.written, is.expected, is.got);
      else if (is.is == verdict::unsupported && verbose)
        fmt::format_to(out, "{}unsupported: {}: no {}\n", where, s.written, is.missing);
      else if (is.is == verdict::unsupported)
        ++missing[is.missing];
      else if (verbose)
        fmt::format_to(out, "{}passed: {}\n", where, s.written);
    }
    for (const auto& [operation, count] : missing)
      fmt::format_to(out, "{}: unsupported: {} ({} statement{})\n", report.path, operation, count,
                     count == 1 ? "" : "s");
    fmt::format_to(out, "{}: {}\n", report.path, counts(total_of(report)));
  }
  fmt::format_to(out, "total: {}\n", counts(total_of(reports)));
  return text;
}

std::string to_json(const std::vector<file_report>& reports) {
  using json = nlohmann::ordered_json;
  json files = json::array(), failures = json::array(), tighter = json::array(),
       unsupported = json::array();
  for (const file_report& report : reports) {
    json file = {{"file", report.path}};
    file.update(members(total_of(report)));
    files.push_back(file);
    for (const auto& [s, is] : report.statements) {
      json entry = {{"file", report.path}, {"line", s.line}, {"statement", s.written}};
      if (is.is == verdict::failed || is.is == verdict::tighter) {
        entry["expected"] = is.expected;
        entry["got"] = is.got;
        (is.is == verdict::failed ? failures : tighter).push_back(entry);
      } else if (is.is == verdict::unsupported) {
        entry["missing"] = is.missing;
        unsupported.push_back(entry);
      }
    }
  }
  const json all = {{"files", files},
                    {"failures", failures},
                    {"tighter", tighter},
                    {"unsupported", unsupported},
                    {"total", members(total_of(reports))}};
  // file names need not be UTF-8
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace graze::itf1788
