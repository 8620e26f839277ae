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
    target::require(!greeting->promised || greeting->wrong.empty(), "a promise that is both");
  visited answer;
  answer.clear();
  read_answer(line, t, number, answer);
  target::require((answer.set() & ~t.all()) == 0, "visited outside the block");
  target::require(std::popcount(answer.set()) == static_cast<int>(answer.size()),
                  "the set is not that of the order");
  const verdict v = judge_answer(t, answer, promise::touched);
  if (answer.failed() != fault::none && !v.declined)
    target::require(v.findings != 0, "a fault that is no finding");
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
      R"({"promise":"exactly-touched"})",
      "[[3,4,NaN]]",
      "[[1e999,0,0]]"};
  for (const line_format format : {line_format::json, line_format::plain}) {
    std::string request;
    append_request(request, asked(), number, format);
    request.pop_back();
    all.push_back(request);
  }
  return all;
}
