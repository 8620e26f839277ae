#pragma once
/// What the fuzz targets have in common. A target is LLVMFuzzerTestOneInput, which ends the process
/// by wrong() where a property does not hold, and seeds(). It is linked to a fuzzing engine, and in
/// every build to replay_main.cpp, so that it is compiled and run with the tests.
#include <cstddef>
#include <cstdint>
#include <generate/random.hpp>
#include <span>
#include <string>
#include <string_view>
#include <trial/codec.hpp>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// libFuzzer's, where it is linked
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                      std::size_t max_size);

namespace graze::fuzz::target {

/// Where a corpus begins; the same in every build.
std::vector<std::string> seeds();

/// A property does not hold: says so on stderr and aborts, which every engine takes for a finding.
[[noreturn]] void wrong(std::string_view why);

inline void require(bool holds, std::string_view why) {
  if (!holds)
    wrong(why);
}

inline std::string text_of(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}

} // namespace graze::fuzz::target
