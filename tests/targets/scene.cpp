/// Scene files: any text is refused with a reason on one line, or is a scene that is written so that
/// it reads back.
#include "target.hpp"
#include <graze/render/scene_text.hpp>

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto s = render::scene_from(fuzz::target::text_of({data, size}));
  if (!s) {
    fuzz::target::require(!s.reason().empty(), "refused without a reason");
    return 0;
  }
  const std::string text = render::text_of(*s);
  const auto again = render::scene_from(text);
  fuzz::target::require(again && render::text_of(*again) == text,
                        "does not read back what it wrote");
  return 0;
}

std::vector<std::string> fuzz::target::seeds() {
  std::vector<std::string> all{
      R"({"surface":"spheres","material":{"body":[1,0.5,0]},"lights":[],"background":[0,0,0]})",
      R"({"formula":"x^2+y^2+z^2-1","domain":[-2,2],"camera":{"scale":0.5,"at":[0,0,1]}})",
      R"({"objects":[{"name":"a","formula":"x"},{"name":"b","formula":"y-z^3","reflection":0.5}],)"
      R"("solid":{"difference":["a",{"union":["a","b"]}]},"domain":[-1,1,-1,1,-1,1],)"
      R"("camera":{"eye":[3,2,6],"centre":[-3,-2,-6],"right":[3.5,0,-1.75],"up":[-0.5,3.75,-1]},)"
      R"("lights":[{"position":[10,12,4],"intensity":0.8}]})",
      R"({"formula":"w=a;x²-w = |b|;","set":{"a":0.3,"b":"1/3"},"domain":[-1,1]})",
      R"({"name":"n","surface":"holesrot","domain":[-1e99,1]})",
      "[",
      "{}",
      "null",
      R"({"formula":7})"};
  for (const render::scene& s : render::scenes())
    all.push_back(render::text_of(s));
  return all;
}
