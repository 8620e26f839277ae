/// The settings that a picture tells of itself (--again): any text is refused with a reason, or gives
/// settings that can be rendered and read back.
#include "target.hpp"
#include <request.hpp>

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto settings = render::picture_settings::parse(fuzz::target::text_of({data, size}));
  if (!settings) {
    fuzz::target::require(!settings.reason().empty(), "refused without a reason");
    return 0;
  }
  fuzz::target::require(static_cast<bool>(settings->check()), "took settings of no picture");
  const auto again = render::picture_settings::parse(settings->text());
  fuzz::target::require(again && again->text() == settings->text(),
                        "does not read back what it wrote");
  return 0;
}

std::vector<std::string> fuzz::target::seeds() {
  render::picture_settings cut;
  cut.crop = render::window{1, 2, {3, 4}};
  return {render::picture_settings{}.text(),
          cut.text(),
          R"({"mode":"trace","levels":12,"octree_level":9,"size":[640,480],"spp":4})",
          R"({"mode":"cast","levels":1e300,"octree_level":9.5,"size":[4294967297,-1],"spp":null})",
          "{}",
          "[]"};
}
