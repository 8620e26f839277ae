// Another translation unit; with -flto the optimizer sees it too.
#include "snippets.hpp"

namespace graze::barriers {
double far_literal() { return 0.1; }
double far_product(double x, double y) { return x * y; }
} // namespace graze::barriers
