// The kernels of batches, compiled for each path.
#include "kernels.hpp"
#include <graze/batch/per_path.hpp>

namespace graze::batch::detail {
constinit const table GRAZE_ON_PATH(kernels) = make_table<this_path>();
} // namespace graze::batch::detail
