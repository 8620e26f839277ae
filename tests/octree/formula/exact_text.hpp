#pragma once
/// The polynomial that a text means, along a ray, in rational numbers: a second reading of the grammar,
/// of + - * / ^ and numbers alone.
#include <cctype>
#include <gmpxx.h>
#include <graze/octree/ray.hpp>
#include <graze/oracle/polynomial.hpp>
#include <stdexcept>
#include <string>

namespace judge {

class exact_text {
public:
  explicit exact_text(std::string text) : text_(std::move(text)) {}

  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    reader<N> r{text_, {x, y, z}, 0};
    const N value = r.sum();
    if (r.at != text_.size())
      throw std::invalid_argument(text_);
    return value;
  }

private:
  template <class N> struct reader {
    const std::string& text;
    N variables[3];
    std::size_t at;

    [[nodiscard]] char peek() const { return at < text.size() ? text[at] : '\0'; }
    bool accept(char c) {
      if (peek() != c)
        return false;
      ++at;
      return true;
    }
    N sum() {
      const bool negative = accept('-');
      N r = product();
      if (negative)
        r = N(0) - r;
      while (peek() == '+' || peek() == '-') {
        const bool minus = text[at++] == '-';
        const N next = product();
        r = minus ? r - next : r + next;
      }
      return r;
    }
    N product() {
      N r = power();
      while (peek() == '*' || peek() == '/') {
        const bool divides = text[at++] == '/';
        const N next = power();
        r = divides ? r / next : r * next;
      }
      return r;
    }
    N power() {
      const N base = primary();
      if (!accept('^'))
        return base;
      N r(1);
      int n = 0;
      while (std::isdigit(static_cast<unsigned char>(peek())) != 0)
        n = 10 * n + (text[at++] - '0');
      for (; n > 0; --n)
        r = r * base;
      return r;
    }
    N primary() {
      if (accept('(')) {
        const N r = sum();
        accept(')');
        return r;
      }
      if (peek() >= 'x' && peek() <= 'z')
        return variables[text[at++] - 'x'];
      mpq_class value = 0;
      mpz_class scale = 1;
      bool point = false;
      for (; std::isdigit(static_cast<unsigned char>(peek())) != 0 || peek() == '.'; ++at) {
        if (text[at] == '.') {
          point = true;
          continue;
        }
        value = value * 10 + (text[at] - '0');
        if (point)
          scale *= 10;
      }
      if (accept('e')) {
        const bool minus = accept('-');
        int n = 0;
        while (std::isdigit(static_cast<unsigned char>(peek())) != 0)
          n = 10 * n + (text[at++] - '0');
        for (; n > 0; --n)
          minus ? void(scale *= 10) : void(value *= 10);
      }
      return N(mpq_class(value / scale));
    }
  };

  std::string text_;
};

} // namespace judge
