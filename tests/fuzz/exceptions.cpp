/// A traversal in this process that throws: a finding of its own kind, on the ray that brings it
/// on, and the campaign goes on.
#include "../support/program.hpp"
#include "campaign_of.hpp"
#include <campaign/lasting.hpp>
#include <judge/replay.hpp>
#include <nlohmann/json.hpp>
#include <report/report.hpp>
#include <report/reproducer/reproducer.hpp>
#include <stdexcept>

using namespace graze::fuzz;

namespace {

trial ray_towards(const vec3& direction) {
  trial t;
  t.origin = {0.25, 0.25, 0.25};
  t.direction = direction;
  return t;
}

/// mutant-throws throws for these, an int where y < 0 too.
bool thrown_at(const trial& t) { return t.direction[0] < 0; }

/// Throws in make() each other time, and answers many rays at once.
class hard_to_make final : public traversal {
public:
  explicit hard_to_make(int& made) {
    if (++made % 2 == 0)
      throw std::logic_error("not again");
  }
  [[nodiscard]] std::string_view name() const override { return "hard-to-make"; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }
  void visit(const trial& t, visited& out) override {
    if (thrown_at(t))
      throw std::runtime_error("thrown alone");
    out.decline();
  }
  std::size_t visit_some(std::span<const trial> trials, std::span<visited> out) override {
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (thrown_at(trials[i]))
        throw std::runtime_error("thrown among others");
      out[i].clear();
      out[i].decline();
    }
    return trials.size();
  }
};

} // namespace

TEST_CASE("fuzz.exceptions: what is thrown is the answer, whatever its type", "[unit]") {
  const auto under_test = find_traversal("mutant-throws")->make();
  visited out;
  ask(*under_test, ray_towards({-1, 1, 1}), out);
  CHECK(out.failed() == fault::exception);
  CHECK(out.thrown() == "a direction with x < 0");
  CHECK(out.size() == 0); // what it had answered before does not count
  CHECK(judge_answer(ray_towards({-1, 1, 1}), out, promise::owned).findings ==
        bit(finding::exception));
  CHECK(judge(ray_towards({-1, -1, 1}), *find_traversal("mutant-throws")->make()).findings ==
        bit(finding::exception));
  ask(*find_traversal("mutant-throws")->make(), ray_towards({-1, -1, 1}), out);
  CHECK(out.thrown() == "not a std::exception");
  ask(*under_test, ray_towards({1, 1, 1}), out); // it answers, though nothing right
  CHECK(out.failed() == fault::none);
  CHECK(out.thrown().empty());
}

TEST_CASE("fuzz.exceptions: in a campaign each ray that brings one on is a finding, and no other",
          "[property]") {
  for (const unsigned threads : {1u, 3u}) {
    campaign_plan plan = plan_of("mutant-throws", 10, 5000);
    plan.workers = threads;
    std::uint64_t expected = 0;
    for (std::uint64_t k = 0; k < plan.trials; ++k)
      expected += thrown_at(trial_of(plan, k)) ? 1 : 0;
    CHECK(expected > 500);
    const campaign_result result = run(plan);
    CHECK(result.total.rays == plan.trials);
    CHECK(result.total.faults == expected);
    CHECK(result.total.findings == expected);
    CHECK(result.foremost() == finding::exception);
    const auto found = counterexample_of(plan, result, true);
    REQUIRE(found);
    CHECK(found->kind == finding::exception);
    CHECK(thrown_at(found->shrunk));
    CHECK(found->shrunk.level <= 1);
    CHECK(describe(plan, result, *found).find("\nexception by mutant-throws") != std::string::npos);
  }
}

TEST_CASE("fuzz.exceptions: of many rays at once, the one that throws is found; who cannot be made "
          "again is asked again",
          "[unit]") {
  int made = 0;
  const traversal_entry entry{"hard-to-make", "",
                              [&] { return std::unique_ptr<traversal>(new hard_to_make(made)); }};
  campaign_plan plan = plan_of("sound", 10, 500);
  plan.under_test = entry;
  plan.workers = 1;
  std::uint64_t expected = 0;
  for (std::uint64_t k = 0; k < plan.trials; ++k)
    expected += thrown_at(trial_of(plan, k)) ? 1 : 0;
  const counts c = run(plan).total;
  CHECK(c.rays == plan.trials);
  CHECK(c.faults >= expected); // and those for which it could not be made
  CHECK(c.faults == c.findings);
  CHECK(c.faults + c.declined == c.rays);
  CHECK(c.declined > 0);
  CHECK(made > 10);
}

TEST_CASE("fuzz.exceptions: replayed, and written as a reproducer", "[unit]") {
  const auto under_test = find_traversal("mutant-throws")->guarded();
  const trial t = ray_towards({-1, 1, 1});
  for (int again = 0; again < 3; ++again) {
    const replay_result r = replay(t, *under_test);
    CHECK(r.findings == bit(finding::exception));
    CHECK(r.thrown == "a direction with x < 0");
    CHECK(to_json_line({1, t}, r, "x").find("\"exception\":\"a direction with x < 0\"") !=
          std::string::npos);
    CHECK(replay(ray_towards({1, 1, 1}), *under_test).findings == 0u);
  }
  const std::string text = reproducer_text(reproduction_of(t, *under_test, finding::exception));
  CHECK(text.find("exception by mutant-throws") == 0);
  CHECK(text.find("exception  a direction with x < 0\n") != std::string::npos);
}

TEST_CASE("fuzz.exceptions: a piece of a lasting campaign ends with its finding", "[unit]") {
  campaign_plan plan = plan_of("mutant-throws", 10, 2000);
  stored_plan stored;
  stored.rays = 2000;
  stored.piece = 1000;
  const std::atomic<bool> stop{false};
  const auto checked = check_piece(plan, stored, 1, stop);
  REQUIRE(checked);
  REQUIRE(checked->piece.findings.size() == 1);
  CHECK(checked->files.size() == 1);
}

TEST_CASE("graze-fuzz: run, campaign and replay of a traversal that throws", "[unit]") {
  const support::scratch dir;
  const std::string file = dir / "thrown.jsonl", folder = dir / "campaign";
  const auto o = support::call(GRAZE_FUZZ, "run --traversal mutant-throws --rays 5000 --level 10 "
                                           "--json --save " +
                                               file + " --reproducer " + (dir / "out"));
  CHECK(o.code == 1);
  const auto object = nlohmann::json::parse(o.out);
  CHECK(object["finding"] == "exception");
  CHECK(object["rays"] == 5000);
  CHECK(object["faults"] == object["rays_with_finding"]);
  const auto again =
      support::call(GRAZE_FUZZ, "replay --json " + file + " --traversal mutant-throws");
  CHECK(again.code == 1);
  CHECK(nlohmann::json::parse(again.out)["findings"] == nlohmann::json::array({"exception"}));
  CHECK(support::call(GRAZE_FUZZ, "replay " + file + " --traversal sound").code == 0);
  const auto lasting = support::call(GRAZE_FUZZ, "campaign " + folder +
                                                     " --traversal mutant-throws --rays 3000 "
                                                     "--piece 1000 --level 10");
  CHECK(lasting.code == 1);
  CHECK(support::call(GRAZE_FUZZ, "summary " + folder).out.find("exception") != std::string::npos);
}
