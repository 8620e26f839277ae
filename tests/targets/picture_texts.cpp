/// The heads of EXR and PNG files (--again): any bytes are refused with a reason, or give texts that are
/// part of them.
#include "target.hpp"
#include <graze/render/picture_texts.hpp>

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::target::text_of({data, size});
  const auto texts = render::texts_in(bytes);
  if (!texts) {
    fuzz::target::require(!texts.reason().empty(), "refused without a reason");
    return 0;
  }
  for (const auto& [name, text] : *texts)
    fuzz::target::require(bytes.find(name) != std::string::npos &&
                              bytes.find(text) != std::string::npos,
                          "a text that is not in the file");
  return 0;
}

std::vector<std::string> fuzz::target::seeds() {
  const auto little = [](std::size_t n) {
    std::string bytes;
    for (int i = 0; i < 4; ++i)
      bytes += static_cast<char>(n >> (8 * i) & 255);
    return bytes;
  };
  const auto attribute = [&](const std::string& name, const std::string& type,
                             const std::string& value) {
    return name + '\0' + type + '\0' + little(value.size()) + value;
  };
  const std::string nul(1, '\0'), magic = "\x76\x2f\x31\x01" + little(2);
  const std::string exr = magic + attribute("channels", "chlist", std::string(18, 'c')) +
                          attribute("graze:scene", "string", R"({"surface":"spheres"})") +
                          attribute("graze:settings", "string", "{}") + nul + "pixels";
  const auto chunk = [&](const std::string& type, const std::string& data) {
    std::string size = little(data.size());
    return std::string(size.rbegin(), size.rend()) + type + data + "crc.";
  };
  const std::string png = "\x89PNG\r\n\x1a\n" + chunk("IHDR", std::string(13, '\1')) +
                          chunk("tEXt", "graze:scene" + nul + "{}") +
                          chunk("tEXt", "Software" + nul + "graze") + chunk("IDAT", "pixels") +
                          chunk("IEND", "");
  return {exr, png, magic, magic + nul, png.substr(0, 8), "GIF89a"};
}
