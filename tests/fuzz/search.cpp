/// Trials as bytes, their mutations, the margin, and the climb towards the smallest one.
#include "campaign_of.hpp"
#include <generate/margin.hpp>
#include <generate/mutate.hpp>
#include <gmpxx.h>
#include <judge/replay.hpp>
#include <limits>
#include <traversal/list.hpp>
#include <trial/codec.hpp>
#include <trial/number.hpp>

using namespace graze::fuzz;

namespace {

/// Trials of every generator, on the unit root and on others.
template <class Test> void on_trials(Test test) {
  const std::array<cube, 3> roots{cube{{0, 0, 0}, 1}, cube{{-4, -4, -4}, 8},
                                  cube{{0, 0, 0}, 0x1p-40}};
  for (const cube& root : roots)
    for (const generator& g : generators())
      for (const int level : {1, 10, 30, 50})
        for (unsigned k = 0; k < 20; ++k)
          test(make_trial(g, 41, k, level, root));
}

bool same_bits(const trial& a, const trial& b) { return encode(a) == encode(b) && a == b; }

/// margin()'s definition in rationals, for the edges that it looks at.
mpq_class margin_in_rationals(const trial& t, unsigned a, unsigned i, unsigned b, unsigned j) {
  const auto ulp = [](const mpq_class& x) {
    const mpq_class least = mpq_class(1) / (mpz_class(1) << 1074);
    const mpq_class relative = abs(x) / (mpz_class(1) << 52);
    return relative < least ? least : relative;
  };
  const auto larger = [](const mpq_class& x, const mpq_class& y) {
    return abs(x) < abs(y) ? mpq_class(abs(y)) : mpq_class(abs(x));
  };
  const mpq_class p(t.plane(static_cast<int>(a), i)), q(t.plane(static_cast<int>(b), j));
  const mpq_class oa(t.origin[a]), ob(t.origin[b]), da(t.direction[a]), db(t.direction[b]);
  const mpq_class unit = ulp(larger(p, oa)) * abs(db) + abs(p - oa) * ulp(db) +
                         ulp(larger(q, ob)) * abs(da) + abs(q - ob) * ulp(da);
  return abs((p - oa) * db - (q - ob) * da) / unit;
}

} // namespace

TEST_CASE("fuzz.codec: a trial comes back bit for bit", "[property]") {
  on_trials([](const trial& t) {
    const auto bytes = encode(t);
    REQUIRE(bytes.size() == encoded_size);
    const auto again = decode(bytes);
    REQUIRE(again);
    REQUIRE(same_bits(*again, t));
  });
}

TEST_CASE("fuzz.codec: the recorded cases can be encoded", "[unit]") {
  const auto cases = read_replay_file(GRAZE_CORPUS "/numerics.jsonl");
  REQUIRE(cases);
  for (const replay_case& c : *cases) {
    const auto again = decode(encode(c.at));
    REQUIRE(again);
    CHECK(same_bits(*again, c.at));
  }
}

TEST_CASE("fuzz.codec: any bytes are a legal trial or refused", "[property]") {
  random_stream random(42, 0);
  unsigned decoded = 0;
  for (unsigned k = 0; k < 20'000; ++k) {
    auto bytes = encode(make_trial(generators()[k % generators().size()], 43, k, 1 + k % 53));
    for (unsigned changes = random.below(20); changes > 0; --changes)
      bytes[random.below(encoded_size)] = static_cast<std::uint8_t>(random.bits());
    if (const auto t = decode(bytes)) {
      ++decoded;
      REQUIRE(judgeable(*t));
      REQUIRE(same_bits(*decode(encode(*t)), *t));
    }
  }
  CHECK(decoded > 1000);
  CHECK_FALSE(decode({}));
  CHECK_FALSE(decode(std::vector<std::uint8_t>(encoded_size - 1)));
  CHECK_FALSE(decode(std::vector<std::uint8_t>(encoded_size + 1)));
  CHECK_FALSE(decode(std::vector<std::uint8_t>(encoded_size)));      // a direction of 0
  CHECK_FALSE(decode(std::vector<std::uint8_t>(encoded_size, 255))); // a root that is none
}

TEST_CASE("fuzz.trial: planes are exact where counting from the root's corner would round",
          "[regression]") {
  trial t;
  t.root = {{-3, -3, -3}, 6};
  t.level = 52;
  t.origin = {-4, -4, -4};
  t.direction = {1, 1, 1};
  const double size = t.size();
  bool differs = false;
  for (const std::uint64_t index :
       {(1ull << 51) - 1, (1ull << 51) + 1, (1ull << 52) - 1, (1ull << 52) - 12345}) {
    t.base = {index, index, index};
    REQUIRE(judgeable(t));
    const mpq_class exact =
        mpq_class(-3) + mpq_class(mpz_class(std::to_string(index))) * mpq_class(size);
    CHECK(mpq_class(t.plane(0, 0)) == exact);
    differs = differs || mpq_class(-3 + static_cast<double>(index) * size) != exact;
    const auto again = from_json_line(to_json_line(t));
    REQUIRE(again);
    CHECK(*again == t);
    for (const char* name : {"sound", "exact", "exact-closed"})
      CHECK(judge(t, *find_traversal(name)->make()).findings == 0u);
  }
  CHECK(differs);
}

