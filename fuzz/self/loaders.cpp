/// The subject `loaders`: octree files and replay lines from damaged bytes.
#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <generate/generators.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <self/loaders.hpp>
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <self/damage.hpp>

namespace graze::fuzz::self {

guarded_memory::guarded_memory(std::size_t most) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  size_ = (most + page - 1) / page * page;
  void* at =
      mmap(nullptr, size_ + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (at == MAP_FAILED)
    throw std::bad_alloc();
  at_ = static_cast<unsigned char*>(at);
  mprotect(at_ + size_, page, PROT_NONE);
}
guarded_memory::~guarded_memory() {
  munmap(at_, size_ + static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}
std::span<const unsigned char> guarded_memory::copy(std::span<const unsigned char> bytes) {
  unsigned char* const to = at_ + size_ - bytes.size();
  std::copy(bytes.begin(), bytes.end(), to);
  return {to, bytes.size()};
}

namespace {

using bytes = std::vector<unsigned char>;
constexpr std::size_t most_bytes = 1 << 18;

/// Valid files: octrees of a few levels and shapes, an empty one among them.
const std::vector<bytes>& valid_files() {
  static const std::vector<bytes> files = [] {
    using namespace octree;
    std::vector<bytes> all;
    const auto add = [&all](const auto& surface, const box& domain, int level,
                            const std::string& description) {
      if (const auto tree = voxelize(surface, domain, level))
        if (auto file = encode_octree(*tree, description))
          all.push_back(*std::move(file));
    };
    add(quartdef{}, {{-1.5, -1.5, -1.5}, {1.5, 1.5, 0}}, 3, "quartdef");
    add(quartdef{}, {{-1.5, -1.5, -1.5}, {1.5, 1.5, 0}}, 1, "");
    add(quartdef{}, {{4, 4, 4}, {5, 5, 5}}, 2, "nothing");
    add(holesrot{}, {{-2, -2, -2}, {2, 2, 2}}, 2, "a description of some length");
    add(spheres{}, {{0, 0, 0}, {0.5, 1, 1}}, 4, "spheres");
    return all;
  }();
  return files;
}

void sign(bytes& b) {
  if (b.size() < 4)
    return;
  const auto sum = static_cast<std::uint32_t>(crc32_z(0, b.data(), b.size() - 4));
  for (unsigned i = 0; i < 4; ++i)
    b[b.size() - 4 + i] = static_cast<unsigned char>(sum >> (8 * i));
}

bool is_one_line(const std::string& reason) {
  return !reason.empty() && reason.find('\n') == std::string::npos;
}

void refused(const std::string& reason, bool valid, observations& out) {
  if (valid)
    out.push_back({flaw::meaning, "valid input is refused: " + reason});
  if (!is_one_line(reason))
    out.push_back({flaw::no_reason, fmt::format("refused with the reason \"{}\"", reason)});
}

/// Lines of the ray campaign's trials, some with an extent.
std::string valid_line(std::uint64_t seed, std::uint64_t index) {
  const auto& all = generators();
  return to_json_line(make_trial(all[index % all.size()], seed, index,
                                 1 + static_cast<int>(oracle::mix(index) % 50)));
}

/// The number that a line gives for a member, by strtod; NaN where it gives none.
double number_in(const nlohmann::json& value) {
  if (value.is_number())
    return value.get<double>();
  return value.is_string() ? std::strtod(value.get_ref<const std::string&>().c_str(), nullptr)
                           : std::numeric_limits<double>::quiet_NaN();
}
bool is_vector(const nlohmann::json& line, const vec3& v) {
  for (unsigned a = 0; a < 3; ++a)
    if (number_in(line.at(a)) != v[a])
      return false;
  return true;
}
/// Does the accepted trial hold the numbers of its line?
bool holds_numbers_of(std::string_view text, const trial& t) {
  const auto line = nlohmann::json::parse(text);
  const auto& octant = line.at("octant");
  if (!is_vector(line.at("origin"), t.origin) || !is_vector(line.at("direction"), t.direction) ||
      !is_vector(octant.at("lo"), t.octant(0).lo) || number_in(octant.at("size")) != t.size())
    return false;
  if (!line.contains("root"))
    return t.root == cube{{0, 0, 0}, 1};
  return is_vector(line.at("root").at("lo"), t.root.lo) &&
         number_in(line.at("root").at("size")) == t.root.size;
}

std::string_view as_text(std::span<const unsigned char> b) {
  return {reinterpret_cast<const char*>(b.data()), b.size()};
}
std::span<const unsigned char> as_bytes_of(const std::string& s) {
  return {reinterpret_cast<const unsigned char*>(s.data()), s.size()};
}

} // namespace

part octree_file_loader(std::string name, bool sign_again, octree_decoder under_test) {
  return {std::move(name), [sign_again, decode = std::move(under_test),
                            memory = std::make_shared<guarded_memory>(most_bytes)](
                               std::uint64_t seed, std::uint64_t index, observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            const auto& files = valid_files();
            const bytes& source = files[random() % files.size()];
            bytes b = source;
            damage d{"", true};
            if (random() % 32 != 0)
              d = damaged(b, files[random() % files.size()], random);
            if (sign_again)
              sign(b);
            const auto r = decode(memory->copy(b));
            const std::size_t first = out.size();
            if (!r) {
              refused(r.reason(), b == source, out);
            } else if (const auto again = encode_octree(r->octree, r->description);
                       !again || *again != b) {
              out.push_back({flaw::accepted, "accepted, but it is not how this octree is written"});
            } else if (!sign_again && d.within_32_bits && b != source) {
              out.push_back({flaw::accepted, "accepted, though its checksum is wrong"});
            }
            for (std::size_t i = first; i < out.size(); ++i)
              out[i].what += " (" + std::to_string(b.size()) + " bytes:" + d.what + ")";
          }};
}

part replay_line_loader(std::string name, line_decoder under_test) {
  return {std::move(name),
          [decode = std::move(under_test), memory = std::make_shared<guarded_memory>(most_bytes)](
              std::uint64_t seed, std::uint64_t index, observations& out) {
            oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
            const std::string source = valid_line(seed, index);
            std::string line = source;
            if (random() % 32 != 0)
              damaged(line, valid_line(seed, random() % 1000), random);
            const auto text = as_text(memory->copy(as_bytes_of(line)));
            const auto r = decode(text);
            const std::size_t first = out.size();
            if (!r)
              refused(r.reason(), line == source, out);
            else if (!judgeable(*r))
              out.push_back({flaw::accepted,
                             "accepted, though it cannot be judged: " + judgeable(*r).reason()});
            else if (!holds_numbers_of(text, *r))
              out.push_back({flaw::meaning, "other numbers than the line's: " + to_json_line(*r)});
            else if (const auto again = from_json_line(to_json_line(*r)); !again || *again != *r)
              out.push_back({flaw::meaning, "not the same again: " + to_json_line(*r)});
            for (std::size_t i = first; i < out.size(); ++i)
              out[i].what += " (the line: " + line + ")";
          }};
}

namespace {

/// Files of a few lines, one of them damaged: refused iff the line is, with its number.
void replay_file(std::uint64_t seed, std::uint64_t index, observations& out) {
  oracle::random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
  static const int file = memfd_create("replay", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  const std::size_t count = 1 + random() % 4, damaged_line = random() % count;
  std::string text;
  std::string wrong;
  std::size_t wrong_number = 0, lines = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::string line = valid_line(seed, random() % 1000);
    if (i == damaged_line)
      damaged(line, valid_line(seed, random() % 1000), random);
    line += '\n';
    text += line;
    // damage may make a line two, or none
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end = line.find('\n', at);
      const std::string_view part(line.data() + at, end - at);
      ++lines;
      if (wrong.empty() && part.find_first_not_of(" \t\r") != std::string_view::npos)
        if (const auto r = from_json_line(part); !r)
          wrong = r.reason(), wrong_number = lines;
      at = end + 1;
    }
  }
  if (ftruncate(file, 0) != 0 || pwrite(file, text.data(), text.size(), 0) < 0)
    throw std::bad_alloc();
  const auto r = read_replay_file(path);
  if (r && !wrong.empty())
    out.push_back({flaw::accepted, "accepted, though a line is wrong: " + wrong});
  if (!r)
    refused(r.reason(), wrong.empty() && text.find_first_not_of(" \t\r\n") != std::string::npos,
            out);
  if (!r && !wrong.empty() && r.reason() != fmt::format("{}:{}: {}", path, wrong_number, wrong))
    out.push_back({flaw::no_reason, "refused with another reason: " + r.reason()});
}

} // namespace

subject loaders_subject() {
  return {"loaders",
          "Octree files and replay files from damaged bytes",
          {octree_file_loader("octree file", false, octree::decode_octree),
           octree_file_loader("octree file, signed", true, octree::decode_octree),
           replay_line_loader("replay line",
                              [](std::string_view line) { return from_json_line(line); }),
           part{"replay file", replay_file}}};
}

} // namespace graze::fuzz::self
