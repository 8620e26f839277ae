#include <algorithm>
#include <bit>
#include <campaign/store.hpp>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>
#include <trial/content_hash.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

using support::status;

namespace {

using json = nlohmann::ordered_json;
/// What is read: its keys are looked up by a tree, so that many of them take no time.
using read_json = nlohmann::json;
constexpr std::uint64_t largest_plan = 1 << 20;
constexpr std::size_t longest_line = 1 << 20; ///< of progress.jsonl
namespace files = std::filesystem;

json to_json(const std::optional<external_options>& e) {
  return e ? json{{"promise", e->promised ? json(name_of(*e->promised)) : json()},
                  {"cells", e->cells ? json(name_of(*e->cells)) : json()},
                  {"segments", e->segments ? json(*e->segments) : json()},
                  {"tolerance", e->tolerance ? json(*e->tolerance) : json()},
                  {"batch", e->batch},
                  {"plain", e->format == line_format::plain},
                  {"bits", e->format == line_format::bits},
                  {"float", e->as_float},
                  {"received", e->needs_received},
                  {"timeout", e->seconds_a_ray}}
           : json();
}

json to_json(const stored_plan& p) {
  return json{{"graze_campaign", 1},
              {"traversal", p.traversal},
              {"external", to_json(p.external)},
              {"generators", p.generators},
              {"search", p.search},
              {"level", p.level},
              {"cells", p.cells},
              {"segments", p.segments},
              {"grid", p.grid.empty() ? json() : json::parse(p.grid)},
              {"scene", p.scene ? json{{"file", p.scene->path},
                                       {"voxel_size", p.scene->voxel_size},
                                       {"cell_centred", p.scene->cell_centred}}
                                : json()},
              {"seed", p.seed},
              {"rays", p.rays},
              {"seconds", p.seconds},
              {"tame", p.tame},
              {"hangs", p.hangs},
              {"piece", p.piece},
              {"shard", p.shard},
              {"shards", p.shards}};
}

/// Throws what is wrong with it.
std::uint64_t read_count(const read_json& value, const char* name) {
  const auto count = support::whole_number<std::uint64_t>(value);
  if (!count)
    throw std::invalid_argument(
        fmt::format("\"{}\" is not a whole number from 0 to 2^64 - 1", name));
  return *count;
}

/// Throws what is wrong with it.
external_options read_external(const read_json& object, std::string command) {
  external_options e;
  e.command = std::move(command);
  if (const read_json& promised = object.at("promise"); !promised.is_null()) {
    e.promised = promise_of(promised.get<std::string>());
    if (!e.promised)
      throw std::invalid_argument("there is no such promise");
  }
  if (const read_json cells = object.value("cells", read_json()); !cells.is_null()) {
    e.cells = cell_kind_of(cells.get<std::string>());
    if (!e.cells)
      throw std::invalid_argument("there are no such cells");
  }
  if (const read_json segments = object.value("segments", read_json()); !segments.is_null())
    e.segments = segments.get<bool>();
  if (const read_json ulps = object.value("tolerance", read_json()); !ulps.is_null())
    e.tolerance = ulps.get<double>();
  e.batch = object.value("batch", std::uint64_t{0});
  if (object.at("plain").get<bool>())
    e.format = line_format::plain;
  else if (object.value("bits", false))
    e.format = line_format::bits;
  e.as_float = object.at("float").get<bool>();
  e.needs_received = object.value("received", false);
  e.seconds_a_ray = object.at("timeout").get<double>();
  return e;
}

/// Throws what is wrong with it.
stored_plan read_plan_members(const read_json& object) {
  stored_plan p;
  const auto number = [&object](const char* key) { return read_count(object.at(key), key); };
  p.traversal = object.at("traversal").get<std::string>();
  if (const read_json external = object.value("external", read_json()); !external.is_null())
    p.external = read_external(external, p.traversal);
  p.generators = object.at("generators").get<std::vector<std::string>>();
  p.search = object.value("search", p.search);
  p.level = object.at("level").get<std::string>();
  p.cells = object.value("cells", p.cells);
  p.segments = object.value("segments", p.segments);
  if (const read_json scene = object.value("scene", read_json()); !scene.is_null()) {
    p.scene = map_file{scene.at("file").get<std::string>(), scene.at("voxel_size").get<double>(),
                       scene.at("cell_centred").get<bool>()};
    if (!(p.scene->voxel_size >= 0) || !std::isfinite(p.scene->voxel_size))
      throw std::invalid_argument("the voxel size of its scene is not a length");
  }
  if (const read_json grid = object.value("grid", read_json()); !grid.is_null())
    p.grid = grid.dump();
  p.seed = number("seed");
  p.rays = number("rays");
  p.seconds = object.at("seconds").get<double>();
  p.tame = object.at("tame").get<bool>();
  p.hangs = number("hangs");
  p.piece = number("piece");
  p.shard = number("shard");
  p.shards = number("shards");
  return p;
}

expected<stored_plan> read_plan(const std::string& path) {
  const auto text = support::read_file(path, largest_plan);
  if (!text)
    return unexpected{text.reason()};
  auto plan = plan_from(*text);
  if (!plan)
    return unexpected{fmt::format("{}: {}", path, plan.reason())};
  return plan;
}

/// A line of progress of this plan; throws what is wrong with it.
finished_piece read_piece(std::string_view text, const stored_plan& plan) {
  const read_json line = read_json::parse(text);
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  finished_piece p;
  p.number = read_count(line.at("piece"), "piece");
  p.elapsed = line.at("elapsed").get<double>();
  if (!(p.elapsed >= 0))
    refuse("its time is negative");
  if (p.number % plan.shards != plan.shard - 1 || (plan.rays != 0 && p.number >= plan.pieces()))
    refuse(fmt::format("piece {} is not of this plan", p.number));
  std::uint64_t rays = 0;
  for (const read_json& row : line.at("counts")) {
    count_row values{};
    if (!row.is_array() || row.size() != values.size())
      refuse("its counts are those of another version of graze-fuzz");
    std::transform(row.begin(), row.end(), values.begin(),
                   [](const read_json& count) { return read_count(count, "counts"); });
    p.by_generator.push_back(std::bit_cast<counts>(values));
    rays += p.by_generator.back().rays;
  }
  if (p.by_generator.size() != plan.generators.size() || rays != plan.rays_of(p.number))
    refuse("its counts are not of this plan");
  for (const read_json& shown : line.at("findings")) {
    const auto kind = finding_of(shown.at("kind").get<std::string>());
    if (!kind)
      refuse("it has a finding of another version of graze-fuzz");
    auto hash = shown.at("hash").get<std::string>();
    if (!support::is_content_hash(hash)) // it is a file's name, and stands in the page
      refuse("the hash of a finding is not 32 hex digits");
    p.findings.push_back(
        {std::move(hash), *kind, read_count(shown.at("ray"), "ray"), shown.at("tame").get<bool>()});
  }
  return p;
}

/// Adds all whole lines; `whole` becomes their length in bytes.
status read_progress(const std::string& path, const stored_plan& plan, campaign_state& state,
                     std::uint64_t& whole) {
  whole = 0;
  if (!support::is_there(path))
    return {};
  auto file = support::input_file::open(path);
  if (!file)
    return unexpected{file.reason()};
  std::string text;
  for (;;) {
    const auto read = file->read_line(text, longest_line);
    if (!read)
      return unexpected{read.reason()};
    if (!*read || !file->line_was_whole())
      return {};
    whole += text.size() + 1;
    const auto piece = piece_from(text, plan);
    if (!piece)
      return unexpected{fmt::format("{}:{}: {}", path, file->line_number(), piece.reason())};
    state.add(*piece);
  }
}

/// Nothing can be started where another's files are.
status check_new_folder(const std::string& folder) {
  std::error_code error;
  files::directory_iterator entry(folder, error);
  for (const files::directory_iterator end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name != "lock" && name != "findings" && !name.starts_with(support::part_prefix))
      return unexpected{fmt::format("{} has no plan.json and is not empty", folder)};
  }
  return error ? status(support::failed("read", folder, error.value())) : status();
}

