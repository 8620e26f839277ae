#include "target.hpp"
#include <cstdio>
#include <cstdlib>

namespace graze::fuzz::target {

void wrong(std::string_view why) {
  std::fprintf(stderr, "wrong: %.*s\n", static_cast<int>(why.size()), why.data());
  std::abort();
}

} // namespace graze::fuzz::target
