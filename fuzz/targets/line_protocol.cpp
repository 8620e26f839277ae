/// Answers of a traversal in another process: whatever its lines hold, what is read of them is
/// within the block and can be judged.
#include "target.hpp"
#include <external/line_protocol.hpp>
#include <generate/generators.hpp>
#include <judge/judge.hpp>

using namespace graze::fuzz;

namespace {

constexpr std::uint64_t number = 7;

trial asked() {
  trial t = make_trial(*find_generator("vertex"), 63, 0, 5);
  t.base = {3, 4, 5};
  t.extent = {2, 3, 4};
  return t;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const trial t = asked();
  const std::string line = target::text_of({data, size});
  if (const auto greeting = read_hello(line))
    target::require(greeting->batch.value_or(1) >= 1 && greeting->tolerance.value_or(0) >= 0,
                    "numbers that are none");
  for (int p = 0; p <= static_cast<int>(promise::count); ++p) {
    const answer_form form{static_cast<promise>(p), p % 2 == 0, false};
    visited answer;
    answer.clear();
    echoed echo;
    read_answer(line, t, number, form, answer, &echo);
    target::require((answer.set() & ~t.all()) == 0, "visited outside the block");
    target::require(std::popcount(answer.set()) == static_cast<int>(answer.size()),
                    "the set is not that of the order");
    target::require((answer.failed() == fault::malformed) == !answer.thrown().empty(),
                    "malformed without a reason");
    const verdict v = judge_answer(t, answer, form.promised);
    if (answer.failed() != fault::none && !v.declined)
      target::require(v.findings != 0, "a fault that is no finding");
  }
  std::array<visited, 2> answers;
  const std::array trials{t, t};
  constexpr std::array<std::size_t, 2> places{0, 1};
  for (visited& answer : answers)
    answer.clear();
  if (!read_batch(line, trials, places, number, {}, answers))
    for (const visited& answer : answers)
      target::require(answer.failed() != fault::none, "a batch of another length is an answer");
  return 0;
}

std::vector<std::string> target::seeds() {
  std::vector<std::string> all{
      "[[3,4,5],[4,4,5]]",
      R"({"visited":[[3,4,5]],"id":7,"received":{"origin":[1,2,3],"direction":["0x1p-3",0,-1e300]}})",
      R"({"visited":[[3,4,null]]})",
      R"({"skip":true})",
      "3 4 5 4 4 5 received 0 0 0 1 0x1p-3 inf",
      "skip",
      "promise owned",
      "promise first cells boxes segments true batch 10 numbers bits tolerance 4 echo true",
      R"({"promise":"first","cells":"grid","segments":true,"batch":9,"numbers":"bits","tolerance":4})",
      R"({"first":[3,4,5],"t":0.5,"distance":"3fe0000000000000","face":"-x"})",
      R"({"first":null})",
      "3 4 5 t 3fe0000000000000 distance 0x1p-1 face +z id 7",
      "none",
      R"({"hit":true})",
      R"({"count":3})",
      "true",
      "3",
      R"({"answers":[[[3,4,5]],{"visited":[],"id":8}]})",
      R"({"promise":"exactly-touched"})",
      "[[3,4,NaN]]",
      "[[1e999,0,0]]"};
  for (const line_format format : {line_format::json, line_format::plain, line_format::bits}) {
    std::string request;
    append_request(request, asked(), number, format, {.echo = true});
    request.pop_back();
    all.push_back(request);
  }
  return all;
}
