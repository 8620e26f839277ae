/// The same predicates under RapidCheck: every generator, every level, shrunk and printed in hex.
/// A failure prints the string for RC_PARAMS that reproduces it.
#include <catch2/catch.hpp>
#include <shrink/rapidcheck.hpp>
#include <sstream>
#include <traversal/list.hpp>
#include <trial/codec.hpp>

using namespace graze::fuzz;

namespace {

/// rc::prop prints nothing by which a failure could be reproduced; with an id it does.
template <class Testable>
rc::detail::TestResult checked(const std::string& id, int times, Testable&& testable) {
  rc::detail::TestMetadata metadata;
  metadata.id = id;
  metadata.description = id;
  rc::detail::TestParams params;
  params.seed = 20240601;
  params.maxSuccess = times;
  const auto& configured = rc::detail::configuration();
  if (!configured.reproduce.empty())
    return rc::detail::checkTestable(std::forward<Testable>(testable), metadata);
  return rc::detail::checkTestable(std::forward<Testable>(testable), metadata, params);
}

template <class Testable> void holds(const std::string& id, int times, Testable&& testable) {
  const auto result = checked(id, times, std::forward<Testable>(testable));
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  INFO(text.str());
  CHECK(result.template is<rc::detail::SuccessResult>());
}

} // namespace

TEST_CASE("fuzz.rapidcheck: sound keeps its promise on every generator and level", "[property]") {
  for (const char* name : {"sound", "sound-closed"}) {
    const auto under_test = find_traversal(name)->make();
    holds(name, 20'000, [&] {
      const trial t = *any_trial();
      RC_ASSERT(judge(t, *under_test).findings == 0u);
    });
  }
}

TEST_CASE("fuzz.rapidcheck: what owns is touched, what is crossed is owned", "[property]") {
  holds("crossed, owned, touched", 20'000, [] {
    const truth exact = truth_of(*any_trial());
    RC_ASSERT((exact.crossed & ~exact.owned) == 0u);
    RC_ASSERT((exact.owned & ~exact.touched) == 0u);
    RC_ASSERT(std::popcount(exact.owned) == static_cast<int>(exact.owners));
  });
}

TEST_CASE("fuzz.rapidcheck: a failure is shrunk to a few bits and printed in hex floats",
          "[property]") {
  const auto published = find_traversal("published")->make();
  const auto result = checked("published misses", 20'000, [&] {
    const trial t = *any_trial();
    RC_ASSERT((judge(t, *published).findings & bit(finding::crossed_miss)) == 0u);
  });
  REQUIRE(result.is<rc::detail::FailureResult>());
  const auto& failure = result.get<rc::detail::FailureResult>();
  REQUIRE(failure.counterExample.size() == 1);
  const auto t = from_json_line(failure.counterExample[0].second);
  INFO(failure.counterExample[0].second);
  REQUIRE(t);
  CHECK(complexity_of(*t).octants == 1);
  CHECK(complexity_of(*t).bits < 80);
  CHECK((judge(*t, *published).findings & bit(finding::crossed_miss)) != 0);
}

TEST_CASE("fuzz.rapidcheck: sound and exact keep their promises on mutated trials", "[property]") {
  for (const traversal_entry& e : traversals()) {
    if (!e.name.starts_with("sound") && !e.name.starts_with("exact"))
      continue;
    const auto under_test = e.make();
    holds(std::string(e.name) + " on mutated trials", 5'000, [&] {
      const trial t = *any_mutated_trial();
      RC_ASSERT(judge(t, *under_test).findings == 0u);
    });
  }
}

TEST_CASE("fuzz.rapidcheck: the codec is exact, and never makes an illegal trial", "[property]") {
  holds("there and back", 5'000, [] {
    const trial t = *any_mutated_trial();
    const auto bytes = encode(t);
    const auto again = decode(bytes);
    RC_ASSERT(again.has_value());
    RC_ASSERT(encode(*again) == bytes);
  });
  holds("any bytes", 5'000, [] {
    const auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(
        encoded_size, rc::gen::arbitrary<std::uint8_t>());
    if (const auto t = decode(bytes))
      RC_ASSERT(judgeable(*t).has_value());
  });
}

TEST_CASE("fuzz.rapidcheck: mutants are found, and shrunk to integers of few bits", "[property]") {
  for (const traversal_entry& e : mutants()) {
    const auto mutant = e.guarded();
    if (mutant->takes(cell_kind::grid, false)) // scenes.cpp has those
      continue;
    const auto result = checked(std::string(e.name), 20'000, [&] {
      const trial t = *any_mutated_trial();
      RC_ASSERT(judge(t, *mutant).findings == 0u);
    });
    INFO(e.name);
    REQUIRE(result.is<rc::detail::FailureResult>());
    const auto& failure = result.get<rc::detail::FailureResult>();
    REQUIRE(failure.counterExample.size() == 1);
    const auto t = from_json_line(failure.counterExample[0].second);
    INFO(failure.counterExample[0].second);
    REQUIRE(t);
    CHECK(judge(*t, *mutant).findings != 0u);
    CHECK(complexity_of(*t).level <= 1);
    CHECK(complexity_of(*t).octants <= 4);
  }
}
