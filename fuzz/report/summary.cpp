#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>
#include <report/report.hpp>
#include <report/summary.hpp>
#include <tuple>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;

campaign_result result_of(const merged_campaign& m) {
  campaign_result r;
  r.by_generator = m.state.by_generator;
  r.total = m.state.total();
  r.seconds = m.state.elapsed;
  r.first.resize(r.by_generator.size());
  r.first_tame.resize(r.by_generator.size());
  return r;
}

/// Tame ones first, most serious first, then by the lowest ray.
std::vector<std::pair<std::string, campaign_state::known_finding>>
sorted_findings(const merged_campaign& m) {
  std::vector<std::pair<std::string, campaign_state::known_finding>> all(m.state.findings.begin(),
                                                                         m.state.findings.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::tuple(!a.second.tame, a.second.kind, a.second.ray, a.first) <
           std::tuple(!b.second.tame, b.second.kind, b.second.ray, b.first);
  });
  return all;
}

/// A path as the address of a link.
std::string address(const std::string& path) {
  std::string out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

/// What is in a finding's file; a link would show what is elsewhere.
std::string text_of_finding(const std::string& path) {
  constexpr std::uint64_t most = 1 << 16;
  std::error_code error;
  if (std::filesystem::is_symlink(path, error))
    return "(a link, not followed)";
  const auto text = support::read_file(path, most);
  return text ? support::shown(text->substr(0, text->find('\n')), most) : "(" + text.reason() + ")";
}

std::string row(std::string_view name, const counts& c) {
  return fmt::format(
      "<tr><th>{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
      "<td>{}</td><td>{}</td><td>{:.4f}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      support::markup(name), c.rays, c.touched, c.misses, c.crossed_missed, c.gross_missed, c.gaps,
      c.seams, c.spurious, 100 * c.spurious_rate(), c.far_spurious, c.order_errors, c.revisits,
      c.findings);
}

const char* const style = R"(<style>
body { font: 15px/1.5 sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em }
table { border-collapse: collapse; display: block; overflow-x: auto }
th, td { border-bottom: 1px solid #8884; padding: .2em .7em; text-align: right }
th:first-child, table.findings td, table.findings th { text-align: left }
code { font-size: 12px; overflow-wrap: anywhere }
</style>)";

} // namespace

expected<merged_campaign> merge_campaigns(const std::vector<std::string>& folders) {
  merged_campaign m;
  m.folders = folders;
  double elapsed = 0;
  for (const std::string& folder : folders) {
    m.state.elapsed = 0;
    const auto plan = read_campaign(folder, m.state);
    if (!plan)
      return unexpected{plan.reason()};
    if (&folder == &folders.front()) {
      m.plan = *plan;
    } else if (const std::string other = difference(*plan, m.plan, common_members());
               !other.empty()) {
      return unexpected{
          fmt::format("{} is not of the same campaign as {}: {}", folder, folders.front(), other)};
    }
    m.state.by_generator.resize(m.plan.generators.size());
    elapsed += m.state.elapsed;
    for (const auto& [hash, ignored] : m.state.findings)
      if (std::string& file = m.files[hash]; file.empty() || !support::is_there(file))
        file = finding_path(folder, hash);
  }
  m.state.elapsed = elapsed;
  m.lost =
      static_cast<std::size_t>(std::count_if(m.files.begin(), m.files.end(), [](const auto& file) {
        return !support::is_there(file.second);
      }));
  return m;
}

