/// Files of the ITF1788 framework: any text is refused at a line, or its statements can be judged and
/// reported.
#include "target.hpp"
#include <graze/itf1788/report.hpp>

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto statements = itf1788::parse(fuzz::target::text_of({data, size}), "file.itl");
  if (!statements) {
    fuzz::target::require(statements.reason().starts_with("file.itl:"), "refused at no line");
    return 0;
  }
  itf1788::file_report report{"file.itl", {}};
  for (itf1788::statement& s : *statements) {
    itf1788::judgement j = itf1788::judge(s);
    report.statements.push_back({std::move(s), std::move(j)});
  }
  fuzz::target::require(!itf1788::to_text({report}, true).empty() &&
                            !itf1788::to_json({report}).empty(),
                        "no report");
  return 0;
}

std::vector<std::string> fuzz::target::seeds() {
  const auto test = [](const std::string& body) { return "testcase a.b { " + body + " }\n"; };
  return {test("add [1,2] [3,4] = [4,6];"),
          test("sub [1,2]_com [entire]_dac = [entire]_dac;"),
          test("div [1,2] [0,0] = [empty] signal UndefinedOperation;"),
          test("pown [-0x1.8p-3, infinity] 7 <= [entire];"),
          test("b-textToInterval \"[1.5e10, 2/3]\" = [1,2];"),
          test("sum_nearest {1.0, 2.0, -3e400} = 0.0;"),
          test("overlap [1,2] [3,4] = before; isEmpty [nai] = false;"),
          "/* a comment */ // one more\n" + test("sqrt [4,9] = [2,3] <= [1.9,3.1];"),
          test("mulRevToPair [0,1] [1,2] = [1,infinity] [empty];"),
          "testcase {",
          "testcase a { add [1,2 = ; }",
          "",
          "#* never ends"};
}
