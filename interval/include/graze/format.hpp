#pragma once
/// std::format of intervals: the text of operator<<, "{}" with decimals that enclose, "{:x}" with
/// the bounds in hexadecimal. Needs a library that has <format>.
#include <graze/needs_cxx20.hpp>

#include <format>
#include <graze/boost_functions.hpp>
#include <string>

template <class P>
  requires graze::detail::rounded<P>
struct std::formatter<boost::numeric::interval<double, P>> {
  bool hexadecimal = false;

  constexpr auto parse(std::format_parse_context& context) {
    auto at = context.begin();
    if (at != context.end() && *at == 'x') {
      hexadecimal = true;
      ++at;
    }
    if (at != context.end() && *at != '}')
      throw std::format_error("graze: an interval's format is empty or x");
    return at;
  }
  template <class Context>
  auto format(const boost::numeric::interval<double, P>& x, Context& context) const {
    auto out = context.out();
    for (const char c : graze::detail::to_text(x, hexadecimal))
      *out++ = c;
    return out;
  }
};
