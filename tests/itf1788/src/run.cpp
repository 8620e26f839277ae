#include <algorithm>
#include <filesystem>
#include <graze/itf1788/operations.hpp>
#include <graze/itf1788/run.hpp>
#include <graze/itf1788/tighter.hpp>
#include <graze/support/files.hpp>

namespace graze::itf1788 {

namespace {

std::string joined(const std::vector<value>& values, const char* with,
                   std::string (*text)(const value&)) {
  std::string all;
  for (const value& v : values)
    all += (all.empty() ? "" : with) + text(v);
  return all;
}

std::string with_signal(std::string text, const std::string& signal) {
  return signal.empty() ? text : text + (text.empty() ? "signal " : " signal ") + signal;
}

std::string stated_results(const statement& s) {
  std::string text = joined(s.tightest, " ", to_text);
  if (!s.accurate.empty())
    text += (text.empty() ? "<= " : " <= ") + joined(s.accurate, " ", to_text);
  return with_signal(text, s.signal);
}

/// Passed, tighter or failed.
verdict verdict_of(const statement& s, const std::vector<value>& got) {
  const std::size_t count = std::max(s.tightest.size(), s.accurate.size());
  if (got.size() != count)
    return verdict::failed;
  verdict worst = verdict::passed;
  for (std::size_t i = 0; i < count; ++i) {
    const bool as_stated = s.accurate.empty()
                               ? same(s.tightest[i], got[i])
                               : within(got[i], s.accurate[i]) &&
                                     (s.tightest.empty() || within(s.tightest[i], got[i]));
    if (as_stated)
      continue;
    if (!s.accurate.empty() || !proved_tighter(s, s.tightest[i], got[i]))
      return verdict::failed;
    worst = verdict::tighter;
  }
  return worst;
}

} // namespace

judgement judge(const statement& s) {
  const std::vector<result> results = call(s.operation, s.operands);
  if (results.empty())
    return {verdict::unsupported, "", "",
            s.operation + "(" + joined(s.operands, ", ", kind_of) + ")"};
  judgement worst;
  for (const result& r : results) {
    const verdict v = r.signal == s.signal ? verdict_of(s, r.values) : verdict::failed;
    if (v <= worst.is)
      continue;
    std::string got = with_signal(joined(r.values, " ", to_text), r.signal);
    if (!r.form.empty())
      got += " by " + r.form;
    worst = {v, stated_results(s), got, ""};
  }
  return worst;
}

int file_report::count(verdict v) const {
  return static_cast<int>(std::count_if(statements.begin(), statements.end(),
                                        [v](const judged& j) { return j.is.is == v; }));
}

expected<file_report> run_file(const std::string& path) {
  const auto text = support::read_file(path, largest_file);
  if (!text)
    return unexpected{text.reason()};
  auto statements = parse(*text, path);
  if (!statements)
    return unexpected{statements.reason()};
  file_report report{path, {}};
  for (statement& s : *statements) {
    judgement j = judge(s);
    report.statements.push_back({std::move(s), std::move(j)});
  }
  return report;
}

expected<std::vector<std::string>> files_of(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error))
    return unexpected{"no such file or folder: " + path};
  if (!fs::is_directory(path, error))
    return std::vector{path};
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator i(path, error), end; !error && i != end; i.increment(error))
    if (i->path().extension() == ".itl" && i->is_regular_file(error))
      files.push_back(i->path().string());
  if (error)
    return support::failed("read the folder", path, error.value());
  if (files.empty())
    return unexpected{"no .itl file in " + path};
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace graze::itf1788
