#include <algorithm>
#include <bit>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <graze/fuzz/campaign_store.hpp>
#include <graze/fuzz/libraries.hpp>
#include <graze/fuzz/replay.hpp>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;
namespace files = std::filesystem;

/// The counts of a generator as they stand in the struct, so that a new one is not forgotten here.
using count_row = std::array<std::uint64_t, sizeof(counts) / sizeof(std::uint64_t)>;

std::string failed(const char* what, const std::string& path) {
  return fmt::format("cannot {} {}: {}", what, path, std::strerror(errno));
}

/// A descriptor that is closed at the end of its life.
class descriptor {
public:
  explicit descriptor(int fd) : fd_(fd) {}
  ~descriptor() {
    if (fd_ >= 0)
      close(fd_);
  }
  descriptor(const descriptor&) = delete;
  descriptor& operator=(const descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

private:
  int fd_;
};

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(fd, text.data(), text.size());
    if (n < 0 && errno != EINTR)
      return false;
    if (n > 0)
      text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// Makes the names in a folder last.
bool sync_folder(const std::string& folder) {
  const descriptor d(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return d.get() >= 0 && fsync(d.get()) == 0;
}

json to_json(const std::optional<external_options>& e) {
  return e ? json{{"promise", e->promised ? json(name_of(*e->promised)) : json()},
                  {"plain", e->format == line_format::plain},
                  {"float", e->as_float},
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
              {"seed", p.seed},
              {"rays", p.rays},
              {"seconds", p.seconds},
              {"piece", p.piece},
              {"shard", p.shard},
              {"shards", p.shards}};
}

/// Throws what is wrong with it.
external_options read_external(const json& object, std::string command) {
  external_options e;
  e.command = std::move(command);
  if (const json& promised = object.at("promise"); !promised.is_null()) {
    e.promised = promise_of(promised.get<std::string>());
    if (!e.promised)
      throw std::invalid_argument("there is no such promise");
  }
  e.format = object.at("plain").get<bool>() ? line_format::plain : line_format::json;
  e.as_float = object.at("float").get<bool>();
  e.seconds_a_ray = object.at("timeout").get<double>();
  return e;
}

expected<stored_plan> read_plan(const std::string& path) {
  std::ifstream file(path);
  const json object = json::parse(file, nullptr, false);
  if (!object.is_object() || object.value("graze_campaign", json()) != 1)
    return unexpected{fmt::format("{} is not the plan of a campaign", path)};
  stored_plan p;
  const auto number = [&object](const char* key) {
    if (!object.at(key).is_number_unsigned())
      throw std::invalid_argument(fmt::format("\"{}\" is not a number, 0 or more", key));
    return object.at(key).get<std::uint64_t>();
  };
  try {
    p.traversal = object.at("traversal").get<std::string>();
    if (const json external = object.value("external", json()); !external.is_null())
      p.external = read_external(external, p.traversal);
    p.generators = object.at("generators").get<std::vector<std::string>>();
    p.search = object.value("search", p.search);
    p.level = object.at("level").get<std::string>();
    p.seed = number("seed");
    p.rays = number("rays");
    p.seconds = object.at("seconds").get<double>();
    p.piece = number("piece");
    p.shard = number("shard");
    p.shards = number("shards");
  } catch (const std::exception& e) {
    return unexpected{fmt::format("{}: {}", path, e.what())};
  }
  if (const auto plan = resolve(p); !plan)
    return unexpected{fmt::format("{}: {}", path, plan.reason())};
  return p;
}

std::optional<finding> finding_of(std::string_view name) {
  for (unsigned k = 0; k < finding_kinds; ++k)
    if (name_of(static_cast<finding>(k)) == name)
      return static_cast<finding>(k);
  return std::nullopt;
}

/// A line of progress of this plan; throws what is wrong with it.
finished_piece read_piece(const std::string& text, const stored_plan& plan) {
  const json line = json::parse(text);
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  finished_piece p;
  p.number = line.at("piece").get<std::uint64_t>();
  p.elapsed = line.at("elapsed").get<double>();
  if (p.number % plan.shards != plan.shard - 1 || (plan.rays != 0 && p.number >= plan.pieces()))
    refuse(fmt::format("piece {} is not of this plan", p.number));
  std::uint64_t rays = 0;
  for (const auto& row : line.at("counts").get<std::vector<std::vector<std::uint64_t>>>()) {
    count_row of{};
    if (row.size() != of.size())
      refuse("its counts are those of another version of graze-fuzz");
    std::copy(row.begin(), row.end(), of.begin());
    p.by_generator.push_back(std::bit_cast<counts>(of));
    rays += p.by_generator.back().rays;
  }
  if (p.by_generator.size() != plan.generators.size() || rays != plan.rays_of(p.number))
    refuse("its counts are not of this plan");
  for (const json& of : line.at("findings")) {
    const auto kind = finding_of(of.at("kind").get<std::string>());
    if (!kind)
      refuse("it has a finding of another version of graze-fuzz");
    p.findings.push_back(
        {of.at("hash").get<std::string>(), *kind, of.at("ray").get<std::uint64_t>()});
  }
  return p;
}

/// Adds all whole lines; `whole` becomes their length in bytes. Empty, or what is wrong.
std::string read_progress(const std::string& path, const stored_plan& plan, campaign_state& state,
                          std::uint64_t& whole) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  whole = 0;
  if (!file && files::exists(path))
    return failed("read", path);
  for (std::size_t number = 1; std::getline(file, text) && !file.eof(); ++number) {
    whole += text.size() + 1;
    try {
      state.add(read_piece(text, plan));
    } catch (const json::parse_error&) {
      return fmt::format("{}:{}: not JSON", path, number);
    } catch (const std::exception& e) {
      return fmt::format("{}:{}: {}", path, number, e.what());
    }
  }
  return file.bad() ? failed("read", path) : std::string();
}

/// Why nothing can be started here: another's files are in it.
std::string refusal_of_folder(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : files::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    if (name != "lock" && name != "findings" && name != "plan.json.part")
      return fmt::format("{} has no plan.json and is not empty", folder);
  }
  return error ? fmt::format("cannot read {}: {}", folder, error.message()) : std::string();
}

} // namespace

