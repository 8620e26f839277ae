#include <cstdio>
#include <cstdlib>
#include <external/libraries.hpp>
#include <external/maps.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <sstream>
#include <unistd.h>

namespace graze::fuzz {

namespace {

/// What a shell's command prints.
std::string output(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  if (pipe)
    for (int c = std::getc(pipe.get()); c != EOF; c = std::getc(pipe.get()))
      text += static_cast<char>(c);
  return text;
}

/// By the names of their programs, as CMake has them on its list.
std::vector<std::string> library_names() {
  std::istringstream names(GRAZE_PEER_LIBRARIES);
  return {std::istream_iterator<std::string>(names), {}};
}

/// Those of one library; none where its program is not there.
std::vector<traversal_entry> variants(const std::string& library, const external_options& like) {
  std::vector<traversal_entry> found;
  const std::string program = folder_of_adapters() + "/graze-adapter-" + library;
  if (access(program.c_str(), X_OK) != 0)
    return found;
  std::istringstream lines(
      output(shell_word(program) + (like.map ? " --map-variants" : " --variants")));
  for (std::string name, promised, summary; std::getline(lines, name, '\t') &&
                                            std::getline(lines, promised, '\t') &&
                                            std::getline(lines, summary);) {
    const auto parsed = promise_of(promised);
    if (!parsed) {
      fmt::print(stderr, "{}: no promise is called \"{}\"\n", name, promised);
      continue;
    }
    external_options options = like;
    options.command = shell_word(program) + " " + shell_word(name);
    if (like.map) {
      const map_file& file = like.map->file();
      options.command = fmt::format("{} --scene {}{} {}", shell_word(program),
                                    shell_word(whole_path(file)), adapter_options(file), name);
      options.cells = cell_kind::grid;
    }
    options.promised = parsed;
    options.format = line_format::plain;
    // they start in some 50 ms, and read the map twice
    options.start_seconds = 1 + (like.map ? 10 * like.map->read_seconds : 0);
    found.push_back(untried_external_traversal(options, name, summary));
  }
  return found;
}

} // namespace

std::string folder_of_adapters() {
  if (const char* named = std::getenv("GRAZE_ADAPTERS"); named != nullptr && *named != '\0')
    return named;
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::vector<traversal_entry> library_traversals(const external_options& like) {
  std::vector<traversal_entry> all;
  for (const std::string& library : library_names()) {
    const std::vector<traversal_entry> found = variants(library, like);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

expected<traversal_entry> named_traversal(const std::string& name, const external_options& like) {
  if (const traversal_entry* entry = find_traversal(name))
    return *entry;
  if (like.map) {
    const auto reader = map_reader_of(like.map->file().path);
    if (!reader)
      return unexpected{reader.reason()};
    for (const traversal_entry& entry : variants(reader->library, like))
      if (entry.name == name)
        return entry;
    return unexpected{fmt::format("\"{}\" builds from no map such as {}: traversals of {} do, and "
                                  "your own command",
                                  name, like.map->file().path, reader->library)};
  }
  for (const std::string& library : library_names())
    if (name == library || name.starts_with(library + "-"))
      for (const traversal_entry& entry : variants(library, like))
        if (entry.name == name)
          return entry;
  return unexpected{fmt::format("no traversal is called \"{}\" (see graze-fuzz list)", name)};
}

} // namespace graze::fuzz
