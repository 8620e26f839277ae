#include <graze/render/picture_texts.hpp>

#include <cstdint>
#include <graze/support/files.hpp>
#include <optional>

namespace graze::render {
namespace {

constexpr std::string_view exr_magic("\x76\x2f\x31\x01", 4), png_magic("\x89PNG\r\n\x1a\n", 8);

/// Takes what it is asked for from the front of bytes, or nothing where there is less.
class cutter {
public:
  explicit cutter(std::string_view bytes) : left_(bytes) {}

  std::optional<std::string_view> take(std::uint64_t count) {
    if (count > left_.size())
      return std::nullopt;
    const std::string_view part = left_.substr(0, count);
    left_.remove_prefix(count);
    return part;
  }
  /// Up to a zero byte, which is taken too.
  std::optional<std::string_view> take_name() {
    const auto end = left_.find('\0');
    if (end == std::string_view::npos)
      return std::nullopt;
    const auto name = take(end);
    left_.remove_prefix(1);
    return name;
  }
  enum class order { little, big };
  std::optional<std::uint32_t> take_number(order o) {
    const auto bytes = take(4);
    if (!bytes)
      return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<unsigned char>((*bytes)[o == order::big ? i : 3 - i]);
    return value;
  }

private:
  std::string_view left_;
};

const unexpected cut_off{"the picture's head is cut off, malformed or too long"};

/// A header: NAME 0 TYPE 0 size bytes, again and again, and an empty name (the OpenEXR file layout).
expected<picture_texts> texts_in_exr(cutter bytes) {
  picture_texts texts;
  if (!bytes.take(4)) // version and flags
    return cut_off;
  for (;;) {
    const auto name = bytes.take_name();
    if (!name)
      return cut_off;
    if (name->empty())
      return texts;
    const auto type = bytes.take_name();
    const auto size = type ? bytes.take_number(cutter::order::little) : std::nullopt;
    const auto value = size ? bytes.take(*size) : std::nullopt;
    if (!value)
      return cut_off;
    if (*type == "string")
      texts[std::string(*name)] = *value;
  }
}

/// Chunks: length, type, data, CRC (ISO 15948). Texts that a writer puts behind the pixels are not
/// ours.
expected<picture_texts> texts_in_png(cutter bytes) {
  picture_texts texts;
  for (;;) {
    const auto size = bytes.take_number(cutter::order::big);
    const auto type = size ? bytes.take(4) : std::nullopt;
    if (type && (*type == "IDAT" || *type == "IEND"))
      return texts;
    const auto data = type ? bytes.take(*size) : std::nullopt;
    if (!data || !bytes.take(4))
      return cut_off;
    const auto end = data->find('\0');
    if (*type == "tEXt" && end != std::string_view::npos)
      texts[std::string(data->substr(0, end))] = data->substr(end + 1);
  }
}

} // namespace

expected<picture_texts> texts_in(std::string_view head) {
  cutter bytes(head);
  if (head.starts_with(exr_magic))
    return bytes.take(exr_magic.size()), texts_in_exr(bytes);
  if (head.starts_with(png_magic))
    return bytes.take(png_magic.size()), texts_in_png(bytes);
  return unexpected{"neither a PNG nor an EXR picture"};
}

expected<picture_texts> texts_of_picture(const std::string& path) {
  auto file = support::input_file::open(path);
  if (!file)
    return unexpected{file.reason()};
  auto head = file->read(png_magic.size());
  if (head && texts_in(*head).reason() == cut_off.reason) { // it is a picture
    const auto more = file->read(longest_picture_head);
    if (!more)
      return unexpected{more.reason()};
    *head += *more;
  }
  if (!head)
    return unexpected{head.reason()};
  auto texts = texts_in(*head);
  if (!texts)
    return unexpected{support::in_quotes(path) + ": " + texts.reason()};
  return texts;
}

} // namespace graze::render