TEST_CASE("fuzz.mutate: mutations are legal, new, and the same for a seed", "[property]") {
  std::uint64_t number = 0;
  unsigned same = 0;
  on_trials([&](const trial& start) {
    random_stream random(44, number), once_more(44, number);
    ++number;
    trial t = start;
    for (unsigned k = 0; k < 20; ++k) {
      const trial next = mutated(random, t);
      REQUIRE(judgeable(next));
      REQUIRE(same_bits(mutated(once_more, t), next));
      same += next == t ? 1 : 0;
      t = next;
    }
  });
  CHECK(same < number / 10);
}

TEST_CASE("fuzz.margin: 0 on an edge and a vertex, about an ulp beside them", "[unit]") {
  trial t;
  t.level = 2;
  t.base = {1, 1, 0};
  t.origin = {0.375, 0.375, -1};
  t.direction = {-1, -1, 8}; // through the edge x = y = 0.25 of the block's octants at z = 0
  CHECK(margin(t) == 0);
  t.direction = {-1, 1, 8};
  t.origin = {0.375, 0.125, -0.9}; // not at a vertex
  CHECK(margin(t) == 0);
  t.origin[0] = step_ulps(t.origin[0], 1);
  CHECK(margin(t) > 0.01);
  CHECK(margin(t) < 2);
  t.origin[0] = step_ulps(t.origin[0], 1 << 20);
  CHECK(margin(t) > 0x1p17);
  t.origin = {0.3, 0.3, 0.1}; // within one octant, and away from its edges
  t.direction = {0, 0, 1};
  CHECK(margin(t) > 0x1p45);
  t.origin = {-1, -1, -1}; // away from the block
  t.direction = {-1, -1, -1};
  CHECK(margin(t) == std::numeric_limits<double>::infinity());
}

TEST_CASE("fuzz.margin: what it tells is the definition's value for an edge of the block",
          "[property]") {
  unsigned counted = 0;
  on_trials([&](const trial& t) {
    const double m = margin(t);
    if (!std::isfinite(m))
      return;
    ++counted;
    mpq_class nearest = -1; // the edge whose value is nearest to what was told
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned a = (c + 1) % 3, b = (c + 2) % 3;
      if (t.direction[a] == 0 && t.direction[b] == 0)
        continue;
      for (unsigned i = 0; i <= t.extent[a]; ++i)
        for (unsigned j = 0; j <= t.extent[b]; ++j) {
          const mpq_class off = abs(margin_in_rationals(t, a, i, b, j) - mpq_class(m));
          if (nearest < 0 || off < nearest)
            nearest = off;
        }
    }
    INFO(to_json_line(t) << " margin " << m << " off by " << nearest.get_d());
    REQUIRE(nearest >= 0);
    REQUIRE(nearest <= mpq_class(0x1p-8 + m * 0x1p-40));
  });
  CHECK(counted > 1000);
}

TEST_CASE("fuzz.climb: goes down, and does not depend on where it is joined", "[property]") {
  campaign_plan plan = plan_of("sound", 10, 0, "random");
  plan.method = search::climb;
  unsigned arrived = 0;
  for (std::uint64_t number = 0; number < 20; ++number) {
    climber climb(make_trial(*plan.generators[0], plan.seed, number, 10), plan.seed, number);
    double height = margin(climb.at());
    for (unsigned k = 1; k < climb_length; ++k) {
      const trial next = climb.next();
      REQUIRE(judgeable(next));
      REQUIRE(margin(climb.at()) <= std::max(height, 0x1p-4));
      height = margin(climb.at());
      if (k % 50 == 0)
        REQUIRE(same_bits(trial_of(plan, number * climb_length + k), next));
    }
    arrived += height <= 1 ? 1 : 0;
  }
  CHECK(arrived >= 15);
}

TEST_CASE("fuzz.climb: counts and findings do not depend on the number of threads", "[property]") {
  campaign_plan plan = plan_of("published", 10, 10'000, "random");
  plan.method = search::climb;
  plan.workers = 1;
  const campaign_result single = run(plan);
  plan.workers = 3;
  const campaign_result several = run(plan);
  CHECK(several.first == single.first);
  CHECK(several.total == single.total);
}

TEST_CASE("fuzz.climb: finds from random rays what random rays do not find", "[property]") {
  for (const char* name : {"published", "plain", "gargantini", "mutant-exact"})
    for (const int level : {10, 30}) {
      campaign_plan plan = plan_of(name, level, 20'000, "random");
      INFO(name << " at level " << level);
      CHECK(run(plan).total.findings == 0);
      plan.method = search::climb;
      CHECK(run(plan).total.findings > 0);
    }
}

TEST_CASE("fuzz.climb: finds nothing in what is sound", "[property]") {
  for (const char* name : {"sound", "sound-closed", "sound-split", "exact", "exact-closed"}) {
    campaign_plan plan = plan_of(name, 1, 40'000);
    plan.last_level = 53;
    plan.method = search::climb;
    const campaign_result result = run(plan);
    INFO(name);
    CHECK(result.total.rays == 40'000);
    CHECK(result.total.findings == 0);
  }
}

TEST_CASE("fuzz.campaign: ends at a finding when told to", "[unit]") {
  campaign_plan plan = plan_of("published", 10, 10'000'000);
  plan.until_finding = true;
  const campaign_result result = run(plan);
  CHECK(result.total.findings > 0);
  CHECK(result.total.rays < 10'000'000);
  CHECK_FALSE(result.interrupted);
}
