#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <external/external.hpp>
#include <external/libraries.hpp>
#include <external/maps.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/wait.h>
#include <trial/replay_line.hpp>
#include <unistd.h>

namespace graze::fuzz {

namespace {

using json = nlohmann::json;

/// "bt:octomap:liboctomap-dev" and so on, by CMake's list.
const std::vector<std::pair<std::string, map_reader>>& readers() {
  static const auto all = [] {
    std::vector<std::pair<std::string, map_reader>> list;
    std::istringstream words(GRAZE_MAP_READERS);
    for (std::string extension, library, package; std::getline(words >> std::ws, extension, ':') &&
                                                  std::getline(words, library, ':') &&
                                                  words >> package;)
      list.push_back({extension, {library, package}});
    return list;
  }();
  return all;
}

/// Standard output of a program, which may be large.
class program_output {
public:
  explicit program_output(const std::string& command) : pipe_(popen(command.c_str(), "r")) {}
  ~program_output() { end(); }
  program_output(const program_output&) = delete;
  program_output& operator=(const program_output&) = delete;

  /// Up to a line's end, which is taken off.
  std::string line(std::size_t longest) {
    std::string text;
    if (pipe_ != nullptr)
      for (int c = std::getc(pipe_); c != EOF && c != '\n' && text.size() < longest;
           c = std::getc(pipe_))
        text += static_cast<char>(c);
    return text;
  }
  std::size_t bytes(void* to, std::size_t most) {
    return pipe_ == nullptr ? 0 : std::fread(to, 1, most, pipe_);
  }
  /// As wait() has it.
  int end() {
    if (pipe_ != nullptr)
      status_ = pclose(pipe_);
    pipe_ = nullptr;
    return status_;
  }

private:
  FILE* pipe_;
  int status_ = -1;
};

std::string counted(const json& header) {
  if (header.at("ambiguous").is_null())
    return "the library has no index of a point";
  std::string text = fmt::format(
      "{} of {} voxels are ambiguous: a face's own coordinate has another index",
      header.at("ambiguous").get<std::uint64_t>(), header.at("voxels").get<std::uint64_t>());
  if (!header.at("ambiguous_voxels").empty())
    text += fmt::format(", such as {}", header.at("ambiguous_voxels").front().dump());
  return text;
}

expected<std::shared_ptr<const voxel_map>> map_from(const map_file& file, program_output& from,
                                                    const std::string& line, double seconds) {
  const json header = json::parse(line, nullptr, false);
  if (!header.is_object())
    return unexpected{support::shown(line, 400)};
  try {
    const auto grid = grid_from_text(header.at("grid").dump());
    if (!grid)
      return unexpected{fmt::format("{}: {}", support::shown(file.path), grid.reason())};
    const auto number = header.at("voxels").get<std::uint64_t>();
    if (number > most_map_voxels)
      return unexpected{
          fmt::format("{}: more than 2^26 voxels are occupied", support::shown(file.path))};
    std::vector<voxel_index> voxels(number);
    static_assert(sizeof(voxel_index) == 12 && std::endian::native == std::endian::little);
    char more = 0;
    const std::size_t bytes = number * sizeof(voxel_index);
    if (from.bytes(voxels.data(), bytes) != bytes || from.bytes(&more, 1) != 0)
      return unexpected{fmt::format("{}: the voxels are not as many as the adapter says",
                                    support::shown(file.path))};
    auto map = voxel_map::make(file, std::make_shared<const grid_planes>(*grid), voxels);
    if (!map)
      return map;
    auto told = std::make_shared<voxel_map>(**map);
    told->first = header.at("first").get<std::array<std::int64_t, 3>>();
    told->read_seconds = seconds;
    told->about =
        fmt::format("{} voxels by {}: {}; {}", number, header.at("library").get<std::string>(),
                    header.at("rule").get<std::string>(), counted(header));
    return std::shared_ptr<const voxel_map>(told);
  } catch (const json::exception& e) {
    return unexpected{fmt::format("what the adapter says of {} is not understood: {}",
                                  support::shown(file.path), e.what())};
  }
}

} // namespace

expected<map_reader> map_reader_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string known;
  for (const auto& [name, reader] : readers()) {
    if (extension == "." + name)
      return reader;
    known += fmt::format("{}.{}", known.empty() ? "" : " ", name);
  }
  return unexpected{fmt::format("{} is no map by its name: {}", support::shown(path), known)};
}

std::string adapter_options(const map_file& file) {
  std::string text;
  if (file.voxel_size != 0)
    text += fmt::format(" --voxel-size {}", file.voxel_size);
  if (file.cell_centred)
    text += " --cell-centred";
  return text;
}

std::string whole_path(const map_file& file) {
  std::error_code error;
  const auto path = std::filesystem::absolute(file.path, error);
  return error ? file.path : path.lexically_normal().string();
}

expected<std::shared_ptr<const voxel_map>> read_map(const map_file& file) {
  if (support::utf8(file.path) != file.path)
    return unexpected{fmt::format("the path {} is not UTF-8", support::shown(file.path))};
  const auto reader = map_reader_of(file.path);
  if (!reader)
    return unexpected{reader.reason()};
  const std::string name = "graze-adapter-" + reader->library;
  const std::string program = folder_of_adapters() + "/" + name;
  if (access(program.c_str(), X_OK) != 0)
    return unexpected{fmt::format("{} is read by {}, which is not there: it is built where {} is "
                                  "installed",
                                  support::shown(file.path), name, reader->package)};
  program_output from(fmt::format("exec {} --voxels {}{} 2>&1", shell_word(program),
                                  shell_word(file.path), adapter_options(file)));
  const auto start = std::chrono::steady_clock::now();
  const std::string line = from.line(longest_map_header);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  expected<std::shared_ptr<const voxel_map>> map = unexpected{std::string()};
  if (line.starts_with('{'))
    map = map_from(file, from, line, seconds);
  const int status = from.end();
  if (status != -1 && WIFSIGNALED(status))
    return unexpected{
        fmt::format("{} ended by signal {} on {}: the file is damaged, or the library "
                    "fails on it",
                    name, WTERMSIG(status), support::shown(file.path))};
  if (!line.starts_with('{'))
    return unexpected{line.empty() ? fmt::format("{} says nothing of {}", name, file.path)
                                   : support::shown(line, 400)};
  return map;
}

expected<std::shared_ptr<const voxel_map>> known_map(const map_file& file) {
  static std::mutex one_at_a_time;
  static std::vector<std::pair<map_file, std::shared_ptr<const voxel_map>>> known;
  const std::lock_guard lock(one_at_a_time);
  for (const auto& [other, map] : known)
    if (other == file)
      return map;
  auto map = read_map(file);
  if (map)
    known.emplace_back(file, *map);
  return map;
}

} // namespace graze::fuzz
