#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>
#include <report/checks/checks.hpp>
#include <trial/content_hash.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;

const char* baseline_state(standing s) {
  switch (s) {
  case standing::known:
    return "unchanged";
  case standing::more:
    return "updated";
  case standing::gone:
    return "absent";
  default:
    return "new";
  }
}

json result_of(const check_report& report, const check_result& c, const problem& p) {
  json result{{"ruleId", name_of(p.kind)},
              {"ruleIndex", static_cast<unsigned>(p.kind)},
              {"kind", "fail"},
              {"level", fails(p.how) ? "error" : "note"},
              {"message", {{"text", support::utf8(p.sentence + "\n" + p.details)}}}};
  if (!p.file.empty())
    result["locations"] = json::array({{{"physicalLocation",
                                         {{"artifactLocation", {{"uri", uri_of(p.file)}}},
                                          {"region", {{"startLine", p.file_line}}}}}}});
  // the same finding has the same fingerprint, wherever it is shown
  result["partialFingerprints"] = {
      {"grazeFinding/v1",
       content_hash(std::string(name_of(p.kind)) + (p.ray.empty() ? c.name : p.ray))}};
  if (report.compared)
    result["baselineState"] = baseline_state(p.how);
  result["properties"] = {{"check", support::utf8(c.name)}};
  if (!p.ray.empty())
    result["properties"]["ray"] = json::parse(p.ray, nullptr, false);
  return result;
}

} // namespace

std::string standings_json(const check_report& report) {
  json object{{"known", json::array()},
              {"new", json::array()},
              {"more", json::array()},
              {"gone", json::array()}};
  for (const check_result& c : report.checks)
    for (const problem& p : c.problems)
      object[name_of(p.how)].push_back({{"check", c.name}, {"finding", name_of(p.kind)}});
  return support::json_line(object);
}

std::string to_sarif(const check_report& report, std::string_view version) {
  json rules = json::array();
  for (unsigned k = 0; k < finding_kinds; ++k) {
    const auto kind = static_cast<finding>(k);
    rules.push_back({{"id", name_of(kind)},
                     {"shortDescription", {{"text", sentence_of(kind)}}},
                     {"defaultConfiguration", {{"level", "error"}}}});
  }
  json results = json::array();
  for (const check_result& c : report.checks)
    for (const problem& p : c.problems)
      results.push_back(result_of(report, c, p));
  const json driver{{"name", "graze-fuzz"}, {"version", version}, {"rules", rules}};
  const json run{{"tool", {{"driver", driver}}},
                 {"invocations", json::array({{{"executionSuccessful", true}}})},
                 {"columnKind", "utf16CodeUnits"},
                 {"results", results},
                 {"properties",
                  {{"command", report.command}, {"traversal", support::utf8(report.traversal)}}}};
  const json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", json::array({run})}};
  return log.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

} // namespace graze::fuzz
