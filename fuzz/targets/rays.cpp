/// The sound and the exact traversals keep their promises on every ray, in both conventions.
/// GRAZE_FUZZ_TRAVERSAL=published (or any name of `graze-fuzz list`) puts another under test.
#include "target.hpp"
#include <algorithm>
#include <cstdlib>
#include <generate/generators.hpp>
#include <generate/mutate.hpp>
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
    if (entry.name.starts_with("sound") || entry.name.starts_with("exact"))
      all.push_back(entry.guarded());
  return all;
}

/// Some trial, for bytes that are none.
trial any_trial(random_stream& random) {
  const auto& kinds = generators();
  return make_trial(kinds[random.below(static_cast<unsigned>(kinds.size()))], random.bits(), 0,
                    random.between(1, graze::octree::max_level));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto t = decode({data, size});
  if (!t)
    return -1; // not for the corpus
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
    LLVMFuzzerMutate(data, encoded_size, encoded_size);
    if (const auto other = decode({data, encoded_size}))
      t = other;
  } else if (t) {
    for (int moves = random.between(1, 4); moves > 0; --moves)
      t = mutated(random, *t);
  } else {
    t = any_trial(random);
  }
  const auto bytes = encode(*t);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

std::vector<std::string> target::seeds() {
  std::vector<std::string> all;
  for (const generator& g : generators())
    for (const int level : {1, 10, 30, 50})
      all.push_back(text_of(encode(make_trial(g, 61, 0, level))));
  return all;
}
