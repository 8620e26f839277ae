// CGAL's Interval_nt, protected and not. It has no functions.
#include <CGAL/Interval_nt.h>

#include "measure.hpp"

namespace graze::bench {

namespace {
template <bool protect> struct library {
  using number = CGAL::Interval_nt<protect>;
  static number constant(double lower, double upper) { return {std::min(lower, upper), upper}; }
  static void assign(number& x, const ends& e) { x = number(e.lower, e.upper); }
  static enclosure enclosed(const number& x) { return {x.inf(), x.sup()}; }
};
struct protecting : library<true> {
  static constexpr const char* name = "CGAL";
  struct scope {
    scope() {}
  };
};
struct not_protecting : library<false> {
  static constexpr const char* name = "CGAL unprotected";
  using scope = CGAL::Protect_FPU_rounding<true>;
};
} // namespace

void measure_cgal() {
  measure_arithmetic<not_protecting>();
  measure_arithmetic<protecting>();
}

} // namespace graze::bench
