#pragma once
/// The judge of the surface tests: formulas over MPFR, and hard random numbers.
#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <graze/octree/box.hpp>
#include <random>

namespace judge {

/// 600 bits: exact for the surfaces' polynomials at the points of the tests, but for the one
/// constant 139/20, which no double can meet.
using real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<180>,
                                           boost::multiprecision::et_off>;

/// The exact sign of f at a point.
template <class F> int sign_at(const F& f, const graze::octree::vec3& p) {
  const real v = f(real(p[0]), real(p[1]), real(p[2]));
  return v.sign();
}

struct random_source {
  std::mt19937_64 engine;
  explicit random_source(std::uint64_t seed) : engine(seed) {}
  double in(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine); }
  unsigned below(unsigned n) { return static_cast<unsigned>(engine() % n); }
};

/// A point of the box: often at its faces, edges and vertices.
inline graze::octree::vec3 some_point(random_source& random, const graze::octree::box& b) {
  graze::octree::vec3 p;
  for (int a = 0; a < 3; ++a) {
    const unsigned where = random.below(4);
    p[a] = where == 0   ? b.lo[a]
           : where == 1 ? b.hi[a]
                        : std::clamp(random.in(b.lo[a], b.hi[a]), b.lo[a], b.hi[a]);
  }
  return p;
}
} // namespace judge
