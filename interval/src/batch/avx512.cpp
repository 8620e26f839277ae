// The path avx512, compiled with its instructions.
#include "kernels.hpp"
#include <graze/batch/avx512.hpp>

namespace graze::batch::detail {
constinit const table avx512_table = make_table<avx512>();
} // namespace graze::batch::detail