/// Those of a start that was killed.
void remove_parts(const std::string& folder) {
  std::error_code ignored;
  files::directory_iterator entry(folder, ignored);
  for (const files::directory_iterator end; !ignored && entry != end; entry.increment(ignored))
    if (entry->path().filename().string().starts_with(support::part_prefix))
      files::remove(entry->path(), ignored);
}

} // namespace

expected<stored_plan> plan_from(std::string_view text) {
  const read_json object = read_json::parse(text, nullptr, false);
  if (!object.is_object() || object.value("graze_campaign", read_json()) != 1)
    return unexpected{"this is not the plan of a campaign"};
  try {
    stored_plan p = read_plan_members(object);
    if (const auto plan = resolve(p); !plan)
      return unexpected{plan.reason()};
    return p;
  } catch (const std::exception& e) {
    return unexpected{e.what()};
  }
}

expected<finished_piece> piece_from(std::string_view line, const stored_plan& plan) {
  try {
    return read_piece(line, plan);
  } catch (const read_json::parse_error&) {
    return unexpected{"not JSON"};
  } catch (const std::exception& e) {
    return unexpected{e.what()};
  }
}

std::uint64_t stored_plan::rays_of(std::uint64_t number) const {
  return rays == 0 ? piece : std::min(piece, rays - number * piece);
}

