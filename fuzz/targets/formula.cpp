/// Text formulas: any text is taken, or refused with a column of it, and what is taken has a value.
#include "target.hpp"
#include <graze/octree_formula.hpp>
#include <graze/rounding/nearest.hpp>

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using fuzz::target::require;
  const std::string text = fuzz::target::text_of({data, size});
  std::size_t column = 0;
  const auto f = octree::formula::parse(text, &column);
  if (const auto given = octree::parameter::make("a", text)) {
    const auto a = octree::formula::parse("x-a", nullptr, std::span(&*given, 1));
    require(f && a && a->uses("a"), "a value that is no formula, or of no use");
  }
  if (!f) {
    require(column >= 1 && column <= text.size() + 1, "refused at no column of the text");
    return 0;
  }
  (void)f->notes({{-1, -1, -1}, {1, 1, 1}});
  using anywhere = interval<rounding::nearest>;
  const auto at = [&](const anywhere& x) { return f->surface()(x, anywhere(-1.0), anywhere(2.0)); };
  const auto whole = at(anywhere(0.5, 0.75)), part = at(anywhere(0.5625));
  require(whole.lower() <= whole.upper(), "a value that is no interval");
  // where f is not defined the value is 1, which says nothing of the whole
  require((part.lower() == 1 && part.upper() == 1) ||
              (whole.lower() <= part.upper() && part.lower() <= whole.upper()),
          "the value at a point of a box is beside that of the box");
  return 0;
}

std::vector<std::string> fuzz::target::seeds() {
  return {"x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8",
          "union(sqrt(x)-y, 1e-3)",
          "0x1.8p-3*atan2(y,x)",
          "1/x+rootn(y,3)",
          "(((",
          "2(x+1",
          "x^y^z",
          "w=sqrt(5);(a=x-w;a**2)²+|y|%3-z⁻¹ = π",
          "if(x<y and not(y>=0||z!=1), mod(x,2), clamp(r,-1,theta))",
          "||x|-1|·2−phi;",
          "min(x,)"};
}
