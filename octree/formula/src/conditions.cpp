#include "conditions.hpp"

namespace graze::octree::tape {

using enum condition::kind;

std::size_t size_of(const sum_form& f) {
  std::size_t n = 1;
  for (const auto& [m, coefficient] : f)
    n += 1 + m.size();
  return n;
}

truth condition::compared(kind what, sum_form f) {
  const std::size_t size = size_of(f);
  return std::make_shared<const condition>(condition{what, std::move(f), {}, size});
}
truth condition::joined(kind what, std::vector<truth> parts) {
  std::size_t size = 1;
  for (const truth& part : parts)
    size += part->size;
  return std::make_shared<const condition>(condition{what, {}, std::move(parts), size});
}

truth negated(expressions& built, const condition& c) {
  switch (c.what) {
  case greater:
    return condition::compared(at_least, *built.neg(c.f));
  case at_least:
    return condition::compared(greater, *built.neg(c.f));
  case same:
    return condition::compared(different, c.f);
  case different:
    return condition::compared(same, c.f);
  default:
    std::vector<truth> parts;
    for (const truth& part : c.parts)
      parts.push_back(negated(built, *part));
    return condition::joined(c.what == all ? any : all, std::move(parts));
  }
}

expressions::result chosen(expressions& built, const condition& c, const sum_form& if_true,
                           const sum_form& if_false) {
  if (c.what == greater)
    return built.select(c.f, if_true, if_false);
  if (c.what == at_least)
    return built.select(*built.neg(c.f), if_false, if_true);
  const sum_form yes = built.shared(if_true), no = built.shared(if_false);
  if (c.what == same || c.what == different) {
    const sum_form &on = c.what == same ? yes : no, &off = c.what == same ? no : yes;
    const auto not_above = built.select(*built.neg(c.f), off, on);
    return not_above ? built.select(c.f, off, *not_above) : not_above;
  }
  expressions::result r = c.what == all ? yes : no;
  for (auto part = c.parts.rbegin(); r && part != c.parts.rend(); ++part)
    r = c.what == all ? chosen(built, **part, *r, no) : chosen(built, **part, yes, *r);
  return r;
}

expressions::result solid(expressions& built, const condition& c) {
  if (c.what == greater || c.what == at_least)
    return built.neg(c.f);
  if (c.what == same)
    return c.f;
  if (c.what == different)
    return built.refuse("f != g is no surface: f = g is one");
  expressions::result r;
  for (const truth& part : c.parts) {
    if (part->what == same) // min and max would take it for f <= g
      return built.refuse("f == g is no solid, which could be joined: f <= g is one");
    auto f = solid(built, *part);
    if (f && r)
      f = built.binary(c.what == all ? opcode::max : opcode::min, *r, *f);
    if (!f)
      return f;
    r = std::move(f);
  }
  return r;
}

} // namespace graze::octree::tape
