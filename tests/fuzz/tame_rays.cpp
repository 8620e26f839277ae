/// --tame, budgets of hangs, and which finding is told first.
#include "../support/program.hpp"
#include "campaign_of.hpp"
#include <campaign/counterexample.hpp>
#include <generate/tame.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <report/report.hpp>
#include <shrink/shrink.hpp>
#include <traversal/list.hpp>
#include <trial/replay_line.hpp>

using namespace graze::fuzz;

namespace {

trial through(const vec3& origin, const vec3& direction, double size = 1) {
  trial t;
  t.origin = origin;
  t.direction = direction;
  t.root.size = size;
  return t;
}

/// Reports nothing where `fails` says so, and the right answer elsewhere.
class failing final : public traversal {
public:
  explicit failing(bool (*fails)(const trial&), fault how)
      : fails_(fails), how_(how), right_(find_traversal("sound")->make()) {}
  [[nodiscard]] std::string_view name() const override { return "failing"; }
  [[nodiscard]] promise promises() const override { return promise::crossed; }
  void visit(const trial& t, visited& out) override {
    ++asked;
    if (!fails_(t))
      return right_->visit(t, out);
    if (how_ != fault::none)
      out.fail(how_);
  }
  static inline std::atomic<unsigned> asked{0};

private:
  bool (*fails_)(const trial&);
  fault how_;
  std::unique_ptr<traversal> right_;
};

traversal_entry entry_of(bool (*fails)(const trial&), fault how) {
  return {"failing", "", [=] { return std::make_unique<failing>(fails, how); }};
}

} // namespace

TEST_CASE("fuzz.tame: what a tame ray is, at its bounds", "[unit]") {
  CHECK(is_tame(through({0.5, 0.25, -1}, {0.1, 0.2, 1})));
  CHECK(is_tame(through({-16, 17, 0}, {1, 0, -0.0})));
  CHECK_FALSE(is_tame(through({-16 - 0x1p-48, 0, 0}, {1, 0, 0})));
  CHECK_FALSE(is_tame(through({0, 17 + 0x1p-48, 0}, {1, 0, 0})));
  CHECK(is_tame(through({-160, 170, 0}, {1, 0, 0}, 10)));
  CHECK(is_tame(through({0x1p-80, 0, 0}, {1, 0, 0})));
  CHECK_FALSE(is_tame(through({0x1.8p-81, 0, 0}, {1, 0, 0})));
  CHECK(is_tame(through({0, 0, 0}, {1, 0x1p-40, 0})));
  CHECK_FALSE(is_tame(through({0, 0, 0}, {1, 0x1.8p-41, 0})));
  CHECK(is_tame(through({0, 0, 0}, {0x1p40, 1, 0})));
  CHECK_FALSE(is_tame(through({0, 0, 0}, {0x1.1p40, 0x1p20, 0})));
  CHECK(is_tame(through({0, 0, 0}, {0x1p-40, 0, 0})));
  CHECK_FALSE(is_tame(through({0, 0, 0}, {0x1.8p-41, 0, 0})));
  CHECK_FALSE(is_tame(through({0, 0, 0}, {5e-324, 0, 0})));
  CHECK(is_tame(through({0, 0, 0}, {0x1p100, 0, 0}, 0x1p100))); // not normalised, in a large scene
  CHECK(is_tame(through({0, 0, 0}, {1, 0, 0}, 0x1p100)));
}

TEST_CASE("fuzz.tame: rays of all generators are tame, legal and always the same", "[property]") {
  unsigned replaced = 0, same_block = 0, all = 0;
  for (const int level : {1, 10, 50, 53})
    for (const generator& g : generators())
      for (unsigned k = 0; k < 400; ++k) {
        const trial given = make_trial(g, 5, k, level);
        const trial t = tamed(given, 5, k);
        REQUIRE(is_tame(t));
        REQUIRE(judgeable(t));
        REQUIRE(tamed(given, 5, k) == t);
        REQUIRE((!is_tame(given) || t == given));
        replaced += t != given ? 1 : 0;
        same_block += t.base == given.base && t.extent == given.extent ? 1 : 0;
        ++all;
      }
  CHECK(replaced > all / 10);
  CHECK(same_block == all);
}