std::string to_text(const merged_campaign& m, const campaign_plan& plan) {
  const campaign_result r = result_of(m);
  std::string text = fmt::format(
      "{} at level {}, seed {}: {} rays in {} pieces, {:.2f} s, {:.0f} rays/s\n{}",
      plan.under_test.name, m.plan.level, m.plan.seed, r.total.rays, m.state.finished.size(),
      r.seconds, r.seconds > 0 ? static_cast<double>(r.total.rays) / r.seconds : 0, table(plan, r));
  const auto findings = sorted_findings(m);
  if (findings.empty())
    return text + "nothing found\n";
  constexpr std::size_t shown = 10;
  for (std::size_t i = 0; i < std::min(findings.size(), shown); ++i)
    text += fmt::format("{:<15} ray {}, in {} piece{}: graze-fuzz replay {} {}\n",
                        name_of(findings[i].second.kind), findings[i].second.ray,
                        findings[i].second.pieces, findings[i].second.pieces == 1 ? "" : "s",
                        m.files.at(findings[i].first), plan.under_test.asked_for());
  return text + (findings.size() > shown ? fmt::format("... {} findings in all\n", findings.size())
                                         : std::string());
}

std::string to_json(const merged_campaign& m, const campaign_plan& plan) {
  json object = json::parse(to_json(plan, result_of(m), std::nullopt));
  for (const char* of_one_run : {"threads", "first_miss_seconds", "interrupted", "finding",
                                 "counterexample", "found_as", "ray"})
    object.erase(of_one_run);
  object["pieces"] = m.state.finished.size();
  object["findings"] = json::array();
  for (const auto& [hash, known] : sorted_findings(m))
    object["findings"].push_back({{"hash", hash},
                                  {"kind", name_of(known.kind)},
                                  {"ray", known.ray},
                                  {"pieces", known.pieces},
                                  {"tame", known.tame},
                                  {"file", m.files.at(hash)}});
  return support::json_line(object);
}

std::string to_html(const merged_campaign& m, const campaign_plan& plan,
                    const std::string& page_folder) {
  const counts total = m.state.total();
  const std::string title =
      fmt::format("graze-fuzz: {} at level {}", support::markup(m.plan.traversal),
                  support::markup(m.plan.level));
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>{0}</title>\n{1}\n"
      "</head><body>\n<h1>{0}</h1>\n<p>Seed {2}, {3} rays in {4} pieces, {5:.1f} s, {6:.0f} rays/s"
      ". {7}.</p>\n",
      title, style, m.plan.seed, total.rays, m.state.finished.size(), m.state.elapsed,
      m.state.elapsed > 0 ? static_cast<double>(total.rays) / m.state.elapsed : 0,
      m.state.findings.empty() ? std::string("Nothing found")
                               : fmt::format("{} findings after shrinking, on {} rays",
                                             m.state.findings.size(), total.findings));
  page += "<table>\n<tr><th>generator</th><th>rays</th><th>touched</th><th>misses</th>"
          "<th>crossed</th><th>gross</th><th>gaps</th><th>seams</th><th>spurious</th><th>% of "
          "visits</th>"
          "<th>far</th>"
          "<th>order</th><th>revisit</th><th>rays with a finding</th></tr>\n";
  for (std::size_t g = 0; g < plan.generators.size(); ++g)
    page += row(plan.generators[g]->name, m.state.by_generator[g]);
  page += row("all", total) + "</table>\n";
  if (!m.state.findings.empty()) {
    page += "<h2>Findings</h2>\n<table class=\"findings\">\n<tr><th>kind</th><th>first ray</th>"
            "<th>generator</th><th>pieces</th><th>shrunk (graze-fuzz replay FILE " +
            support::markup(plan.under_test.asked_for()) + ")</th></tr>\n";
    for (const auto& [hash, known] : sorted_findings(m)) {
      const std::string& file = m.files.at(hash);
      std::error_code error;
      const auto link = std::filesystem::relative(file, page_folder, error);
      page += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
                          "<td><a href=\"{}\">{}</a><br><code>{}</code></td></tr>\n",
                          name_of(known.kind), known.ray,
                          plan.generators[generator_of(plan, known.ray)]->name, known.pieces,
                          address(error ? file : link.string()), hash,
                          support::markup(text_of_finding(file)));
    }
    page += "</table>\n";
  }
  return page + "</body></html>\n";
}

} // namespace graze::fuzz
