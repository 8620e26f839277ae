// write_expectations FILE: hard operands and, by MPFR, the ten rounded results of each.
#include "expectations.hpp"
#include <cstdio>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/rounding.hpp>
#include <memory>
#include <string>

using namespace graze::test;
using graze::oracle::hard_operands, graze::oracle::hardness, graze::oracle::operands;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_expectations FILE\n");
    return 2;
  }
  // written beside and renamed: a file that is there is whole
  const std::string path = argv[1], partial = path + ".partial";
  constexpr std::size_t per_kind = 75'000;
  constexpr std::size_t control = 15'000; // of random bit patterns, with which little goes wrong
  std::size_t written = 0;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(partial.c_str(), "wb"),
                                                               std::fclose);
    if (!file) {
      std::fprintf(stderr, "cannot write %s\n", partial.c_str());
      return 2;
    }
    hard_operands make(20051);
    for (int kind = 0; kind < static_cast<int>(hardness::count); ++kind) {
      const auto h = static_cast<hardness>(kind);
      for (std::size_t i = 0; i < (h == hardness::none ? control : per_kind); ++i) {
        const operands p = make.next(h);
        expectation e{p.x, p.y, {}};
        all_operations<graze::oracle::mpfr>(p.x, p.y, e.results);
        written += std::fwrite(&e, sizeof e, 1, file.get());
      }
    }
    if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0) {
      std::fprintf(stderr, "cannot write %s\n", partial.c_str());
      return 2;
    }
  }
  if (std::rename(partial.c_str(), path.c_str()) != 0) {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    return 2;
  }
  std::printf("%zu operand pairs, %zu of them hard, 10 operations by MPFR\n", written,
              written - control);
}
