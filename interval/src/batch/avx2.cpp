// The path avx2, compiled with its instructions.
#include "kernels.hpp"
#include <graze/batch/avx2.hpp>

namespace graze::batch::detail {
constinit const table avx2_table = make_table<avx2>();
} // namespace graze::batch::detail
