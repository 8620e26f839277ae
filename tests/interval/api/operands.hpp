#pragma once
// The file that write_api_expected makes: pairs of operands and what each statement gives of them.
#include <cstdint>
#include <cstdio>
#include <vector>

namespace graze::api {

struct ends {
  double lower, upper; ///< of the empty set NaN; of a truth 0 or 1 twice
};
struct pair_of_operands {
  ends x, y;
};

struct expectations {
  std::vector<pair_of_operands> operands;
  std::vector<ends> expected; ///< statement by statement, operands.size() each
};

inline bool write(const char* path, const expectations& e) {
  std::FILE* file = std::fopen(path, "wb");
  if (file == nullptr)
    return false;
  const std::uint64_t sizes[] = {e.operands.size(), e.expected.size()};
  bool good = std::fwrite(sizes, sizeof sizes, 1, file) == 1;
  good &= std::fwrite(e.operands.data(), sizeof(pair_of_operands), sizes[0], file) == sizes[0];
  good &= std::fwrite(e.expected.data(), sizeof(ends), sizes[1], file) == sizes[1];
  return std::fclose(file) == 0 && good;
}
inline bool read(const char* path, expectations& e) {
  std::FILE* file = std::fopen(path, "rb");
  if (file == nullptr)
    return false;
  std::uint64_t sizes[2];
  bool good = std::fread(sizes, sizeof sizes, 1, file) == 1;
  if (good) {
    e.operands.resize(sizes[0]), e.expected.resize(sizes[1]);
    good &= std::fread(e.operands.data(), sizeof(pair_of_operands), sizes[0], file) == sizes[0];
    good &= std::fread(e.expected.data(), sizeof(ends), sizes[1], file) == sizes[1];
  }
  std::fclose(file);
  return good;
}

} // namespace graze::api
