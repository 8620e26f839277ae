/// The sound and the exact traversals keep their promises on every ray, in both conventions; so do those
/// of grids and boxes on every ray and segment.
/// GRAZE_FUZZ_TRAVERSAL=published (or any name of `graze-fuzz list`) puts another under test.
#include "target.hpp"
#include <algorithm>
#include <cstdlib>
#include <generate/generators.hpp>
#include <generate/mutate.hpp>
#include <generate/scenes.hpp>
#include <judge/judge.hpp>
#include <traversal/list.hpp>
#include <trial/replay_line.hpp>

using namespace graze::fuzz;

namespace {

std::vector<std::unique_ptr<traversal>> under_test() {
  std::vector<std::unique_ptr<traversal>> all;
  if (const char* name = std::getenv("GRAZE_FUZZ_TRAVERSAL")) {
    const traversal_entry* entry = find_traversal(name);
    target::require(entry != nullptr, "GRAZE_FUZZ_TRAVERSAL is no traversal's name");
    all.push_back(entry->guarded());
    return all;
  }
  for (const traversal_entry& entry : traversals())
    if (entry.name.starts_with("sound") || entry.name.starts_with("exact") ||
        entry.name.starts_with("grid") || entry.name.starts_with("boxes"))
      all.push_back(entry.guarded());
  return all;
}

/// Of an axis of a grid.
constexpr std::uint32_t most_count = 4096;

/// Some trial, for bytes that are none.
trial any_trial(random_stream& random) {
  const auto& kinds = generators();
  const generator& g = kinds[random.below(static_cast<unsigned>(kinds.size()))];
  const std::uint64_t seed = random.bits();
  const int level = random.between(1, graze::octree::max_level);
  const auto cells = static_cast<cell_kind>(random.below(cell_kinds));
  trial t = make_trial(g, seed, 0, level, {cells, random.coin(), nullptr});
  if (t.grid) // grids of many planes take long to make
    for (unsigned a = 0; a < 3; ++a)
      if (t.grid->count[a] > most_count)
        return make_trial(g, seed, 0, level);
  return t;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto t = decode({data, size});
  if (!t)
    return -1; // not for the corpus
  if (t->grid && std::max({t->grid->count[0], t->grid->count[1], t->grid->count[2]}) > most_count)
    return -1;
  static const auto all = under_test();
  for (const auto& asked : all) {
    const finding_set findings = judge(*t, *asked).findings;
    if (findings != 0)
      target::wrong(std::string(asked->name())
                        .append(": ")
                        .append(name_of(worst(findings)))
                        .append("\nreplay: echo '")
                        .append(to_json_line(*t))
                        .append("' | graze-fuzz replay - --traversal ")
                        .append(asked->name()));
  }
  return 0;
}

/// Mostly a few of the hill climb's moves; at times libFuzzer's own.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  random_stream random(seed, 0);
  if (max_size < encoded_size)
    return LLVMFuzzerMutate(data, size, max_size);
  auto t = decode({data, size});
  if (t && random.one_in(8)) {
    LLVMFuzzerMutate(data, size, size);
    if (const auto other = decode({data, size}))
      t = other;
  } else if (t) {
    for (int moves = random.between(1, 4); moves > 0; --moves)
      t = mutated(random, *t);
  } else {
    t = any_trial(random);
  }
  auto bytes = encode(*t);
  if (bytes.size() > max_size)
    return LLVMFuzzerMutate(data, size, max_size);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

std::vector<std::string> target::seeds() {
  std::vector<std::string> all;
  for (const generator& g : generators())
    for (const int level : {1, 10, 30, 50})
      all.push_back(text_of(encode(make_trial(g, 61, 0, level))));
  for (std::uint64_t k = 0; k < 40; ++k)
    for (const cell_kind cells : {cell_kind::cube, cell_kind::grid, cell_kind::boxes}) {
      const trial t = make_trial(generators()[k % generators().size()], 62 + k, 0, 10,
                                 {cells, k % 2 == 0, nullptr});
      if (!t.grid || std::max({t.grid->count[0], t.grid->count[1], t.grid->count[2]}) <= most_count)
        all.push_back(text_of(encode(t)));
    }
  return all;
}