TEST_CASE("fuzz.tame: the replaced rays are hard: each generator's find what they are for",
          "[property]") {
  for (const char* only : {"subnormal", "huge", "far-origin", "exponent-gap", "near-parallel"}) {
    campaign_plan plan = plan_of("gargantini", 30, 3000, only);
    plan.tame = true;
    const campaign_result result = run(plan);
    INFO(only);
    CHECK(result.total.crossed_missed > 300);
    CHECK(result.total.touched > 3000); // the rays reach their blocks
    plan.under_test = *find_traversal("sound");
    CHECK(run(plan).total.findings == 0);
  }
}

TEST_CASE("fuzz.tame: a climb stays among tame rays", "[property]") {
  campaign_plan plan = plan_of("plain", 10, 2000);
  plan.tame = true;
  plan.method = search::climb;
  trial_source source(plan);
  unsigned different = 0;
  trial before;
  for (std::uint64_t ray = 0; ray < 2000; ++ray) {
    const trial t = source.at(ray);
    REQUIRE(is_tame(t));
    REQUIRE(trial_of(plan, ray / 256 * 256) ==
            (ray % 256 == 0 ? t : trial_of(plan, ray / 256 * 256)));
    different += t != before ? 1 : 0;
    before = t;
  }
  CHECK(different > 1500);
}

TEST_CASE("fuzz.tame: a hang on a strange ray does not outrank a miss on a tame one", "[unit]") {
  struct both final : traversal {
    std::unique_ptr<traversal> right = find_traversal("sound")->make();
    [[nodiscard]] std::string_view name() const override { return "both"; }
    [[nodiscard]] promise promises() const override { return promise::crossed; }
    void visit(const trial& t, visited& out) override {
      if (!is_tame(t))
        return out.fail(fault::hang);
      if (t.direction[0] > 0)
        right->visit(t, out);
    }
  };
  campaign_plan plan = plan_of("sound", 10, 2000);
  plan.under_test = {"both", "", [] { return std::make_unique<both>(); }};
  plan.hangs = 0;
  const campaign_result result = run(plan);
  CHECK(result.foremost() == finding::gross_miss);
  CHECK(result.kinds_found().back() == finding::hang);
  CHECK(result.is_on_tame_ray(finding::gross_miss));
  CHECK_FALSE(result.is_on_tame_ray(finding::hang));
  for (const counterexample& c : counterexamples_of(plan, result)) {
    INFO(name_of(c.kind));
    CHECK(is_tame(c.found) == (c.kind != finding::hang));
    CHECK(is_tame(c.shrunk) == (c.kind != finding::hang));
  }
  CHECK(counterexamples_of(plan, result, false).size() == result.kinds_found().size());
}

TEST_CASE("fuzz.tame: shrinking never leaves the tame range", "[regression]") {
  // fails on all rays: without the rule the simplest has a direction of 5e-324 or a far origin
  const auto under_test = entry_of(
      [](const trial& t) { return t.origin[0] != 0 && t.direction[1] != 0 && t.level > 3; },
      fault::crash);
  const auto made = under_test.make();
  unsigned shrunk = 0;
  for (const generator& g : generators())
    for (unsigned k = 0; k < 5; ++k) {
      const trial t = make_trial(g, 8, k, 20);
      if ((judge(t, *made).findings & bit(finding::crash)) == 0)
        continue;
      CHECK((is_tame(shrink(t, *made, finding::crash)) || !is_tame(t)));
      ++shrunk;
    }
  CHECK(shrunk > 20);
}

