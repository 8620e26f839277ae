#pragma once
/// Which paths of batches and lanes a test runs on, and what it says of those that do not run here.
#include <catch2/catch.hpp>
#include <cstdio>
#include <graze/batch.hpp>

namespace graze::test {

/// Whether the path runs here. Says so if it does not; ctest then counts all of the entry as
/// skipped, whatever else it finds: for entries of one path.
inline bool runs(batch::path p) {
  const auto reason = batch::refusal(p);
  if (reason)
    std::printf("graze: skipped, path %s: %s\n", batch::name(p), reason->c_str());
  return !reason;
}

/// Calls check(path) for each path that runs here. Says once which do not, in words that leave
/// ctest the verdict on those that do.
template <class Check> void for_each_path(Check check) {
  static bool reported = false;
  for (const batch::path p : batch::paths) {
    if (const auto reason = batch::refusal(p)) {
      if (!reported)
        std::printf("graze: path %s skipped: %s\n", batch::name(p), reason->c_str());
      continue;
    }
    INFO(batch::name(p));
    check(p);
  }
  reported = true;
}

} // namespace graze::test

/// An entry for each path, "before: baseline, after" and so on: function(path), where it runs.
#define GRAZE_TEST_EACH_PATH(before, after, tags, function)                                        \
  TEST_CASE(before ": baseline, " after, tags) {                                                   \
    if (graze::test::runs(graze::batch::path::baseline))                                           \
      function(graze::batch::path::baseline);                                                      \
  }                                                                                                \
  TEST_CASE(before ": avx2, " after, tags) {                                                       \
    if (graze::test::runs(graze::batch::path::avx2))                                               \
      function(graze::batch::path::avx2);                                                          \
  }                                                                                                \
  TEST_CASE(before ": avx512, " after, tags) {                                                     \
    if (graze::test::runs(graze::batch::path::avx512))                                             \
      function(graze::batch::path::avx512);                                                        \
  }
