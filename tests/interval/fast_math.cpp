// Must not compile with -ffast-math; see CMakeLists.txt.
#include <graze/rounding/nearest.hpp>
