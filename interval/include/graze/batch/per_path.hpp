#pragma once
/// What is compiled once for each path, and the choice among it at run time.
///
/// graze_paths (cmake/graze_target.cmake) compiles a source for each path, with its instructions.
/// Within such a source graze::batch::this_path is the path's type, and GRAZE_ON_PATH(name) is
/// name_baseline, name_avx2 or name_avx512: the one symbol that the path's object gives away.
///
///   // kernels.cpp, by graze_paths
///   constinit const table GRAZE_ON_PATH(kernels) = make_table<batch::this_path>();
///   // the header that everybody includes
///   GRAZE_DECLARE_ON_PATHS(table, kernels);
///   // who chooses
///   const table& k = GRAZE_ALL_PATHS(table, kernels).on(batch::path_in_use());
#include <graze/needs_cxx20.hpp>

#include <graze/batch.hpp>

namespace graze::batch {

/// A constant of the type T for each path, of which only addresses are held: nothing of a path's
/// object runs before the path has been chosen. Where a build has no such path, the baseline.
template <class T> struct per_path {
  const T *baseline, *avx2, *avx512;

  [[nodiscard]] constexpr const T& on(path p) const {
    return *(p == path::avx512 ? avx512 : p == path::avx2 ? avx2 : baseline);
  }
};

} // namespace graze::batch

#if defined(__x86_64__)
#define GRAZE_DECLARE_ON_PATHS(type, name)                                                         \
  extern const type name##_baseline, name##_avx2, name##_avx512
#define GRAZE_ALL_PATHS(type, name)                                                                \
  ::graze::batch::per_path<type> { &name##_baseline, &name##_avx2, &name##_avx512 }
#else
#define GRAZE_DECLARE_ON_PATHS(type, name) extern const type name##_baseline
#define GRAZE_ALL_PATHS(type, name)                                                                \
  ::graze::batch::per_path<type> { &name##_baseline, &name##_baseline, &name##_baseline }
#endif

// Set by graze_paths.
#if defined(GRAZE_PATH_HEADER)
#include GRAZE_PATH_HEADER
#define GRAZE_JOINED_ON_PATH(name, path) name##_##path
#define GRAZE_EXPANDED_ON_PATH(name, path) GRAZE_JOINED_ON_PATH(name, path)
#define GRAZE_ON_PATH(name) GRAZE_EXPANDED_ON_PATH(name, GRAZE_PATH)
namespace graze::batch {
using this_path = GRAZE_PATH_TYPE;
}
#endif
