// The path that needs no instruction but those that every machine of the kind has.
#include "kernels.hpp"
#if defined(__x86_64__)
#include <graze/batch/sse2.hpp>
#else
#include <graze/batch/portable.hpp>
#endif

namespace graze::batch::detail {
#if defined(__x86_64__)
constinit const table baseline_table = make_table<sse2>();
#else
constinit const table baseline_table = make_table<portable>();
#endif
} // namespace graze::batch::detail
