/// graze-adapter-NAME VARIANT: a library asked by graze-fuzz, ray by ray; it is built from the block of
/// each request anew. graze-adapter-NAME --variants tells what there is: name, promise and summary, with
/// tabs between them.
#include <adapters/adapter.hpp>
#include <peers/library.hpp>
#include <string_view>

namespace {

using namespace graze;

void answer_request(const peers::variant& asked, const adapter::request& r, adapter::answer& a) {
  const auto ray = octree::ray::make(r.origin, adapter::scaled(r.direction));
  peers::occupied_octants block{{r.lo, r.size}, r.level, r.base, {}};
  for (const adapter::index3& v : r.voxels())
    block.indices.push_back({static_cast<std::uint32_t>(v[0] - r.base[0]),
                             static_cast<std::uint32_t>(v[1] - r.base[1]),
                             static_cast<std::uint32_t>(v[2] - r.base[2])});
  const auto library = ray ? asked.build(block) : nullptr;
  const auto received = library ? library->received(*ray) : std::nullopt;
  if (!received)
    return a.skip();
  a.received(received->origin(), received->direction());
  std::vector<peers::octant_key> found;
  library->visit(*ray, found);
  for (const peers::octant_key key : found) {
    const peers::octant_index at = peers::index_of(key);
    a.visit({r.base[0] + at[0], r.base[1] + at[1], r.base[2] + at[2]});
  }
}

} // namespace

int main(int argc, char** argv) {
  const peers::library& library = peers::libraries().front();
  const std::string_view asked = argc > 1 ? argv[1] : "";
  for (const peers::variant& v : library.variants) {
    if (asked == "--variants")
      std::printf("%s\t%s\t%s\n", v.name, v.promise, v.summary);
    if (asked == v.name)
      return adapter::serve(v.promise, [&](const adapter::request& r, adapter::answer& a) {
        answer_request(v, r, a);
      });
  }
  if (asked == "--variants")
    return 0;
  std::fprintf(stderr, "usage: graze-adapter-%s --variants | VARIANT\n", library.name);
  return 2;
}