std::uint64_t stored_plan::rays_of(std::uint64_t number) const {
  return rays == 0 ? piece : std::min(piece, rays - number * piece);
}

std::uint64_t stored_plan::shard_rays() const {
  if (rays == 0 || shard > pieces())
    return 0;
  const std::uint64_t mine = (pieces() - shard) / shards + 1;
  const bool has_last = (pieces() - 1) % shards == shard - 1;
  return mine * piece - (has_last ? piece - rays_of(pieces() - 1) : 0);
}

bool read_levels(std::string_view text, campaign_plan& plan) {
  const auto number = [&text](int& n) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc();
  };
  if (!number(plan.level))
    return false;
  plan.last_level = plan.level;
  if (text.starts_with('-')) {
    text.remove_prefix(1);
    if (!number(plan.last_level))
      return false;
  }
  return text.empty() && 1 <= plan.level && plan.level <= plan.last_level &&
         plan.last_level <= octree::max_level;
}

expected<campaign_plan> resolve(const stored_plan& stored) {
  campaign_plan plan;
  if (stored.external) {
    plan.owned = std::make_shared<const traversal_entry>(traversal_entry{
        stored.traversal, "a traversal in another process", nullptr, spelled(*stored.external)});
  } else {
    const auto entry = named_traversal(stored.traversal);
    if (!entry)
      return unexpected{entry.reason()};
    plan.owned = std::make_shared<const traversal_entry>(*entry);
  }
  plan.under_test = plan.owned.get();
  for (const std::string& name : stored.generators) {
    plan.generators.push_back(find_generator(name));
    if (plan.generators.back() == nullptr)
      return unexpected{fmt::format("no generator is called \"{}\" (see graze-fuzz list)", name)};
  }
  if (plan.generators.empty())
    return unexpected{"there is no generator"};
  const auto by = search_of(stored.search);
  if (!by)
    return unexpected{fmt::format("no search is called \"{}\"", stored.search)};
  plan.by = *by;
  if (!read_levels(stored.level, plan))
    return unexpected{
        fmt::format("level {} is outside 1..53 (a number, or a range A-B)", stored.level)};
  if (!std::isfinite(stored.seconds) || stored.seconds < 0)
    return unexpected{"--seconds is not a finite number of seconds, 0 or more"};
  if (stored.piece < 1 || stored.piece > 1'000'000'000)
    return unexpected{"--piece is outside 1..1000000000"};
  if (stored.shard < 1 || stored.shard > stored.shards)
    return unexpected{
        fmt::format("shard {}/{} is not i/N with 1 <= i <= N", stored.shard, stored.shards)};
  plan.seed = stored.seed;
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
    auto& known = findings.try_emplace(s.hash, known_finding{s.kind, s.ray, 0}).first->second;
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
    line["findings"].push_back({{"hash", s.hash}, {"kind", name_of(s.kind)}, {"ray", s.ray}});
  return line.dump();
}

std::string content_hash(std::string_view content) {
  std::string hash;
  const boost::uuids::name_generator_sha1 name_of_content{boost::uuids::uuid{}};
  for (const std::uint8_t byte : name_of_content(content.data(), content.size()))
    hash += fmt::format("{:02x}", byte);
  return hash;
}

finding_file file_of(finding kind, std::string_view traversal, const trial& shrunk) {
  json line{{"kind", name_of(kind)}, {"traversal", traversal}};
  line.update(json::parse(to_json_line(shrunk)));
  const std::string text = line.dump();
  return {content_hash(text), text};
}

std::string write_atomically(const std::string& path, std::string_view content) {
  const std::string part = path + ".part";
  {
    const descriptor d(::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (d.get() < 0)
      return failed("write", path);
    if (!write_all(d.get(), content) || fsync(d.get()) != 0) {
      const std::string why = failed("write", path);
      unlink(part.c_str());
      return why;
    }
  }
  if (std::rename(part.c_str(), path.c_str()) != 0) {
    const std::string why = failed("write", path);
    unlink(part.c_str());
    return why;
  }
  return sync_folder(files::path(path).parent_path()) ? std::string() : failed("sync", path);
}

expected<stored_plan> read_campaign(const std::string& folder, campaign_state& state) {
  const std::string path = folder + "/plan.json";
  if (!files::exists(path))
    return unexpected{
        fmt::format("{} is not the folder of a campaign: it has no plan.json", folder)};
  auto plan = read_plan(path);
  if (!plan)
    return plan;
  std::uint64_t whole = 0;
  if (std::string why = read_progress(folder + "/progress.jsonl", *plan, state, whole);
      !why.empty())
    return unexpected{std::move(why)};
  return plan;
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
  static const std::vector<std::string> members{"traversal", "external", "generators", "search",
                                                "level",     "seed",     "rays",       "piece"};
  return members;
}

campaign_store::campaign_store(campaign_store&& other) noexcept
    : folder_(std::move(other.folder_)), plan_(std::move(other.plan_)),
      state_(std::move(other.state_)), lock_(std::exchange(other.lock_, -1)),
      progress_(std::exchange(other.progress_, -1)), resumed_(other.resumed_) {}

campaign_store::~campaign_store() {
  for (const int fd : {progress_, lock_})
    if (fd >= 0)
      close(fd);
}

expected<campaign_store> campaign_store::open(const std::string& folder, stored_plan plan,
                                              const std::vector<std::string>& given) {
  campaign_store store;
  store.folder_ = folder;
  if (plan.generators.empty())
    for (const generator& g : generators())
      plan.generators.emplace_back(g.name);
  const std::string plan_path = folder + "/plan.json", progress_path = folder + "/progress.jsonl";
  const bool is_new = !files::exists(plan_path);
  if (is_new) {
    if (const auto resolved = resolve(plan); !resolved)
      return unexpected{resolved.reason()};
    if (mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
      return unexpected{failed("make", folder)};
    if (std::string why = refusal_of_folder(folder); !why.empty())
      return unexpected{std::move(why)};
  }
  // a record lock: it ends with the process, however that ends, and a child does not inherit it
  const std::string lock_path = folder + "/lock";
  store.lock_ = ::open(lock_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (store.lock_ < 0)
    return unexpected{failed("write", lock_path)};
  struct flock whole_file{};
  whole_file.l_type = F_WRLCK;
  whole_file.l_whence = SEEK_SET;
  if (fcntl(store.lock_, F_SETLK, &whole_file) != 0)
    return unexpected{errno == EACCES || errno == EAGAIN
                          ? fmt::format("{} is in use by another graze-fuzz", folder)
                          : failed("lock", lock_path)};

  if (!files::exists(plan_path)) {
    if (std::string why = write_atomically(plan_path, to_json(plan).dump(2) + "\n"); !why.empty())
      return unexpected{std::move(why)};
  }
  auto there = read_plan(plan_path);
  if (!there)
    return unexpected{there.reason()};
  if (const std::string other = difference(*there, plan, given); !other.empty())
    return unexpected{fmt::format("{} holds another plan: {}", folder, other)};
  store.plan_ = std::move(*there);
  store.state_.by_generator.resize(store.plan().generators.size());

  const std::string findings = folder + "/findings";
  if (mkdir(findings.c_str(), 0777) != 0 && errno != EEXIST)
    return unexpected{failed("make", findings)};
  std::error_code ignored;
  for (const auto& entry : files::directory_iterator(findings, ignored))
    if (entry.path().extension() == ".part") // of a start that was killed
      files::remove(entry.path(), ignored);

  std::uint64_t whole = 0;
  if (std::string why = read_progress(progress_path, store.plan(), store.state_, whole);
      !why.empty())
    return unexpected{std::move(why)};
  store.progress_ = ::open(progress_path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  // a line that was cut off must not become the beginning of the next
  if (store.progress_ < 0 || ftruncate(store.progress_, static_cast<off_t>(whole)) != 0 ||
      fsync(store.progress_) != 0 || !sync_folder(folder))
    return unexpected{failed("write", progress_path)};
  store.resumed_ = !store.state().finished.empty();
  return store;
}

std::string campaign_store::keep(const finding_file& f) const {
  const std::string path = fmt::format("{}/findings/{}.json", folder_, f.hash);
  // the name tells the content, and a file of that name is whole
  return files::exists(path) ? std::string() : write_atomically(path, f.line + "\n");
}

std::string campaign_store::append(const finished_piece& p) {
  if (!write_all(progress_, to_json_line(p) + "\n") || fsync(progress_) != 0)
    return failed("write", folder_ + "/progress.jsonl");
  state_.add(p);
  return {};
}

} // namespace graze::fuzz
