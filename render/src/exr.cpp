// EXR pictures are written by a plug-in, which is loaded here.
#include "encoders.hpp"
#include "exr_plugin.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fmt/format.h>
#include <graze/rounding/environment.hpp>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <latch>
#include <sys/mman.h>
#include <system_error>
#include <thread>

namespace graze::render {
namespace {

/// Whether the libraries get at their loading what they abort without. Measured with Debian 12: 4
/// threads (log4cplus), 470 MB of addresses, 100 of them for data (what `ulimit -d` limits); writing
/// takes a thread a core, once the loaded have theirs.
support::status room_for_libraries() {
  const unsigned wanted = 4 + std::max(1u, std::thread::hardware_concurrency());
  constexpr std::size_t addresses = std::size_t{640} << 20, data = std::size_t{160} << 20;
  const auto refused = [](const char* what, const std::string& why) {
    return unexpected{fmt::format(
        "an EXR picture needs OpenImageIO, whose libraries need more {}: {} (PNG needs none)", what,
        why)};
  };
  std::latch end(1);
  std::vector<std::jthread> threads;
  std::string why;
  try {
    for (unsigned i = 0; i < wanted; ++i)
      threads.emplace_back([&end] { end.wait(); });
  } catch (const std::system_error& e) {
    why = e.code().message();
  }
  const auto there_is = [](std::size_t bytes, int protection) {
    void* const place =
        mmap(nullptr, bytes, protection, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return place != MAP_FAILED && munmap(place, bytes) == 0;
  };
  const bool roomy = there_is(addresses, PROT_NONE) && there_is(data, PROT_READ | PROT_WRITE);
  end.count_down();
  if (!why.empty())
    return refused("threads",
                   fmt::format("{} of {} could be started, {}", threads.size(), wanted, why));
  if (!roomy)
    return refused("memory", fmt::format("{} MB of addresses, {} of them for data", addresses >> 20,
                                         data >> 20));
  return {};
}

/// Beside the program, or where it is installed.
expected<std::string> find_plugin() {
  std::error_code error;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (folder.empty())
    return unexpected{"cannot tell where the program and its plug-in are: /proc is missing"};
  const std::string beside = folder / exr_plugin_file,
                    installed = (folder / GRAZE_PLUGINS / exr_plugin_file).lexically_normal();
  for (const std::string& file : {beside, installed})
    if (support::is_there(file))
      return file;
  return unexpected{
      fmt::format("an EXR picture needs the plug-in {}, which is neither {} nor {} (PNG "
                  "needs none)",
                  exr_plugin_file, support::in_quotes(beside), support::in_quotes(installed))};
}

expected<const exr_plugin*> load() {
  const auto file = find_plugin();
  if (!file)
    return unexpected{file.reason()};
  if (const support::status room = room_for_libraries(); !room)
    return unexpected{room.reason()};
  // OpenBLAS, which comes along and is not used, starts a thread a core where it may
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  const auto refused = [&](std::string_view why) {
    return unexpected{
        fmt::format("cannot load {}: {}", support::in_quotes(*file), support::shown(why, 300))};
  };
  const auto why = [] {
    const char* const text = dlerror();
    return text != nullptr ? text : "unknown reason";
  };
  void* const library = dlopen(file->c_str(), RTLD_LAZY | RTLD_LOCAL);
  rounding::set_default_environment(); // which a library's initialisers may have changed
  if (library == nullptr)
    return refused(why());
  const auto* const found = static_cast<const exr_plugin*>(dlsym(library, exr_plugin_symbol));
  if (found == nullptr)
    return refused(why());
  if (std::strcmp(found->version, GRAZE_VERSION) != 0)
    return refused(fmt::format("it is of Graze {}, this is {}", found->version, GRAZE_VERSION));
  return found;
}

const expected<const exr_plugin*>& loaded() {
  static const auto once = load(); // and never unloaded: its libraries keep threads
  return once;
}

} // namespace

support::status load_exr_encoder() {
  if (!loaded())
    return unexpected{loaded().reason()};
  return {};
}

expected<std::vector<unsigned char>> encode_exr(const picture& image) {
  if (!loaded())
    return unexpected{loaded().reason()};
  return (*loaded())->encode(image);
}

} // namespace graze::render
