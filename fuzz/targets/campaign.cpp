/// What a campaign's folder holds: plan.json and lines of progress.jsonl. Any text is refused with a
/// reason, or reads back as it is written.
#include "target.hpp"
#include <campaign/store.hpp>
#include <graze/support/text.hpp>
#include <trial/content_hash.hpp>

using namespace graze::fuzz;

namespace {

const stored_plan& plan_of_lines() {
  static const stored_plan plan = [] {
    stored_plan p;
    p.generators = {"vertex", "random"};
    p.rays = 1'000'000;
    p.piece = 1000;
    p.shard = 2;
    p.shards = 3;
    return p;
  }();
  return plan;
}

finished_piece some_piece() {
  finished_piece p;
  p.number = 4;
  p.elapsed = 1.5;
  p.by_generator.resize(2);
  p.by_generator[0].rays = p.by_generator[1].rays = 500;
  p.findings.push_back({content_hash("x"), finding::gap, 4711, true});
  return p;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = target::text_of({data, size});
  const auto plan = plan_from(text);
  target::require(plan || !plan.reason().empty(), "a plan that is refused without a reason");
  if (plan)
    target::require(plan->shard >= 1 && plan->shard <= plan->shards && plan->piece >= 1,
                    "took a plan that cannot be run");
  const auto piece = piece_from(text, plan_of_lines());
  if (!piece) {
    target::require(!piece.reason().empty(), "a piece that is refused without a reason");
    return 0;
  }
  for (const sighting& s : piece->findings)
    target::require(graze::support::is_content_hash(s.hash), "took a hash that is none");
  const auto again = piece_from(to_json_line(*piece), plan_of_lines());
  target::require(again && to_json_line(*again) == to_json_line(*piece),
                  "does not read back what it wrote");
  return 0;
}

std::vector<std::string> target::seeds() {
  return {
      to_json_line(some_piece()),
      R"({"graze_campaign":1,"traversal":"sound","external":null,"generators":["vertex"],)"
      R"("search":"climb","level":"1-50","seed":1,"rays":0,"seconds":1e9,"piece":7,"shard":1,"shards":1})",
      R"({"graze_campaign":1,"traversal":"./mine","external":{"promise":"owned","plain":false,)"
      R"("float":true,"timeout":2.5},"generators":[],"level":"7","seed":1,"rays":5,"seconds":0,)"
      R"("piece":1,"shard":1,"shards":2})",
      "{}",
      "[",
      "null",
      R"({"piece":1,"counts":[[]],"findings":[{}]})",
      R"({"piece":1.8e20,"elapsed":0,"counts":[[1e300]],"findings":[]})"};
}