std::uint64_t stored_plan::shard_pieces() const {
  return shard > pieces() ? 0 : (pieces() - shard) / shards + 1;
}

std::uint64_t stored_plan::shard_rays() const {
  if (shard_pieces() == 0)
    return 0;
  const bool has_last = (pieces() - 1) % shards == shard - 1;
  return shard_pieces() * piece - (has_last ? piece - rays_of(pieces() - 1) : 0);
}

expected<campaign_plan> resolve(const stored_plan& stored) {
  auto plan = resolve(static_cast<const named_plan&>(stored));
  if (!plan)
    return plan;
  if (stored.piece < 1 || stored.piece > 1'000'000'000)
    return unexpected{"--piece is outside 1..1000000000"};
  if (stored.shard < 1 || stored.shard > stored.shards)
    return unexpected{
        fmt::format("shard {}/{} is not i/N with 1 <= i <= N", stored.shard, stored.shards)};
  return plan;
}

counts campaign_state::total() const {
  counts all;
  for (const counts& c : by_generator)
    all += c;
  return all;
}

bool campaign_state::add(const finished_piece& p) {
  if (!finished.insert(p.number).second)
    return false;
  by_generator.resize(std::max(by_generator.size(), p.by_generator.size()));
  for (std::size_t g = 0; g < p.by_generator.size(); ++g)
    by_generator[g] += p.by_generator[g];
  for (const sighting& s : p.findings) {
    auto& known =
        findings.try_emplace(s.hash, known_finding{s.kind, s.ray, 0, s.tame}).first->second;
    known.ray = std::min(known.ray, s.ray);
    ++known.pieces;
  }
  elapsed = std::max(elapsed, p.elapsed);
  return true;
}

std::string to_json_line(const finished_piece& p) {
  json line{{"piece", p.number}, {"elapsed", p.elapsed}};
  line["counts"] = json::array();
  for (const counts& c : p.by_generator)
    line["counts"].push_back(std::bit_cast<count_row>(c));
  line["findings"] = json::array();
  for (const sighting& s : p.findings)
    line["findings"].push_back(
        {{"hash", s.hash}, {"kind", name_of(s.kind)}, {"ray", s.ray}, {"tame", s.tame}});
  return line.dump();
}

finding_file file_of(finding kind, std::string_view traversal, const trial& shrunk) {
  json line{{"kind", name_of(kind)}, {"traversal", traversal}};
  line.update(json::parse(to_json_line(shrunk)));
  const std::string text = line.dump();
  return {content_hash(text), text};
}

expected<stored_plan> read_campaign(const std::string& folder, campaign_state& state) {
  const std::string path = folder + "/plan.json";
  if (!support::is_there(path))
    return unexpected{
        fmt::format("{} is not the folder of a campaign: it has no plan.json", folder)};
  auto plan = read_plan(path);
  if (!plan)
    return plan;
  std::uint64_t whole = 0;
  if (const status read = read_progress(folder + "/progress.jsonl", *plan, state, whole); !read)
    return unexpected{read.reason()};
  return plan;
}

std::string finding_path(const std::string& folder, const std::string& hash) {
  return fmt::format("{}/findings/{}.json", folder, hash);
}

std::string difference(const stored_plan& there, const stored_plan& wanted,
                       const std::vector<std::string>& members) {
  const json a = to_json(there), b = to_json(wanted);
  std::string text;
  for (const std::string& m : members)
    if (a.at(m) != b.at(m))
      text += fmt::format("{}{} is {}, not {}", text.empty() ? "" : "; ", m, a.at(m).dump(),
                          b.at(m).dump());
  return text;
}

const std::vector<std::string>& common_members() {
  static const std::vector<std::string> members{
      "traversal", "external", "generators", "search", "level", "cells", "segments",
      "grid",      "scene",    "seed",       "rays",   "tame",  "hangs", "piece"};
  return members;
}

expected<campaign_store> campaign_store::open(const std::string& folder, stored_plan plan,
                                              const std::vector<std::string>& given) {
  campaign_store store;
  store.folder_ = folder;
  if (plan.generators.empty())
    for (const generator& g : generators())
      plan.generators.emplace_back(g.name);
  const std::string plan_path = folder + "/plan.json", progress_path = folder + "/progress.jsonl";
  const bool is_new = !support::is_there(plan_path);
  if (is_new) {
    if (const auto resolved = resolve(plan); !resolved)
      return unexpected{resolved.reason()};
    if (const status made = support::make_folder(folder); !made)
      return unexpected{made.reason()};
    if (const status may = check_new_folder(folder); !may)
      return unexpected{may.reason()};
  }
  auto lock = support::lock_file(folder + "/lock",
                                 fmt::format("{} is in use by another graze-fuzz", folder));
  if (!lock)
    return unexpected{lock.reason()};
  store.lock_ = *std::move(lock);

  if (!support::is_there(plan_path))
    if (const status written = support::write_atomically(plan_path, to_json(plan).dump(2) + "\n");
        !written)
      return unexpected{written.reason()};
  auto there = read_plan(plan_path);
  if (!there)
    return unexpected{there.reason()};
  if (const std::string other = difference(*there, plan, given); !other.empty())
    return unexpected{fmt::format("{} holds another plan: {}", folder, other)};
  store.plan_ = std::move(*there);
  store.state_.by_generator.resize(store.plan().generators.size());

  const std::string findings = folder + "/findings";
  if (const status made = support::make_folder(findings); !made)
    return unexpected{made.reason()};
  for (const std::string& f : {folder, findings})
    remove_parts(f);

  std::uint64_t whole = 0;
  if (const status read = read_progress(progress_path, store.plan(), store.state_, whole); !read)
    return unexpected{read.reason()};
  // a line that was cut off must not become the beginning of the next
  auto progress = support::append_file::open(progress_path, whole);
  if (!progress)
    return unexpected{progress.reason()};
  store.progress_.emplace(*std::move(progress));
  store.resumed_ = !store.state().finished.empty();
  return store;
}

status campaign_store::keep(const finding_file& f) const {
  const std::string path = finding_path(folder_, f.hash);
  // the name tells the content, and a file of that name is whole
  return support::is_there(path) ? status() : support::write_atomically(path, f.line + "\n");
}

status campaign_store::append(const finished_piece& p) {
  if (status written = progress_->append(to_json_line(p) + "\n"); !written)
    return written;
  state_.add(p);
  return {};
}

} // namespace graze::fuzz