TEST_CASE("fuzz.tame: a zoom into the scene would take the origin far away", "[regression]") {
  const auto made =
      entry_of(
          [](const trial& t) { return t.origin[0] > 0x1p22 * t.size() && (t.base[0] & 7) == 5; },
          fault::crash)
          .make();
  trial t = through({8, 0.25, 0.25}, {-1, 0, 0});
  t.level = 20;
  t.base = {(1u << 16) | 5u, 1u << 18, 1u << 18}; // of no ancestor the last bits are 101
  REQUIRE(judgeable(t));
  const trial small = shrink(t, *made, finding::crash);
  CHECK(is_tame(small));
  CHECK(complexity_of(small) < complexity_of(t));
  t.origin[0] = 800; // nobody takes this one: it may go anywhere
  CHECK(shrink(t, *made, finding::crash).level < 10);
}

TEST_CASE("fuzz.tame: of a kind that tame rays show, a tame ray is told", "[unit]") {
  campaign_plan plan = plan_of("sound", 10, 4000);
  plan.under_test = entry_of([](const trial&) { return true; }, fault::none); // reports nothing
  const campaign_result result = run(plan);
  unsigned replaced = 0;
  const auto rays = result.first_rays(finding::gross_miss);
  for (std::size_t g = 0; g < rays.size(); ++g) {
    if (!rays[g])
      continue;
    CHECK(is_tame(trial_of(plan, *rays[g])));
    replaced += rays[g] != result.first[g][static_cast<unsigned>(finding::gross_miss)] ? 1 : 0;
  }
  CHECK(replaced > 0);
}

TEST_CASE("fuzz.seams: they lead where most rays with a finding show one", "[unit]") {
  struct shy final : traversal { // leaves out voxels that are not crossed
    [[nodiscard]] std::string_view name() const override { return "shy"; }
    [[nodiscard]] promise promises() const override { return promise::crossed; }
    void visit(const trial& t, visited& out) override {
      const truth exact = truth_of(t);
      for (unsigned v = 0; v < 64; ++v)
        if ((exact.crossed >> v & 1) != 0 && !(t.level == 10 && t.origin[0] < 0x1p-6))
          out.push(static_cast<octant_number>(v));
    }
  };
  campaign_plan plan = plan_of("sound", 10, 4000);
  plan.under_test = {"shy", "", [] { return std::make_unique<shy>(); }};
  const campaign_result misses = run(plan);
  CHECK(misses.foremost() == finding::gross_miss);
  plan.level = plan.last_level = 11;
  const campaign_result seams = run(plan);
  CHECK(seams.foremost() == finding::gap); // in the root's faces
  CHECK(seams.seams_lead());
  CHECK(kinds_of(seams).starts_with("seam "));
  CHECK(kinds_of(seams).find("the ray runs in the face of two voxels, and neither was reported") <
        kinds_of(seams).find('\n'));
  CHECK(seams.total.rays_with[static_cast<unsigned>(finding::seam)] * 10 >
        seams.total.findings * 9);
  CHECK_FALSE(run(plan_of("gargantini", 10, 4000)).seams_lead());
  CHECK(kinds_of(run(plan_of("gargantini", 10, 4000))).starts_with("gross-miss "));
}

TEST_CASE("fuzz.hangs: after a few hangs a generator's rays are sent no more, and counted",
          "[unit]") {
  campaign_plan plan = plan_of("sound", 10, 4000);
  plan.workers = 1;
  const generator& bad = *plan.generators[3];
  plan.under_test = entry_of([](const trial& t) { return t.direction[0] < 0; }, fault::hang);
  const auto hangs_of = [](const counts& c) {
    return c.rays_with[static_cast<unsigned>(finding::hang)];
  };
  plan.generators = {&bad, find_generator("random")};
  for (const std::uint64_t most : {1, 3, 10}) {
    plan.hangs = most;
    failing::asked = 0;
    const campaign_result result = run(plan);
    for (const counts& c : result.by_generator) {
      CHECK(hangs_of(c) >= most);
      CHECK(hangs_of(c) < most + 64); // those that were asked together
      CHECK(c.rays == 2000);
      CHECK(c.unsent > 1500);
    }
    CHECK(failing::asked == 4000 - result.total.unsent);
    CHECK(run(plan).total == result.total);
  }
  plan.hangs = 0;
  CHECK(run(plan).total.unsent == 0);
  CHECK(hangs_of(run(plan).total) > 1000);
}

