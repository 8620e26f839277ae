/// Replay lines: what is read is a legal trial, and is written so that it reads back.
#include "target.hpp"
#include <generate/scenes.hpp>
#include <trial/replay_line.hpp>

using namespace graze::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line = target::text_of({data, size});
  const auto t = from_json_line(line);
  if (!t) {
    target::require(!t.reason().empty(), "refused without a reason");
    return 0;
  }
  target::require(judgeable(*t).has_value(), "took a trial that cannot be judged");
  const auto again = from_json_line(to_json_line(*t));
  target::require(again && encode(*again) == encode(*t), "does not read back what it wrote");
  return 0;
}

std::vector<std::string> target::seeds() {
  std::vector<std::string> all{
      R"({"origin":[0.5,"0.25","0x1p-3"],"direction":[1,0,0],"octant":{"lo":[0,0,0],"size":0.5}})",
      R"({"origin":[0,0,0],"direction":[1,0,0],"octant":7})", "{}", "[", "null"};
  for (const generator& g : generators())
    all.push_back(to_json_line(make_trial(g, 62, 0, 10)));
  for (std::uint64_t k = 0; k < 12; ++k)
    for (const cell_kind cells : {cell_kind::cube, cell_kind::grid, cell_kind::boxes})
      all.push_back(
          to_json_line(make_trial(generators()[k], 63, 64 * k, 10, {cells, k % 2 == 0, nullptr})));
  return all;
}
