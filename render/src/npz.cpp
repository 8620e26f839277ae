// NumPy's arrays (NEP 1, format 1.0) in a ZIP file by minizip.
#include <graze/render/arrays.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <minizip/zip.h>
#include <new>
#include <string_view>
#include <zlib.h>

namespace graze::render {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie");

/// A file in memory, for minizip.
class memory_file {
public:
  zlib_filefunc64_def functions() {
    zlib_filefunc64_def all{};
    all.opaque = this;
    all.zopen64_file = [](voidpf self, const void*, int) { return self; };
    all.zread_file = [](voidpf self, voidpf, void* to, uLong count) -> uLong {
      memory_file& file = of(self);
      const std::size_t most = std::min<std::size_t>(count, file.bytes_.size() - file.at_);
      std::memcpy(to, file.bytes_.data() + file.at_, most);
      file.at_ += most;
      return most;
    };
    all.zwrite_file = [](voidpf self, voidpf, const void* from, uLong count) -> uLong {
      return of(self).write(static_cast<const unsigned char*>(from), count);
    };
    all.ztell64_file = [](voidpf self, voidpf) -> ZPOS64_T { return of(self).at_; };
    all.zseek64_file = [](voidpf self, voidpf, ZPOS64_T offset, int origin) -> long {
      memory_file& file = of(self);
      const std::size_t base = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                               : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.at_
                                                                  : file.bytes_.size();
      if (base + offset > file.bytes_.size())
        return -1;
      file.at_ = base + offset;
      return 0;
    };
    all.zclose_file = [](voidpf, voidpf) { return 0; };
    all.zerror_file = [](voidpf, voidpf) { return 0; };
    return all;
  }
  [[nodiscard]] bool short_of_memory() const { return short_of_memory_; }
  std::vector<unsigned char> take() { return std::move(bytes_); }

private:
  static memory_file& of(voidpf self) { return *static_cast<memory_file*>(self); }
  uLong write(const unsigned char* from, std::size_t count) {
    try {
      const std::size_t end = std::max(bytes_.size(), at_ + count);
      if (end > bytes_.capacity())
        bytes_.reserve(std::max(end, 2 * bytes_.capacity()));
      bytes_.resize(end);
    } catch (const std::bad_alloc&) { // thrown again where no function of C is in between
      short_of_memory_ = true;
      return 0;
    }
    std::memcpy(bytes_.data() + at_, from, count);
    at_ += count;
    return count;
  }
  std::vector<unsigned char> bytes_;
  std::size_t at_ = 0;
  bool short_of_memory_ = false;
};

std::string header(std::string_view type, const std::string& shape) {
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  constexpr std::size_t before = 10, alignment = 64;
  text.append(alignment - 1 - (before + text.size()) % alignment, ' ');
  text += '\n';
  std::string whole("\x93NUMPY\x01\x00", 8);
  whole += static_cast<char>(text.size() & 255);
  whole += static_cast<char>(text.size() >> 8);
  return whole + text;
}

class npz_writer {
public:
  npz_writer() {
    zlib_filefunc64_def functions = memory_.functions();
    zip_ = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
  }
  ~npz_writer() {
    if (zip_ != nullptr)
      zipClose(zip_, nullptr);
  }
  npz_writer(const npz_writer&) = delete;
  npz_writer& operator=(const npz_writer&) = delete;

  void add(const std::string& name, std::string_view type, const std::string& shape,
           std::string_view bytes) {
    constexpr int zip64 = 1, fast = 1;
    const zip_fileinfo no_date{{0, 0, 0, 1, 0, 1980}, 0, 0, 0};
    whole_ = whole_ && zip_ != nullptr &&
             zipOpenNewFileInZip64(zip_, (name + ".npy").c_str(), &no_date, nullptr, 0, nullptr, 0,
                                   nullptr, Z_DEFLATED, fast, zip64) == ZIP_OK;
    write(header(type, shape));
    write(bytes);
    whole_ = whole_ && zipCloseFileInZip(zip_) == ZIP_OK;
  }
  /// `value_of(i)` for every i below `count`.
  template <class T, class Value>
  void add_values(const std::string& name, std::string_view type, const std::string& shape,
                  std::size_t count, const Value& value_of) {
    std::vector<T> values(count);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = value_of(i);
    add(name, type, shape, {reinterpret_cast<const char*>(values.data()), count * sizeof(T)});
  }

  expected<std::vector<unsigned char>> finish() {
    whole_ = zipClose(std::exchange(zip_, nullptr), nullptr) == ZIP_OK && whole_;
    if (memory_.short_of_memory())
      throw std::bad_alloc();
    if (!whole_)
      return unexpected{"cannot encode as NPZ: minizip refuses"};
    return memory_.take();
  }

private:
  void write(std::string_view bytes) {
    constexpr std::size_t most = std::size_t{1} << 30; // zlib counts in 32 bits
    for (; whole_ && !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size())))
      whole_ = zipWriteInFileInZip(zip_, bytes.data(),
                                   static_cast<unsigned>(std::min(most, bytes.size()))) == ZIP_OK;
  }

  memory_file memory_;
  zipFile zip_ = nullptr;
  bool whole_ = true;
};

} // namespace

expected<std::vector<unsigned char>>
encode_npz(const rendering& result, const std::vector<std::pair<std::string, std::string>>& texts) {
  const std::size_t count = result.facts.size();
  if (count == 0 || count != result.part.size.count())
    return unexpected{"a rendering without facts"};
  const std::string plane = fmt::format("{}, {}", result.part.size.height, result.part.size.width),
                    space = plane + ", 3";
  npz_writer npz;
  const auto& all = result.facts;
  npz.add_values<std::int8_t>("verdict", "|i1", plane, count, [&](std::size_t i) {
    return static_cast<std::int8_t>(all[i].verdict);
  });
  npz.add_values<std::int32_t>("object", "<i4", plane, count,
                               [&](std::size_t i) { return all[i].object; });
  const auto add_number = [&](const char* name, double proof::* of) {
    npz.add_values<double>(name, "<f8", plane, count,
                           [&](std::size_t i) { return all[i].proven.*of; });
  };
  add_number("depth_lower", &proof::depth_lower);
  add_number("depth_upper", &proof::depth_upper);
  const auto add_vector = [&](const char* name, octree::box proof::* of,
                              vec3 octree::box::* bound) {
    npz.add_values<double>(name, "<f8", space, 3 * count,
                           [&](std::size_t i) { return (all[i / 3].proven.*of.*bound)[i % 3]; });
  };
  npz.add_values<double>("eye", "<f8", "3,", 3, [&](std::size_t i) { return result.eye[i]; });
  npz.add_values<double>("direction", "<f8", space, 3 * count,
                         [&](std::size_t i) { return all[i / 3].direction[i % 3]; });
  add_vector("point_lower", &proof::point, &octree::box::lo);
  add_vector("point_upper", &proof::point, &octree::box::hi);
  add_vector("normal_lower", &proof::normal, &octree::box::lo);
  add_vector("normal_upper", &proof::normal, &octree::box::hi);
  for (const auto& [name, text] : texts)
    npz.add(name.starts_with("graze:") ? name.substr(6) : name,
            fmt::format("|S{}", std::max<std::size_t>(text.size(), 1)), "",
            text.empty() ? std::string_view("\0", 1) : std::string_view(text));
  return npz.finish();
}

} // namespace graze::render