TEST_CASE("graze-fuzz run: --tame, --except and --save-all", "[unit]") {
  const support::scratch dir;
  const std::string run = "run --traversal gargantini --level 10 --rays 6000 --seed 4 ";
  const auto usual = nlohmann::json::parse(support::call(GRAZE_FUZZ, run + "--json").out);
  const auto tame = nlohmann::json::parse(support::call(GRAZE_FUZZ, run + "--json --tame").out);
  CHECK(usual["tame"] == false);
  CHECK(tame["tame"] == true);
  CHECK(tame["rays"] == 6000);
  CHECK(tame["misses"] > 100);
  const auto found = from_json_line(tame["found_as"].dump());
  REQUIRE(found);
  CHECK(is_tame(*found));

  const auto fewer = nlohmann::json::parse(
      support::call(GRAZE_FUZZ, run + "--json --except vertex,huge --except random").out);
  CHECK(fewer["generators"].size() == generators().size() - 3);
  support::refused(GRAZE_FUZZ, run + "--except nothing", "no generator is called \"nothing\"");
  support::refused(GRAZE_FUZZ, run + "--generator vertex --except vertex", "leaves no generator");
  support::refused(GRAZE_FUZZ, "campaign " + (dir / "none") + " --generator vertex --except vertex",
                   "leaves no generator");

  const auto text = support::call(GRAZE_FUZZ, run + "--save-all " + (dir / "all") +
                                                  " --reproducer " + (dir / "out"));
  CHECK(text.code == 1);
  unsigned kinds = 0;
  for (const auto& [kind, rays] : usual["rays_with"].items()) {
    INFO(kind << "\n" << text.out);
    ++kinds;
    const std::string file = dir / ("all/" + kind + ".jsonl");
    REQUIRE(std::filesystem::exists(file));
    const auto again = support::call(GRAZE_FUZZ, "replay --json --traversal gargantini " + file);
    CHECK(again.code == 1);
    const auto findings = nlohmann::json::parse(again.out)["findings"];
    CHECK(std::find(findings.begin(), findings.end(), kind) != findings.end());
    CHECK(text.out.find(kind + " ") != std::string::npos);
  }
  CHECK(kinds >= 5);
  unsigned reproducers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dir / "out"))
    reproducers += entry.path().extension() == ".txt" ? 1 : 0;
  CHECK(reproducers >= kinds - 2); // two kinds may have shrunk to the same ray
}

TEST_CASE("graze-fuzz campaign: --tame, --except and --hangs are part of the plan", "[unit]") {
  const support::scratch dir;
  const std::string folder = dir / "campaign";
  const std::string made =
      "campaign " + folder + " --traversal gargantini --level 10 --rays 3000 --piece 1000";
  CHECK(support::call(GRAZE_FUZZ, made + " --tame --except vertex --hangs 2").code == 1);
  const auto plan = nlohmann::json::parse(support::content(folder + "/plan.json"));
  CHECK(plan["tame"] == true);
  CHECK(plan["hangs"] == 2);
  CHECK(plan["generators"].size() == generators().size() - 1);
  CHECK(
      support::call(GRAZE_FUZZ, "campaign " + folder + " --tame --except vertex --hangs 2").code ==
      1);
  support::refused(GRAZE_FUZZ, "campaign " + folder + " --except huge", "holds another plan");
  support::refused(GRAZE_FUZZ, "campaign " + folder + " --hangs 3", "hangs is 2, not 3");
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/findings")) {
    const auto t = from_json_line(support::content(entry.path()));
    REQUIRE(t);
    CHECK(is_tame(*t));
  }
}
